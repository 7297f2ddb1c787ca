// The guides above the picture.
import { mapped, type Affine, type Point } from "../../geometry/affine.js";
import type { GuideAxis, Guideline } from "../../model/guidelines.js";
import type { Canvas } from "../canvas.js";
import type { Sketch } from "../sketch.js";
import { chosenGuide } from "./chosen.js";

interface Size {
  readonly width: number;
  readonly height: number;
}

const straight = (axis: GuideAxis, at: number, { width, height }: Size) =>
  axis === 0 ? `M${at.toFixed(2)} 0V${height}` : `M0 ${at.toFixed(2)}H${width}`;

/** A slanted guide from beyond one edge of the stage to beyond another. */
function slanted([x, y]: Point, [a, b]: Point, { width, height }: Size): string {
  const [mx, my] = [width / 2, height / 2];
  const away = a * (x - mx) + b * (y - my);
  const reach = Math.hypot(width, height);
  if (Math.abs(away) > reach) return "";
  const [fx, fy] = [mx + a * away, my + b * away];
  return `M${fx - b * reach} ${fy + a * reach}L${fx + b * reach} ${fy - a * reach}`;
}

function lineOf({ axis, point, normal }: Guideline, map: Affine, stage: Size): string {
  const at = mapped(map, point);
  if (axis === null) return slanted(at, normal, stage);
  const isSeen = at[axis] >= 0 && at[axis] <= (axis === 0 ? stage.width : stage.height);
  return isSeen ? straight(axis, at[axis], stage) : "";
}

function Line({ data, name }: { readonly data: string; readonly name: string }) {
  if (data === "") return null;
  return (
    <>
      <path class="page-guide-rim" d={data} />
      <path class={name} d={data} />
    </>
  );
}

export function GuideLines({
  canvas,
  map,
  dragged,
}: {
  readonly canvas: Canvas;
  readonly map: Affine;
  readonly dragged: Sketch["guide"];
}) {
  const { shown, all } = canvas.guidelines.value;
  const stage = canvas.editor.stage.value;
  const chosen = chosenGuide(canvas);
  const rest = shown ? all.filter((guide) => guide !== chosen && guide.handle !== dragged?.of) : [];
  // A file may have thousands: lines at one place are drawn once.
  const lines = new Set(rest.map((guide) => lineOf(guide, map, stage)));
  const isLoose = dragged !== null && dragged.at !== null;
  return (
    <>
      <Line name="page-guide" data={[...lines].join("")} />
      {chosen && !dragged && <Line name="page-guide-on" data={lineOf(chosen, map, stage)} />}
      {isLoose && <Line name="page-guide-on" data={straight(dragged.axis, dragged.at, stage)} />}
    </>
  );
}
