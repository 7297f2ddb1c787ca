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
