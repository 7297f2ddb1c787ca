// Which stop of a curve is chosen.
import type { Editor } from "../../app/types.js";
import type { Attribute, CurveItem, Side } from "../../model/types.js";

export interface ChosenStop {
  readonly side: Side;
  readonly index: number;
}

/** The primary stop of an attribute that is selected on a curve, or null. */
export function chosenStop(
  editor: Editor,
  item: CurveItem,
  attribute: Attribute | "radius",
): ChosenStop | null {
  const found = [...editor.selection.value]
    .reverse()
    .find(
      ({ handle, part }) =>
        handle === item.handle && part.kind === "stop" && part.attribute === attribute,
    );
  return found?.part.kind === "stop" ? { side: found.part.side, index: found.part.index } : null;
}

/** The selected stops of one side, ascending: the side of the primary one. Returns null if none is selected. */
export function chosenStops(
  editor: Editor,
  item: CurveItem,
  attribute: Attribute | "radius",
): { readonly side: Side; readonly indices: readonly number[] } | null {
  const primary = chosenStop(editor, item, attribute);
  if (!primary) return null;
  const indices = editor.selection.value.flatMap(({ handle, part }) =>
    handle === item.handle && part.kind === "stop" && part.attribute === attribute && part.side === primary.side
      ? [part.index]
      : [],
  );
  return { side: primary.side, indices: indices.sort((a, b) => a - b) };
}

/** Selects a stop beside others of its side, or deselects it. */
export function toggleStop(
  editor: Editor,
  item: CurveItem,
  attribute: Attribute | "radius",
  { side, index }: ChosenStop,
) {
  const chosen = chosenStops(editor, item, attribute);
  const before = chosen?.side === side ? chosen.indices : [];
  const now = before.includes(index) ? before.filter((other) => other !== index) : [...before, index];
  const { handle } = item;
  editor.selection.value =
    now.length > 0
      ? now.map((each) => ({ handle, part: { kind: "stop", side, attribute, index: each } }))
      : [{ handle, part: { kind: "whole" } }];
}

export function chooseStop(
  editor: Editor,
  item: CurveItem,
  attribute: Attribute | "radius",
  { side, index }: ChosenStop,
) {
  editor.selection.value = [
    { handle: item.handle, part: { kind: "stop", side, attribute, index } },
  ];
}
