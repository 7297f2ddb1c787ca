// Reports to the engine which curve is likely to be dragged next: the one under the pointer, or the selected
// one.
import { effect, type Signal } from "@preact/signals";
import type { CurvePlace, Engine, EngineStatus } from "../engine/types.js";
import type { Handle, Selection } from "../model/types.js";

/** How long the pointer must rest on a curve, milliseconds. */
const REST = 100;

interface Pointing {
  readonly engine: Engine;
  readonly hovered: Signal<Handle | null>;
  readonly selection: Signal<Selection>;
  readonly status: Signal<EngineStatus>;
}

/** @param placeOf a curve of the text that is shown, or null where it has none */
export function expectDrags(
  { engine, hovered, selection, status }: Pointing,
  placeOf: (handle: Handle) => CurvePlace | null,
): void {
  let timer = 0;
  const tell = (handle: Handle | null) => engine.expect(handle === null ? null : placeOf(handle));
  effect(() => {
    const selected = selection.value;
    const handle = hovered.value ?? (selected.length === 1 ? selected[0].handle : null);
    clearTimeout(timer);
    // What was prepared is no more once a picture was made; and numbers may be other ones.
    if (status.value.kind === "exact") timer = setTimeout(tell, REST, handle) as never;
  });
}
