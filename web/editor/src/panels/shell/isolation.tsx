// The bar above the stage while a layer is isolated.
import { Icon } from "../../icons.js";
import * as en from "../../strings/en.js";
import { useTip } from "../controls/button.js";
import { useShell } from "../services.js";

const words = en.panels;

export function Isolation() {
  const { editor } = useShell();
  const tip = useTip(words.leaveIsolation, "isolate");
  const handle = editor.isolated.value;
  const item = handle === null ? undefined : editor.drawing.item(handle);
  if (!item) return null;
  const leave = () => {
    editor.isolate(null);
    // The button goes, and the keys are the stage's.
    document.querySelector<HTMLElement>(".canvas-stage")?.focus({ preventScroll: true });
  };
  return (
    <div class="isolation">
      <Icon name="layers" small />
      <span>{words.isolated(item.name)}</span>
      <button type="button" class="button" {...tip} onClick={leave}>
        {words.leave}
      </button>
    </div>
  );
}
