// The right column: what is selected above, layers below, a line between them.
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import * as en from "../../strings/en.js";
import { Resizer } from "../controls/resizer.js";
import { useShell } from "../services.js";
import { Inspector, LayersPanel } from "./part.js";

const words = en.panels;
/** Least heights of the two parts, CSS pixels. */
const LEAST = 180;

/**
 * The selection determines the height of the upper part. While the pointer is on the layers the height stays:
 * rows must not move away under the pointer that presses them.
 */
function useHold(upper: { current: HTMLDivElement | null }) {
  const held = useSignal<number | null>(null);
  const hold = () => {
    held.value ??= upper.current?.offsetHeight ?? null;
  };
  const release = () => {
    held.value = null;
  };
  const leave = (event: PointerEvent) => {
    if (event.buttons === 0) release();
    else window.addEventListener("pointerup", release, { once: true });
  };
  return {
    height: held.value,
    events: { onPointerEnter: hold, onPointerDownCapture: hold, onPointerLeave: leave },
  };
}

export function Side() {
  const { panelWidth } = useShell().editor.settings;
  /** Height of the upper part; null: as high as what it holds. */
  const split = useSignal<number | null>(null);
  const side = useRef<HTMLElement>(null);
  const upper = useRef<HTMLDivElement>(null);
  const hold = useHold(upper);
  const fixed = split.value ?? hold.height;
  const height = split.value ?? upper.current?.offsetHeight ?? LEAST;
  return (
    <aside class="side panel" aria-label={words.panels} ref={side}>
      <Resizer
        kind="column"
        label={words.panelsWidth}
        value={panelWidth.value}
        min={240}
        max={480}
        sign={-1}
        onChange={(width) => {
          panelWidth.value = width;
        }}
      />
      <div
        class={fixed === null ? "inspector" : "inspector set"}
        ref={upper}
        data-region
        style={fixed === null ? undefined : { "--split": `${fixed}px` }}
      >
        <Inspector />
      </div>
      <Resizer
        kind="line"
        label={words.panelsSplit}
        value={height}
        min={LEAST}
        max={Math.max((side.current?.offsetHeight ?? 800) - LEAST, LEAST)}
        sign={1}
        onChange={(to) => {
          split.value = to;
        }}
        onReset={() => {
          split.value = null;
        }}
      />
      <LayersPanel {...hold.events} />
    </aside>
  );
}
