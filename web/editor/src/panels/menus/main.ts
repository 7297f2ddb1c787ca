// Menus of ☰, the canvas, the rows and the zoom button.
import { isolatedBy, isPrimaryClosed, primaryItem } from "../../app/selected.js";
import type { Editor } from "../../app/types.js";
import { closedCurves, curvesOf } from "../../model/commands/index.js";
import { areLocked, guidelinesOf } from "../../model/guidelines.js";
import * as en from "../../strings/en.js";
import type { MenuItem } from "../controls/menu.js";

const words = en.panels;

const file = (): readonly MenuItem[] => [
  { label: words.asks(words.new), command: "new" },
  { label: words.asks(words.open), command: "open" },
  "line",
  { label: words.save, command: "save" },
  { label: words.asks(words.saveAs), command: "save-as" },
  { label: words.asks(words.export), command: "export" },
  "line",
  { label: words.placePhoto, command: "place-photo" },
  { label: words.tracePhoto, command: "trace-photo" },
  { label: words.document, command: "document" },
  { label: words.asks(words.recover), command: "recover" },
  "line",
  { label: words.home, command: "welcome" },
];

const clipboard = (editor: Editor): readonly MenuItem[] => {
  const nothing = editor.selection.value.length === 0;
  return [
    { label: words.cut, command: "cut", disabled: nothing },
    { label: words.copy, command: "copy", disabled: nothing },
    { label: words.paste, command: "paste" },
    { label: words.duplicate, command: "duplicate", disabled: nothing },
    { label: words.delete, command: "delete", disabled: nothing },
  ];
};

const edit = (editor: Editor): readonly MenuItem[] => {
  const undo = editor.undoLabel.value;
  const redo = editor.redoLabel.value;
  return [
    {
      label: undo === null ? words.undo : words.undoOf(undo),
      command: "undo",
      disabled: undo === null,
    },
    {
      label: redo === null ? words.redo : words.redoOf(redo),
      command: "redo",
      disabled: redo === null,
    },
    "line",
    ...clipboard(editor),
    "line",
    { label: words.selectAll, command: "select-all" },
  ];
};

/** Returns the menu of the photo that lies on the drawing. */
export function photo(editor: Editor): readonly MenuItem[] {
  const { drawing, selection } = editor;
  const isThere = [...drawing.all()].some(({ kind, hidden }) => kind === "reference" && !hidden);
  const chosen = curvesOf(drawing, selection.value).length > 0;
  const needsPhoto = { disabled: !isThere, reason: words.needsPhoto };
  return [
    { label: words.colorsFromPhoto, command: "colors-from-photo", ...needsPhoto },
    { label: words.blurFromPhoto, command: "blur-from-photo", ...needsPhoto },
    {
      label: words.snapToPhoto,
      command: "snap-to-photo",
      disabled: !isThere || !chosen,
      reason: isThere ? words.needsCurve : words.needsPhoto,
    },
    "line",
    {
      label: words.difference,
      command: "difference",
      checked: editor.showDifference.value,
      ...needsPhoto,
    },
  ];
}

const combinations: readonly MenuItem[] = (["unite", "subtract", "intersect", "exclude"] as const).map(
  (operation) => ({ label: words.combine[operation], command: `shapes-${operation}` }),
);

/** Returns the menu that aligns, distributes and flips the selection. */
function aligning(editor: Editor): readonly MenuItem[] {
  const count = new Set(editor.selection.value.map(({ handle }) => handle)).size;
  const nothing = count === 0;
  const few = { disabled: count < 3, reason: words.needsThree };
  return [
    { label: words.alignLeft, command: "align-left", disabled: nothing },
    { label: words.alignCenter, command: "align-center", disabled: nothing },
    { label: words.alignRight, command: "align-right", disabled: nothing },
    { label: words.alignTop, command: "align-top", disabled: nothing },
    { label: words.alignMiddle, command: "align-middle", disabled: nothing },
    { label: words.alignBottom, command: "align-bottom", disabled: nothing },
    {
      label: words.alignToArtboard,
      command: "align-to-artboard",
      checked: editor.settings.alignToArtboard.value,
    },
    "line",
    { label: words.distributeHorizontally, command: "distribute-horizontally", ...few },
    { label: words.distributeVertically, command: "distribute-vertically", ...few },
    "line",
    { label: words.flipHorizontal, command: "flip-horizontal", disabled: nothing },
    { label: words.flipVertical, command: "flip-vertical", disabled: nothing },
  ];
}

function isolation(editor: Editor): MenuItem {
  if (editor.isolated.value !== null) return { label: words.leaveIsolation, command: "isolate" };
  const isThere = isolatedBy(primaryItem(editor)) !== null;
  return { label: words.isolate, command: "isolate", disabled: !isThere, reason: words.needsLayer };
}

