// About this program, and the work by others in it.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import * as en from "../../strings/en.js";
import { Wordmark } from "../welcome/wordmark.js";
import { useShell } from "../services.js";
import { Frame } from "./frame.js";

const words = en.dialogs;

type All = typeof import("virtual:licences").default;

/** null: they are on their way, or did not come. */
function useLicences(): All | null {
  const licences = useSignal<All | null>(null);
  useEffect(() => {
    import("virtual:licences").then(
      ({ default: all }) => {
        licences.value = all;
      },
      () => undefined,
    );
  }, []);
  return licences.value;
}

function Licences({ all: [own, ...others] }: { readonly all: All }) {
  const names = others.map(({ name, licence }) => (licence ? `${name} (${licence})` : name));
  return (
    <>
      <p class="read muted">{words.madeWith(own.licence ?? "", names)}</p>
      <details class="licences">
        <summary>{words.licences}</summary>
        <div class="licence-texts" tabIndex={0} role="region" aria-label={words.licences}>
          {[own, ...others].map(({ name, text }) => (
            <section key={name}>
              <h3>{name}</h3>
              <pre>{text}</pre>
            </section>
          ))}
        </div>
      </details>
    </>
  );
}

export function AboutDialog() {
  const { services } = useShell();
  const all = useLicences();
  return (
    <Frame title={en.panels.about} class="small">
      <div class="dialog-body form">
        <Wordmark />
        <p class="read">{words.aboutText}</p>
        <p class="read muted">{words.version(services.version)}</p>
        {all && <Licences all={all} />}
      </div>
    </Frame>
  );
}
