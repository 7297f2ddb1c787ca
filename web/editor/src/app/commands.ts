// The commands that menus and keys name.
import type { Point } from "../geometry/affine.js";
import {
  addLayer,
  closedCurves,
  curvesOf,
  deleteItems,
  deleteNodes,
  duplicate,
  group,
  joinCurves,
  makeInstance,
  makeUnique,
  restack,
  reverseCurves,
  setClosed,
  setNodeKind,
  shapesOfTheirOwn,
  swapSides,
  ungroup,
  type NodeKind,
} from "../model/commands/index.js";
import { boxOf } from "../model/item-boxes.js";
import type { Attribute, Drawing, Handle, Item, Outcome } from "../model/types.js";
import * as en from "../strings/en.js";
import { arranging } from "./arranging.js";
import { combining } from "./combining.js";
import { copyByMenu } from "./clipboard.js";
import { addToPalette, copyStyle, cutAtNodes, pasteCopiedStyle, simplify } from "./curves.js";
import { currentColor } from "./colors.js";
import type { DrawingEditor } from "./editor.js";
import { guiding } from "./guiding.js";
import { takeInHandle } from "./handles.js";
import { deleteStop, oneColor } from "./stops.js";
import { chosen, chosenCurves, chosenItems, chosenNodes, chosenStop, isolatedBy, isPrimaryClosed, primaryCurve, primaryItem } from "./selected.js";
import type { ToolName } from "./types.js";

type Command = (editor: DrawingEditor) => void;

/** How far copies stand from what they copy, artboard units: 16 pixels. */
const copyOffset = (editor: DrawingEditor): Point => {
  const by = 16 / editor.view.value.zoom;
  return [by, by];
};

/** A command on what is selected, as one step of undo. */
function edit(
  label: string,
  make: (drawing: Drawing, handles: readonly Handle[], editor: DrawingEditor) => Outcome | null,
): Command {
  return (editor) => {
    const handles = chosen(editor);
    if (handles.length > 0) editor.run(label, make(editor.drawing, handles, editor));
  };
}

function stack(label: string, steps: number): Command {
  return edit(label, (drawing, handles) => restack(drawing, handles, steps));
}

function nodeKind(label: string, kind: NodeKind): Command {
  return (editor) => {
    const curve = primaryCurve(editor);
    if (!curve) return;
    const nodes = chosenNodes(editor);
    editor.run(label, setNodeKind(editor.drawing, curve.handle, nodes, kind, editor.step(curve)));
  };
}

/** The chosen handle, stop or nodes, else whole items. */
function deleteChosen(editor: DrawingEditor) {
  const primary = editor.selection.value.at(-1);
  if (primary?.part.kind === "handle") return takeInHandle(editor, primary.handle, primary.part);
  const curve = primaryCurve(editor);
  const stop = chosenStop(editor);
  const nodes = chosenNodes(editor);
  const { drawing } = editor;
  if (curve && stop) {
    if (editor.run(en.commands.deleteStop, deleteStop(drawing, curve, stop))) {
      editor.selection.value = [{ handle: curve.handle, part: { kind: "whole" } }];
    }
  } else if (curve && nodes.size > 0) {
    const made = deleteNodes(drawing, curve.handle, nodes, editor.step(curve));
    if (editor.run(en.commands.deleteNode, made) && drawing.item(curve.handle)) {
      editor.selection.value = [{ handle: curve.handle, part: { kind: "whole" } }];
    }
  } else {
    deleteWhole(editor);
  }
}

function deleteWhole(editor: DrawingEditor) {
  const handles = chosen(editor);
  const done = editor.run(en.commands.delete, deleteItems(editor.drawing, handles));
  if (done) editor.say(en.commands.deleted(handles.length), { label: en.commands.undo, run: () => editor.undo() });
}

