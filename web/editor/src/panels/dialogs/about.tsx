// What this is.
import { en } from "../../strings/en.js";
import { Wordmark } from "../welcome/wordmark.js";
import { useShell } from "../services.js";
import { Frame } from "./frame.js";

const words = en.dialogs;

export function AboutDialog() {
  const { services } = useShell();
  return (
    <Frame title={en.panels.about} class="small">
      <div class="dialog-body form">
        <Wordmark />
        <p class="read">{words.aboutText}</p>
        <p class="read muted">{words.version(services.version)}</p>
        <p class="read muted">{words.licences}</p>
      </div>
    </Frame>
  );
}
