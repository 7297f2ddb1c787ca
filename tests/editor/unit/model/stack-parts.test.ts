// Finds layers and groups of the document in the stack of the picture.
import { expect, test } from "vitest";
import type { Editor } from "../../../../web/editor/src/app/types.js";
import { itemAt, lookOf, partsOf, type StackItem } from "../../../../web/editor/src/canvas/stack-parts.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";

const text = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 9 9">
  <defs><path id="shape" d="M0 0L1 1"/></defs>
  <g id="back" sf:diffuse="true"><path d="M0 0L9 9" sf:left="#fff"/></g>
  <g id="copies" sf:diffuse="true"><use href="#shape"/></g>
  <g id="empty" sf:diffuse="true"/>
  <g id="flat" sf:diffuse="true" transform="scale(0)"><path d="M0 0L9 9" sf:left="#fff"/></g>
  <g id="hidden" sf:diffuse="true" display="none"><path d="M0 0L9 9" sf:left="#fff"/></g>
  <g id="group" opacity=".5"><g id="in" sf:diffuse="true"><path d="M0 0L9 9" sf:left="#fff"/></g><path id="brush" d="M0 0L9 9" sf:radius="1" sf:left="#fff"/></g>
  <use id="again" href="#group"/>
</svg>`;

const layer = (number: number): StackItem => ({
  kind: "instance",
  layer: number,
  artboardFromLayer: [1, 0, 0, 1, 0, 0],
  opacity: 1,
  blend: 0,
});
const begin: StackItem = { kind: "begin", opacity: 0.5, blend: 0 };
const end: StackItem = { kind: "end" };
const column = () => new Float32Array([1, 2]);
const stroke = (): StackItem => ({
  kind: "stroke",
  artboardFromStroke: [1, 0, 0, 1, 0, 0],
  origin: [0, 0],
  alpha: 1,
  twoSided: false,
  segments: {
    count: 2,
    nodeCount: new Uint32Array(2),
    coefficient: [column()],
    start: [column()],
    attribute: [column()],
  },
});

/** The engine's indices of layers by name; it does not know other layers. */
const numbers: Readonly<Record<string, number>> = { back: 0, in: 2 };

const editorOf = () =>
  ({ drawing: openDrawing(text), engineLayer: ({ name }: { name: string }) => numbers[name] ?? null }) as unknown as Editor;

function parts(stack: readonly StackItem[]) {
  const found = partsOf(editorOf(), stack);
  return found && Object.fromEntries([...found].map(([item, part]) => [item.name, part]));
}

const once = () => [begin, layer(2), stroke(), end];
/** The engine keeps layers without curves, and drops layers that are flattened to nothing. */
const stack = [layer(0), layer(1), layer(9), ...once(), ...once()];

test("layers, those of copies alone, and groups have their parts of the stack", () => {
  const found = parts(stack)!;
  expect(Object.keys(found).sort()).toEqual(["back", "copies", "empty", "group", "in"]);
  expect(found.back).toEqual({ items: [stack[0]], layers: [0] });
  expect(found.copies).toEqual({ items: [stack[1]], layers: [1] });
  expect(found.empty).toEqual({ items: [stack[2]], layers: [9] });
  expect(found.in).toEqual({ items: [stack[4]], layers: [2] });
  expect(found.group).toEqual({ items: [stack[4], stack[5]], layers: [2] });
});

test("a stack of another text has no parts", () => {
  expect(parts(stack.slice(1))).toBeNull();
  expect(parts([layer(1), ...stack.slice(1)])).toBeNull();
  expect(parts([stroke(), ...stack.slice(1)])).toBeNull();
  expect(parts([])).toBeNull();
});

test("each item of the stack has the element that put it there", () => {
  const editor = editorOf();
  const names = stack.map((_, at) => itemAt(editor, stack, at)?.name ?? null);
  expect(names).toEqual(["back", "copies", "empty", "group", "in", "brush", null, "again", "again", "again", null]);
  expect(itemAt(editor, stack, stack.length)).toBeNull();
  expect(itemAt(editor, stack.slice(1), 0)).toBeNull();
});

test("a look tells strokes apart by their numbers, and items by their blending", () => {
  const other = stroke();
  if (other.kind === "stroke") other.segments.attribute[0][1] = 3;
  expect(lookOf([stroke()])).toBe(lookOf([stroke()]));
  expect(lookOf([other])).not.toBe(lookOf([stroke()]));
  expect(lookOf([layer(1)])).not.toBe(lookOf([layer(2)]));
});