/** Gives the selected stop's side, or all sides of the selected curves, one colour. */
function giveOneColor(editor: DrawingEditor) {
  const stop = chosenStop(editor);
  const curves = chosenCurves(editor);
  const made = oneColor(editor.drawing, curves, stop?.attribute === "color" ? stop : null);
  if (!made) return editor.say(words.noColors);
  editor.run(words.oneColor, made);
  const whole = { kind: "whole" } as const;
  editor.selection.value = curves.map(({ handle }) => ({ handle, part: whole }));
}

function makeShapes(editor: DrawingEditor) {
  const { drawing, settings } = editor;
  const handles = chosen(editor);
  if (closedCurves(drawing, handles).length === 0) return editor.say(words.needsClosed);
  const made = shapesOfTheirOwn(drawing, handles, currentColor(settings));
  if (made) editor.run(words.ownShape, made);
  else editor.say(words.isShape);
}

function joinChosen(editor: DrawingEditor) {
  const curves = chosenCurves(editor);
  if (curves.length !== 2) return editor.say(en.commands.joinWantsTwo);
  const [a, b] = curves;
  editor.run(en.commands.join, joinCurves(editor.drawing, a.handle, b.handle, editor.step(a)));
}

function closeChosen(editor: DrawingEditor) {
  const curve = primaryCurve(editor);
  if (!curve) return;
  const isClosed = isPrimaryClosed(editor);
  const all = curve.paths.map((_, path) => path);
  const made = setClosed(editor.drawing, curve.handle, all, !isClosed, editor.step(curve));
  editor.run(isClosed ? en.commands.open : en.commands.close, made);
}

function selectAll(editor: DrawingEditor) {
  const layer = editor.activeLayer;
  const isFree = (item: Item) => !item.locked && !item.hidden;
  const inLayer = layer?.children.filter(isFree) ?? [];
  const handles = new Set(chosen(editor));
  // Once all of the layer is selected, the next step is the whole drawing, or the isolated part of it.
  const isMore = handles.size > 0 && inLayer.some(({ handle }) => !handles.has(handle));
  const { drawing, isolated } = editor;
  const all = isolated.value === null ? drawing.items : drawing.item(isolated.value)?.children;
  const within = isMore ? inLayer : (all ?? []).filter(isFree);
  editor.selection.value = within
    .map(({ handle }) => ({ handle, part: { kind: "whole" } }));
}

/** Isolates the layer of the selection, or the group where no layer is around it; or ends the isolation. */
function toggleIsolation(editor: DrawingEditor) {
  if (editor.isolated.value !== null) return editor.isolate(null);
  const item = isolatedBy(primaryItem(editor));
  if (!item) return editor.say(words.isolateWantsLayer);
  editor.isolate(item.handle);
  if (editor.isolated.value === null) editor.say(words.isolateWantsSeen);
}

function zoomToSelection(editor: DrawingEditor) {
  const box = boxOf(chosenItems(editor));
  if (box) editor.navigation.fit(box);
}

function toTool(tool: ToolName): Command {
  return (editor) => {
    editor.tool.value = tool;
  };
}

function showing(attribute: Attribute): Command {
  return (editor) => {
    editor.attribute.value = attribute;
  };
}

type Switch = "showMesh" | "showOutlines" | "showReference" | "hideHandles" | "hintsShown";

function toggle(name: Switch): Command {
  return (editor) => {
    editor[name].value = !editor[name].value;
  };
}

function toggleExact({ exactState, settings }: DrawingEditor) {
  settings.exactPixels.value = exactState.value.kind === "off" ? "on" : "off";
}

function cycleTheme({ settings: { theme } }: DrawingEditor) {
  const isDark = matchMedia("(prefers-color-scheme: dark)").matches;
  const now = theme.value === "system" ? (isDark ? "dark" : "light") : theme.value;
  theme.value = now === "dark" ? "light" : "dark";
}

const words = en.commands;
const ZOOM = 1.5;

const tools: readonly ToolName[] = ["select", "nodes", "pen", "pencil", "stroke", "rectangle", "ellipse", "polygon", "sample", "blur", "hand"];

