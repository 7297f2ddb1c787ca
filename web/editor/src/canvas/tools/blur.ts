// Blur: pull it away from the curve.
import type { CurveItem } from "../../model/types.js";
import type { Canvas } from "../canvas.js";
import { standing } from "../along.js";
import { blurCursor, type CursorName } from "../cursors.js";
import { stageFromItem } from "../marks.js";
import { editedAt } from "../places.js";
import { addStop, beside, dragStop, pullBlur, type OnSide } from "./stops.js";
import type { Drag, Press, Tool } from "./tool.js";

/** How far from the selected curve a drag still means it, CSS pixels. */
const REACH = 40;

export class BlurTool implements Tool {
  constructor(private readonly canvas: Canvas) {}

  hover(p: Press): CursorName {
    const { canvas } = this;
    const { mark, curve } = canvas.hover(p.at, p.kind);
    if (mark?.kind === "bracket") return blurCursor(Math.atan2(mark.normal[1], mark.normal[0]));
    const on = this.under(p);
    if (!on) return curve ? "stop" : "default";
    const map = stageFromItem(canvas.stageFromArtboard(), on.item);
    const { normal } = standing(on.item.paths[on.path], map, on.at, 1);
    return blurCursor(Math.atan2(normal[1], normal[0]));
  }

  press(p: Press): Drag | null {
    const { canvas } = this;
    const { editor } = canvas;
    const mark = canvas.markAt(p.at, p.kind);
    if (mark?.kind === "bracket") {
      editor.selection.value = [{ handle: mark.handle, part: mark.part }];
      return dragStop(canvas, mark, p);
    }
    const hit = canvas.curveAt(p.at, p.kind);
    const owner = hit && editedAt(hit.place);
    if (owner && owner.handle !== canvas.primaryCurve()?.handle) {
      editor.selection.value = [{ handle: owner.handle, part: { kind: "whole" } }];
    }
    if (hit && owner !== hit.place.item) return null;
    const on = this.under(p);
    if (!on) {
      if (!hit) editor.selection.value = [];
      return null;
    }
    if (p.clicks >= 2) {
      void addStop(canvas, on, on.item.kind === "stroke" ? "radius" : "blur");
      return null;
    }
    return pullBlur(canvas, on, p);
  }

  private under(p: Press): OnSide | null {
    const item: CurveItem | null = this.canvas.primaryCurve();
    if (!item || item.paths.length === 0) return null;
    const on = beside(this.canvas, item, p);
    return on.distance <= REACH ? on : null;
  }
}
