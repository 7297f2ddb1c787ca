// Edits that would make the whole drawing invalid for the library are refused, with a reason.
import { describe, expect, it } from "vitest";
import { pasteText } from "../../../web/editor/src/app/clipboard.js";
import { DrawingEditor } from "../../../web/editor/src/app/editor.js";
import type { Engine } from "../../../web/editor/src/engine/types.js";
import { copyItems, deleteItems, moveInto } from "../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../web/editor/src/model/drawing.js";
import { faultOf } from "../../../web/editor/src/model/faults.js";
import type { Drawing, Outcome } from "../../../web/editor/src/model/types.js";
import { setAttribute, sf, valueOf } from "../../../web/editor/src/source/attributes.js";
import * as en from "../../../web/editor/src/strings/en.js";

const deaf = { index: { serial: -1, curves: [] }, show: () => 0, look: () => {}, expect: () => {} };
const svg = (inner: string) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 100 100">${inner}</svg>`;
const layer = '<g id="l" sf:diffuse="true"><path id="c" d="M1 1L9 9" sf:left="red"/></g>';
const stroke = '<path id="s" d="M1 1L9 9" sf:radius="3" sf:left="red"/>';

/** Returns nested instances; the last one shows the item with that id. */
const chainTo = (id: string, count: number) =>
  Array.from({ length: count }, (_, k) => `<use id="u${k}" href="#${k + 1 < count ? `u${k + 1}` : id}"/>`).join("");

const edited = (text: string) => new DrawingEditor(deaf as unknown as Engine, new Map(), text);

/** Writes an attribute of the element with an id. */
function written(editor: DrawingEditor, id: string, name: Parameters<typeof setAttribute>[2], value: string | null): Outcome {
  const { text, ids } = editor.drawing;
  return { patch: setAttribute(text, ids.get(id)!, name, value) };
}

/** Whole drawings, each with its fault. */
const TEXTS: readonly (readonly [string, string | null])[] = [
  [svg(layer + stroke), null],
  [svg(layer.replace("9 9", "9 1e8")), "far"],
  [svg(layer.replace("M1 1L9 9", "M9e6 0l9e6 0")), "far"],
  [svg(`<g transform="translate(2e7)">${layer}</g>`), "far"],
  [svg(`<g transform="scale(2e6)">${layer}</g>`), null],
  [svg(layer.replace('id="c"', 'transform="scale(2e6)"')), "far"],
  [svg(`<g transform="translate(9e6)"><g transform="translate(9e6)">${layer}</g></g>`), "far"],
  [svg(`${layer}<use href="#l" x="2e7"/>`), "far"],
  [svg(stroke.replace(' sf:left="red"', "")), "colorless stroke"],
  [svg(stroke.replace("left", "right")), null],
  [svg(`<g id="g">${layer}<use href="#g"/></g>`), "circle of instances"],
  [svg(`<g id="g">${layer}<use href="#h"/></g><g id="h"><use href="#g"/></g>`), "circle of instances"],
  [svg(`<g id="g">${layer}<use href="#l"/></g><use href="#g"/><use href="#g" x="9"/>`), null],
  // An empty drawing is not a fault.
  [svg('<g sf:diffuse="true"><path d="" sf:left="red"/><rect width="0" height="9" sf:left="red"/></g>'), null],
];

const faultIn = (text: string) => faultOf(openDrawing(text), { isStructural: true, touched: new Map() });

it.each(TEXTS)("of %s", (text, fault) => {
  expect(faultIn(text)).toBe(fault);
});

it("of instances of instances, however many", () => {
  const chain = chainTo("g", 9000);
  expect(faultIn(svg(`<g id="g">${layer}</g>${chain}`))).toBe(null);
  expect(faultIn(svg(`<g id="g">${layer}<use href="#u0"/></g>${chain}`))).toBe("circle of instances");
});

