// Sample: along a curve both sides take the photo's colours; from a stop it is an eyedropper.
import type { Gesture } from "../../app/types.js";
import { composed, IDENTITY, inverted, lengthScale, type Box } from "../../geometry/affine.js";
import { pieceCount, type CubicPath } from "../../geometry/cubic.js";
import { setColor, together } from "../../model/commands/index.js";
import type { CurveItem, Drawing, Outcome } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { nearestAt, pathInLayer } from "../along.js";
import { placeBounds } from "../box.js";
import type { Canvas } from "../canvas.js";
import type { CursorName } from "../cursors.js";
import { setSide } from "../edits.js";
import { outermostLayer, type CurveHit } from "../hit.js";
import { stageFromItem } from "../marks.js";
import { photoOf, photoToTrace, type PlacedPhoto } from "../photo.js";
import { editedAt, isCurve, placesOf, type Reach } from "../places.js";
import { sampledSides, type SampledSides } from "../sampled.js";
import { SIDES } from "../sides.js";
import { NO_SKETCH } from "../sketch.js";
import { Lens } from "./lens.js";
import { PickDrag } from "./pick.js";
import { isBeyond, type Drag, type Press, type Tool } from "./tool.js";

/** Between samples, CSS pixels. */
const SPACING = 2;

export class SampleTool implements Tool {
  private readonly lens: Lens;

  constructor(private readonly canvas: Canvas) {
    this.lens = new Lens(canvas);
  }

  hover(p: Press): CursorName {
    this.lens.look(p, this.canvas.hover(p.at, p.kind).curve);
    return "sample";
  }

  leave(): void {
    this.lens.close();
  }

  press(p: Press): Drag | null {
    const { canvas } = this;
    const { editor } = canvas;
    const mark = canvas.markAt(p.at, p.kind);
    if (mark?.kind === "stop" && mark.attribute === "color") {
      editor.selection.value = [{ handle: mark.handle, part: mark.part }];
      return new PickDrag(canvas, mark, p, this.lens);
    }
    const hit = canvas.curveAt(p.at, p.kind);
    if (!hit) {
      editor.selection.value = [];
      return null;
    }
    const owner = editedAt(hit.place);
    editor.selection.value = [{ handle: owner.handle, part: { kind: "whole" } }];
    if (owner !== hit.place.item) return null;
    const reference = photoToTrace(editor.drawing, canvas.toArtboard(p.at));
    if (!reference) {
      editor.say(en.tools.noPhoto);
      return null;
    }
    return new SampleDrag(canvas, hit, p, photoOf(reference), this.lens);
  }
}

/** Along a curve, from where it was pressed; a click takes all of it. */
class SampleDrag implements Drag {
  readonly cursor = "sample";
  private photo: PlacedPhoto | null = null;
  private gesture: Gesture | null = null;
  private low: number;
  private high: number;
  private isOver = false;

  constructor(
    private readonly canvas: Canvas,
    private readonly hit: CurveHit,
    private readonly start: Press,
    private readonly loading: Promise<PlacedPhoto | null>,
    private readonly lens: Lens,
  ) {
    lens.look(start, hit);
    this.low = hit.at;
    this.high = hit.at;
    void loading.then((photo) => {
      this.photo = photo;
      if (!photo) canvas.editor.say(en.tools.photoUnread);
      else if (!this.isOver && this.gesture) this.show();
    });
  }

  move(p: Press): void {
    const { canvas, hit } = this;
    this.lens.look(p, this.hitAt(p));
    if (!this.gesture) {
      if (!isBeyond(this.start.at, p.at)) return;
      this.gesture = canvas.editor.gesture(en.tools.undo.sample);
      canvas.draw({ isFaded: true });
    }
    const path = hit.place.item.paths[hit.path];
    const map = stageFromItem(canvas.stageFromArtboard(), hit.place.item);
    for (const { at } of p.trail) {
      const place = nearestAt(path, map, at).at;
      this.low = Math.min(this.low, place);
      this.high = Math.max(this.high, place);
    }
    this.show();
  }

