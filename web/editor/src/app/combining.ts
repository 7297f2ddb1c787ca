// Commands that combine the regions of closed curves.
import { EngineError } from "../engine/rpc.js";
import type { RegionOperation } from "../engine/types.js";
import { canCombine, replaceByRegion, shapePaths } from "../model/commands/index.js";
import * as en from "../strings/en.js";
import type { DrawingEditor } from "./editor.js";
import { chosenCurves } from "./selected.js";

type Command = (editor: DrawingEditor) => void;

const words = en.commands;

/** A share of the artboard's longer side: the accuracy of crossings. */
const TOLERANCE = 1 / 16384;

/** Combines the selected closed curves into the lowest one, which keeps its colours. */
async function combine(editor: DrawingEditor, operation: RegionOperation): Promise<void> {
  const chosen = new Set(chosenCurves(editor));
  const { drawing } = editor;
  const { revision } = drawing;
  const curves = [...drawing.all()].filter((item) => item.kind === "curve" && chosen.has(item));
  const closed = curves.filter(canCombine);
  if (closed.length < 2 || closed.length < curves.length) return editor.say(words.combineWantsTwo);
  const [x0, y0, x1, y1] = drawing.artboard;
  const tolerance = TOLERANCE * Math.max(x1 - x0, y1 - y0);
  const paths = closed.map((item) => shapePaths(drawing, item));
  const data = await editor.engine.combinePaths(operation, paths, tolerance);
  // Another edit came in between.
  if (editor.drawing !== drawing || drawing.revision !== revision) return;
  if (data === "") return editor.say(words.nothingLeft);
  const [first, ...others] = closed;
  const gone = others.map(({ handle }) => handle);
  const made = replaceByRegion(drawing, first.handle, data, gone, editor.step(first));
  if (editor.run(words.combine[operation], made)) editor.selection.value = [{ handle: first.handle, part: { kind: "whole" } }];
}

const command =
  (operation: RegionOperation): Command =>
  (editor) =>
    editor.awaitEdit(
      combine(editor, operation).catch((error: unknown) => editor.say(EngineError.of(error).reason)),
    );

const operations: readonly RegionOperation[] = ["unite", "subtract", "intersect", "exclude"];

export const combining = operations.map((operation) => [`shapes-${operation}`, command(operation)] as const);