const table: readonly (readonly [string, Command])[] = [
  ...tools.map((tool) => [`tool-${tool}`, toTool(tool)] as const),
  ["undo", (editor) => editor.undo()],
  ["redo", (editor) => editor.redo()],
  ["cut", (editor) => void copyByMenu(editor, true)],
  ["copy", (editor) => void copyByMenu(editor, false)],
  ["duplicate", edit(words.duplicate, (d, handles, editor) => duplicate(d, handles, copyOffset(editor)))],
  ["delete", deleteChosen],
  ["select-all", selectAll],
  ["deselect", (editor) => void (editor.selection.value = [])],
  ["group", edit(words.group, group)],
  ["ungroup", edit(words.ungroup, ungroup)],
  ["bring-up", stack(words.bringUp, 1)],
  ["send-down", stack(words.sendDown, -1)],
  ["to-top", stack(words.toTop, Infinity)],
  ["to-bottom", stack(words.toBottom, -Infinity)],
  ["new-layer", (editor) => void editor.run(words.newLayer, addLayer(editor.drawing, editor.selection.value.at(-1)?.handle ?? null, ""))],
  ["swap-sides", edit(words.swapSides, (d, _, editor) => swapSides(d, curvesOf(d, editor.selection.value)))],
  ["one-color", giveOneColor],
  ["own-shape", makeShapes],
  ["reverse", edit(words.reverse, (d, _, editor) => reverseCurves(d, curvesOf(d, editor.selection.value), editor.step(null)))],
  ["close-curve", closeChosen],
  ["cut-curve", cutAtNodes],
  ["simplify", simplify],
  ["add-to-palette", addToPalette],
  ["copy-style", copyStyle],
  ["paste-style", pasteCopiedStyle],
  ["join", joinChosen],
  ["make-instance", edit(words.makeInstance, (d, [handle], editor) => makeInstance(d, handle, copyOffset(editor)))],
  ["make-unique", edit(words.makeUnique, (d, [handle]) => makeUnique(d, handle))],
  ["corner", nodeKind(words.nodeKind, "corner")],
  ["smooth", nodeKind(words.nodeKind, "smooth")],
  ["symmetric", nodeKind(words.nodeKind, "symmetric")],
  ...arranging,
  ...combining,
  ...guiding,
  ["zoom-in", (editor) => editor.zoomBy(ZOOM)],
  ["zoom-out", (editor) => editor.zoomBy(1 / ZOOM)],
  ["zoom-fit", ({ navigation }) => navigation.fit()],
  ["zoom-selection", zoomToSelection],
  ["zoom-actual", ({ navigation }) => navigation.showActualSize()],
  ["exact-pixels", toggleExact],
  ["mesh", toggle("showMesh")],
  ["outlines", toggle("showOutlines")],
  ["isolate", toggleIsolation],
  ["reference", toggle("showReference")],
  ["hide-handles", toggle("hideHandles")],
  ["hints", toggle("hintsShown")],
  ["grid", ({ settings: { grid } }) => void (grid.value = !grid.value)],
  ["snap", ({ settings: { snap } }) => void (snap.value = !snap.value)],
  ["theme", cycleTheme],
  ["show-color", showing("color")],
  ["show-opacity", showing("opacity")],
  ["show-blur", showing("blur")],
  ["welcome", (editor) => void (editor.welcome.value = true)],
  ["tour", (editor) => void (editor.tour.value = 0)],
  ...(["commands", "export", "keys", "new", "recover", "about", "document", "guides"] as const).map(
    (kind) => [kind, (editor: DrawingEditor) => void (editor.dialog.value = { kind })] as const,
  ),
];

/** Returns the commands of this table and `more`, the page's commands for files, photos and pasting. */
export function commandTable(more: readonly (readonly [string, Command])[]): ReadonlyMap<string, Command> {
  return new Map([...table, ...more]);
}