/** Returns the menu of the selection, by its kind. */
export function object(editor: Editor): readonly MenuItem[] {
  const chosen = editor.selection.value.map(({ handle }) => editor.drawing.item(handle));
  const has = (...kinds: string[]) => chosen.some((item) => item && kinds.includes(item.kind));
  const nothing = chosen.length === 0;
  const noCurve = !has("curve", "stroke");
  const hasNode = editor.selection.value.some(({ part }) => part.kind === "node");
  return [
    { label: words.group, command: "group", disabled: nothing },
    { label: words.ungroup, command: "ungroup", disabled: !has("group", "layer") },
    isolation(editor),
    { label: words.bringUp, command: "bring-up", disabled: nothing },
    { label: words.sendDown, command: "send-down", disabled: nothing },
    { label: words.toTop, command: "to-top", disabled: nothing },
    { label: words.toBottom, command: "to-bottom", disabled: nothing },
    "line",
    { label: words.oneColor, command: "one-color", disabled: noCurve },
    {
      label: words.ownShape,
      command: "own-shape",
      disabled: closedCurves(editor.drawing, editor.selection.value.map(({ handle }) => handle)).length === 0,
      reason: words.needsClosed,
    },
    { label: words.swapSides, command: "swap-sides", disabled: noCurve },
    { label: words.reverse, command: "reverse", disabled: noCurve },
    {
      label: isPrimaryClosed(editor) ? words.openCurve : words.close,
      command: "close-curve",
      disabled: noCurve,
    },
    { label: words.join, command: "join", disabled: chosen.length !== 2 || noCurve },
    { label: words.cutCurve, command: "cut-curve", disabled: !hasNode, reason: words.needsNode },
    { label: words.simplify, command: "simplify", disabled: noCurve },
    "line",
    { label: words.paletteFromSelection, command: "add-to-palette", disabled: noCurve },
    { label: words.copyStyle, command: "copy-style", disabled: noCurve },
    {
      label: words.pasteStyle,
      command: "paste-style",
      disabled: noCurve || !editor.copiedStyle.value,
      reason: noCurve ? words.needsCurve : words.needsStyle,
    },
    "line",
    { label: words.combineShapes, items: combinations },
    { label: words.align, items: aligning(editor) },
    {
      label: words.makeInstance,
      command: "make-instance",
      disabled: !has("group", "layer", "use"),
    },
    { label: words.makeUnique, command: "make-unique", disabled: !has("use") },
  ];
}

const zooms: readonly MenuItem[] = [
  { label: words.zoomIn, command: "zoom-in" },
  { label: words.zoomOut, command: "zoom-out" },
  { label: words.zoomFit, command: "zoom-fit" },
  { label: words.zoomSelection, command: "zoom-selection" },
  { label: words.zoomActual, command: "zoom-actual" },
];

/** Returns the menu of the guides, which the file holds. */
function guides(editor: Editor): readonly MenuItem[] {
  const { shown, all } = guidelinesOf(editor.drawing);
  const none = { disabled: all.length === 0, reason: words.needsGuide };
  return [
    { label: words.asks(words.guides), command: "guides" },
    { label: words.showGuides, command: "show-guides", checked: shown, ...none },
    { label: words.lockGuides, command: "lock-guides", checked: areLocked(all), ...none },
    { label: words.removeGuides, command: "remove-guides", ...none },
  ];
}

const view = (editor: Editor): readonly MenuItem[] => [
  ...zooms,
  "line",
  { label: words.outlines, command: "outlines", checked: editor.showOutlines.value },
  { label: words.exactPixels, command: "exact-pixels", checked: editor.exactState.value.kind !== "off" },
  { label: words.mesh, command: "mesh", checked: editor.showMesh.value },
  { label: words.reference, command: "reference", checked: editor.showReference.value },
  { label: words.grid, command: "grid", checked: editor.settings.grid.value },
  { label: words.rulers, command: "rulers", checked: editor.settings.rulers.value },
  { label: words.guides, items: guides(editor) },
  { label: words.snap, command: "snap", checked: editor.settings.snap.value },
  "line",
  {
    label: words.theme,
    items: (["system", "light", "dark"] as const).map((theme) => ({
      label: words.themes[theme],
      checked: editor.settings.theme.value === theme,
      run: () => {
        editor.settings.theme.value = theme;
      },
    })),
  },
];

const help = (): readonly MenuItem[] => [
  { label: words.asks(words.commands), command: "commands" },
  { label: words.keys, command: "keys" },
  { label: words.tour, command: "tour" },
  { label: words.about, command: "about" },
];

/** Tools that have no place in the row of a phone. */
const hiddenTools = (editor: Editor): readonly MenuItem[] =>
  (["stroke", "rectangle", "polygon", "hand"] as const).map((tool) => ({
    label: words.tool[tool],
    checked: editor.tool.value === tool,
    run: () => {
      editor.tool.value = tool;
    },
  }));

export function mainMenu(editor: Editor, isPhone: boolean): readonly MenuItem[] {
  return [
    { label: words.file, items: file() },
    { label: words.edit, items: edit(editor) },
    { label: words.object, items: object(editor) },
    { label: words.photo, items: photo(editor) },
    { label: words.view, items: view(editor) },
    ...(isPhone ? [{ label: words.tools, items: hiddenTools(editor) }] : []),
    "line",
    ...help(),
  ];
}

export const zoomMenu = (): readonly MenuItem[] => zooms;

/** On the canvas, and on what is selected there. */
export function contextMenu(editor: Editor): readonly MenuItem[] {
  return [...clipboard(editor), "line", { label: words.photo, items: photo(editor) }, ...object(editor)];
}