  /** The place of the curve that a moment of the pointer means. */
  private hitAt({ at }: Press): CurveHit {
    const { hit, canvas } = this;
    const map = stageFromItem(canvas.stageFromArtboard(), hit.place.item);
    return { ...hit, at: nearestAt(hit.place.item.paths[hit.path], map, at).at };
  }

  private show(): void {
    const { photo } = this;
    if (photo) this.gesture?.show((before) => this.sampled(before, photo, [this.low, this.high]));
  }

  private sampled(
    drawing: Drawing,
    photo: PlacedPhoto,
    range: readonly [number, number],
  ): Outcome | null {
    const curve = drawing.item(this.hit.place.item.handle);
    if (!isCurve(curve) || !curve.paths[this.hit.path]) return null;
    const { isolated, settings, view } = this.canvas.editor;
    const pixel =
      1 /
      (view.peek().zoom *
        lengthScale(composed(curve.artboardFromItem, inverted(curve.layerFromItem) ?? IDENTITY)));
    const values = sampledSides(photo, curve, this.hit.path, {
      distance: settings.sampleDistance.peek(),
      tolerance: settings.sampleTolerance.peek(),
      spacing: SPACING * pixel,
      blurs: settings.sampleBlur.peek(),
      others: neighbours({ drawing, isolated }, curve),
      range,
    });
    const colors = SIDES.map((side) => {
      const value = values[side];
      return value && setColor(drawing, curve.handle, side, value);
    });
    return together([...colors, ...(values.blur ? blurring(drawing, curve, values.blur) : [])]);
  }

  end(): void {
    this.lens.close();
    this.isOver = true;
    const { gesture } = this;
    // The photo may still be on its way.
    const sampled = this.loading.then((photo) => {
      this.canvas.sketch.value = NO_SKETCH;
      if (gesture) {
        this.show();
        gesture.keep();
      } else if (photo) this.sampleAll(photo);
    });
    this.canvas.editor.awaitEdit(sampled);
  }

  private sampleAll(photo: PlacedPhoto): void {
    const { editor } = this.canvas;
    const item = editor.drawing.item(this.hit.place.item.handle);
    if (!isCurve(item) || !item.paths[this.hit.path]) return;
    const all = [0, pieceCount(item.paths[this.hit.path])] as const;
    editor.run(en.tools.undo.sample, this.sampled(editor.drawing, photo, all));
  }

  cancel(): void {
    this.lens.close();
    this.isOver = true;
    this.gesture?.drop();
    this.canvas.sketch.value = NO_SKETCH;
  }
}

/** Both sides' blur: as one where it is the same. */
function blurring(
  drawing: Drawing,
  curve: CurveItem,
  { left, right }: NonNullable<SampledSides["blur"]>,
): (Outcome | null)[] {
  if (JSON.stringify(left) === JSON.stringify(right))
    return [setSide(drawing, curve, "left", "blur", left, true)];
  return [
    setSide(drawing, curve, "left", "blur", left),
    setSide(drawing, curve, "right", "blur", right),
  ];
}

/** Curves of the same layer that may come between a curve and its samples, in the layer's frame. */
function neighbours(reach: Reach, curve: CurveItem): CubicPath[] {
  const layer = outermostLayer(curve);
  const [x0, y0, x1, y1] = boundsOfCurve(curve);
  return placesOf(reach)
    .filter(({ item, owner }) => owner === item && item !== curve && outermostLayer(item) === layer)
    .filter(({ item }) => {
      const [a0, b0, a1, b1] = boundsOfCurve(item);
      return a0 <= x1 && a1 >= x0 && b0 <= y1 && b1 >= y0;
    })
    .flatMap(({ item }) => item.paths.map((path) => pathInLayer(item, path)));
}

function boundsOfCurve(item: CurveItem): Box {
  return placeBounds({ item, owner: item, artboardFromItem: item.artboardFromItem });
}
