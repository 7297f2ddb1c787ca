// The panel of layers: its head, and the tree.
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { useShell } from "../services.js";
import { Tree } from "./tree.js";

const words = en.layers;

interface LayersPanelProps {
  readonly onPointerEnter?: () => void;
  readonly onPointerDownCapture?: () => void;
  readonly onPointerLeave?: (event: PointerEvent) => void;
}

export function LayersPanel(events: LayersPanelProps) {
  const { editor } = useShell();
  const nothing = editor.selection.value.length === 0;
  return (
    <section class="layers-panel" aria-label={words.title} data-region {...events}>
      <div class="section-head">
        <h2>{words.title}</h2>
        <IconButton small icon="plus" label={words.newLayer} command="new-layer" />
        <IconButton
          small
          icon="folder-plus"
          label={en.panels.group}
          command="group"
          disabled={nothing}
        />
        <IconButton
          small
          icon="trash-2"
          label={en.panels.delete}
          command="delete"
          disabled={nothing}
        />
      </div>
      {editor.drawing.items.length === 0 ? <p class="empty">{words.empty}</p> : <Tree />}
    </section>
  );
}