describe("an edit", () => {
  it("that reaches too far leaves the drawing as it was", () => {
    const editor = edited(svg(layer));
    const { text } = editor.drawing;
    expect(editor.run("move", written(editor, "c", "transform", "translate(0 1e8)"))).toBe(false);
    expect(editor.run("move", written(editor, "l", "transform", "scale(2e7)"))).toBe(false);
    expect(editor.drawing.text).toBe(text);
    expect(editor.undoLabel.value).toBe(null);
    expect(editor.toast.value?.text).toBe(en.commands.faults.far);
    expect(editor.run("move", written(editor, "c", "transform", "translate(0 1e6)"))).toBe(true);
  });

  it("by a gesture is taken back when the hand is lifted", () => {
    const editor = edited(svg(layer));
    const { text } = editor.drawing;
    const gesture = editor.gesture("move");
    gesture.show(() => written(editor, "c", "d", "M1 1L2e7 9"));
    gesture.keep();
    expect(editor.drawing.text).toBe(text);
    expect(editor.undoLabel.value).toBe(null);
    expect(editor.toast.value?.text).toBe(en.commands.faults.far);
  });

  it("that moves something leaves it selected", () => {
    const editor = edited(svg(`<g id="g">${layer}</g><use id="u" href="#g"/>`));
    const { text } = editor.drawing;
    const idsOfSelection = () =>
      editor.selection.value.map(({ handle }) => valueOf(editor.drawing.item(handle)!.element, "id"));
    const handleOf = (id: string) => editor.drawing.itemAt(editor.drawing.ids.get(id)!.range.start)!.handle;
    const intoCopied = (drawing: Drawing) => moveInto(drawing, [handleOf("u")], handleOf("g"), 0);
    editor.selection.value = [{ handle: handleOf("u"), part: { kind: "whole" } }];
    expect(editor.run("move", intoCopied(editor.drawing))).toBe(false);
    expect(idsOfSelection()).toEqual(["u"]);
    const gesture = editor.gesture("move");
    gesture.show(intoCopied);
    gesture.keep();
    expect(idsOfSelection()).toEqual(["u"]);
    expect(editor.drawing.text).toBe(text);
    expect(editor.file.value.isChanged).toBe(false);
  });

  it("by a gesture is none where the drawing may not be edited", () => {
    const editor = edited(`<!DOCTYPE svg [<!ENTITY a "b">]>${svg(layer)}`);
    const { text } = editor.drawing;
    const gesture = editor.gesture("move");
    gesture.show(() => written(editor, "c", "d", "M1 1L2 9"));
    gesture.keep();
    expect(editor.drawing.text).toBe(text);
    expect(editor.toast.value?.text).toBe(editor.drawing.readOnly);
  });

  it("leaves a stroke its colour", () => {
    const editor = edited(svg(stroke));
    expect(editor.run("delete stop", written(editor, "s", sf("left"), null))).toBe(false);
    expect(editor.toast.value?.text).toBe(en.commands.faults["colorless stroke"]);
  });

  it("puts no instance into what it copies: it is pasted on top of all", () => {
    const editor = edited(svg(`<g id="g">${layer}</g><use id="u" href="#g"/>`));
    const handleOf = (id: string) => editor.drawing.itemAt(editor.drawing.ids.get(id)!.range.start)!.handle;
    const copied = copyItems(editor.drawing, [handleOf("u")]);
    editor.run("delete", deleteItems(editor.drawing, [handleOf("u")]));
    editor.selection.value = [{ handle: handleOf("l"), part: { kind: "whole" } }];
    pasteText(editor, copied);
    expect(editor.drawing.items.map(({ kind }) => kind)).toEqual(["group", "use"]);
    expect(editor.toast.value).toBe(null);
    const use = editor.drawing.items[1].element;
    expect(editor.run("move", written(editor, "u", "href", "#u"))).toBe(false);
    expect(editor.drawing.text.slice(use.range.start)).toContain('href="#g"');
    expect(editor.toast.value?.text).toBe(en.commands.faults["circle of instances"]);
  });

  it("of a drawing that has such a fault is done", () => {
    const editor = edited(svg(`${layer}<g id="g"><use id="u" href="#g"/></g>`));
    expect(editor.run("move", written(editor, "c", "id", "d"))).toBe(true);
    expect(editor.run("take away", written(editor, "u", "href", null))).toBe(true);
    expect(editor.run("bring back", written(editor, "u", "href", "#g"))).toBe(false);
  });
});
