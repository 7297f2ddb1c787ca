// Reports to the engine which curves are likely to be dragged next: those under the pointer, or the selected
// ones.
import { effect, type Signal } from "@preact/signals";
import type { CurvePlace, Engine, EngineStatus, LayerCurves } from "../engine/types.js";
import type { Handle, Selection } from "../model/types.js";

/** How long the pointer must rest on a curve, milliseconds. */
const REST = 100;

interface Pointing {
  readonly engine: Engine;
  readonly hovered: Signal<Handle | null>;
  readonly selection: Signal<Selection>;
  readonly status: Signal<EngineStatus>;
}

/** Returns the elements that a drag from here would move: whole selected elements move together. */
function dragged(hovered: Handle | null, selection: Selection): readonly Handle[] {
  const whole = selection.filter(({ part }) => part.kind === "whole").map(({ handle }) => handle);
  if (hovered !== null) return whole.includes(hovered) ? whole : [hovered];
  return selection.length === 1 ? [selection[0].handle] : whole;
}

/** Groups curves of one layer. Returns null without curves, or if they are in several layers. */
function inOneLayer(places: readonly CurvePlace[]): LayerCurves | null {
  if (places.length === 0 || places.some(({ layer }) => layer !== places[0].layer)) return null;
  const curves = places.map(({ curve }) => curve).sort((a, b) => a - b);
  return { layer: places[0].layer, curves };
}

/** @param placesOf the curves of an element in the text that is shown */
export function expectDrags(
  { engine, hovered, selection, status }: Pointing,
  placesOf: (handle: Handle) => readonly CurvePlace[],
): void {
  let timer = 0;
  const tell = (handles: readonly Handle[]) => engine.expect(inOneLayer(handles.flatMap(placesOf)));
  effect(() => {
    const handles = dragged(hovered.value, selection.value);
    clearTimeout(timer);
    // What was prepared is no more once a picture was made; and numbers may be other ones.
    if (status.value.kind === "exact") timer = setTimeout(tell, REST, handles) as never;
  });
}
