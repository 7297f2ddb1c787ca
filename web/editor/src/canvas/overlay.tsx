// Everything drawn above the picture: one <svg> in CSS pixels of the stage.
import { useComputed } from "@preact/signals";
import { lengthScale, type Affine, type Point } from "../geometry/affine.js";
import * as en from "../strings/en.js";
import { drawnBox, selectionBox } from "./box.js";
import type { Canvas } from "./canvas.js";
import { Aids, DraftView, Light, matrix, Strong } from "./drafts.js";
import { DifferenceImage, DifferenceLegend } from "./difference.js";
import { LoupeView } from "./loupe-view.js";
import { GuideLines } from "./guides/lines.js";
import { MarkView } from "./mark.js";
import { bandOf, stageFromItem, type Mark } from "./marks.js";
import { outlineOf, selectedPlaces } from "./outline.js";
import { paintOutline, shownPaints } from "./paint-marks.js";
import { Photos } from "./photos.js";
import { placesOf } from "./places.js";
import { isSamePart } from "./part.js";
import type { Sketch } from "./sketch.js";
import { gridStep } from "./snap.js";
import { kindOn, SIDES, stopsOf } from "./sides.js";
import { Tags } from "./tags.js";
import { keyOf } from "./walk.js";

/** Marks are so much larger for fingers. */
const COARSE = 1.35;
/** More curves than these have one line each: rims and dashes would cost frames. */
const MANY = 400;

const polyline = (points: readonly Point[]) =>
  `M${points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join(" ")}`;

export function Overlay({ canvas }: { readonly canvas: Canvas }) {
  const { editor } = canvas;
  const map = canvas.stageFromArtboard();
  const sketch = canvas.sketch.value;
  const isHiding = editor.hideHandles.value;
  const isCoarse = typeof matchMedia === "function" && matchMedia("(pointer: coarse)").matches;
  return (
    <>
      <svg
        class="overlay canvas-overlay"
        role="group"
        aria-label={labelOf(canvas)}
        style={`--zoom:${isCoarse ? 1 / COARSE : 1}`}
      >
        {editor.showReference.value && <Photos canvas={canvas} map={map} below={false} />}
        <DifferenceImage canvas={canvas} map={map} />
        {editor.settings.grid.value && <Grid canvas={canvas} map={map} />}
        <Artboard canvas={canvas} map={map} />
        {!isHiding && <GuideLines canvas={canvas} map={map} dragged={sketch.guide} />}
        {editor.showOutlines.value && <AllOutlines canvas={canvas} map={map} />}
        {!isHiding && <Handles canvas={canvas} map={map} sketch={sketch} />}
        {sketch.draft && <DraftView draft={sketch.draft} map={map} />}
        <Aids sketch={sketch} />
      </svg>
      <DifferenceLegend editor={editor} />
      <Tags canvas={canvas} map={map} sketch={sketch} />
      {sketch.loupe && <LoupeView loupe={sketch.loupe} stage={editor.stage.value} />}
    </>
  );
}

function labelOf(canvas: Canvas): string {
  const { editor } = canvas;
  const selection = editor.selection.value;
  const last = selection.at(-1);
  const item = last && editor.drawing.item(last.handle);
  if (!item) return en.canvas.name;
  if (editor.tool.value !== "select") return en.canvas.handlesOf(item.name);
  return selection.length > 1
    ? en.canvas.boxOfSeveral(selection.length)
    : en.canvas.boxOf(item.name);
}

function Artboard({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const [x0, y0, x1, y1] = canvas.editor.drawing.artboard;
  return (
    <rect
      class="artboard-edge"
      x={x0 * map[0] + map[4]}
      y={y0 * map[3] + map[5]}
      width={(x1 - x0) * map[0]}
      height={(y1 - y0) * map[3]}
    />
  );
}

/** The lines that points snap to. */
function Grid({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const step = gridStep(map[0], canvas.editor.settings.gridUnit.value) * map[0];
  const [x, y] = [map[4] % step, map[5] % step];
  return (
    <>
      <pattern id="grid" patternUnits="userSpaceOnUse" x={x} y={y} width={step} height={step}>
        <path class="grid-rim" d={`M0 ${step}V0H${step}`} />
        <path class="grid-line" d={`M0 ${step}V0H${step}`} />
      </pattern>
      <rect width="100%" height="100%" style={{ fill: "url(#grid)" }} />
    </>
  );
}

function AllOutlines({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const { editor } = canvas;
  const data = useComputed(() => {
    const places = placesOf(editor);
    return { path: outlineOf(places), isMany: places.length > MANY };
  });
  const { path, isMany } = data.value;
  return (
    <g transform={matrix(map)}>
      {isMany ? <path class="curve-hover" d={path} /> : <Light data={path} />}
    </g>
  );
}

function Handles({
  canvas,
  map,
  sketch,
}: {
  readonly canvas: Canvas;
  readonly map: Affine;
  readonly sketch: Sketch;
}) {
  const marks = canvas.marks.value;
  const isDragged = (mark: Mark) =>
    sketch.dragged !== null &&
    sketch.dragged.handle === mark.handle &&
    isSamePart(sketch.dragged.part, mark.part);
  const rest = sketch.isFaded ? marks.filter((mark) => !isDragged(mark)) : marks;
  return (
    <>
      <g class={sketch.isFaded ? "handles faded" : "handles"}>
        <Curves canvas={canvas} map={map} />
        <SelectionBox canvas={canvas} map={map} />
        <Bands canvas={canvas} map={map} />
        <Paints canvas={canvas} map={map} />
        {rest.map((mark) => (
          <HandleLine key={keyOf(mark)} mark={mark} />
        ))}
        {rest.map((mark) => (
          <MarkView key={keyOf(mark)} mark={mark} />
        ))}
      </g>
      {sketch.isFaded &&
        marks.filter(isDragged).map((mark) => (
          <g key={keyOf(mark)}>
            <HandleLine mark={mark} />
            <MarkView mark={mark} />
          </g>
        ))}
    </>
  );
}

function Curves({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const { editor } = canvas;
  const selected = useComputed(() => {
    const handles = new Set(editor.selection.value.map(({ handle }) => handle));
    const found = selectedPlaces(placesOf(editor), handles);
    const isMany = found.selected.length + found.within.length > MANY;
    return { own: outlineOf(found.selected), within: outlineOf(found.within), isMany };
  });
  const hovered = useComputed(() => {
    const over = editor.hovered.value;
    const isSelected = editor.selection.value.some(({ handle }) => handle === over);
    if (over === null || isSelected) return "";
    return outlineOf(placesOf(editor).filter(({ owner }) => owner.handle === over));
  });
  const { own, within, isMany } = selected.value;
  return (
    <g transform={matrix(map)}>
      {isMany ? <path class="curve-hover" d={own + within} /> : <Light data={within} />}
      {!isMany && own !== "" && <Strong data={own} />}
      <Light data={hovered.value} />
    </g>
  );
}

function SelectionBox({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const { editor } = canvas;
  if (editor.tool.value !== "select") return null;
  const box = selectionBox(editor);
  if (!box) return null;
  const [x0, y0, x1, y1] = drawnBox(box, map);
  const sides = { x: x0, y: y0, width: x1 - x0, height: y1 - y0 };
  return (
    <>
      <rect class="box-rim" {...sides} />
      <rect class="box" {...sides} />
    </>
  );
}

/** The edges of the blur, or of a local curve's radius, on both sides of the primary curve. */
function Bands({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const tool = canvas.editor.tool.value;
  const item = canvas.primaryCurve();
  const kind = item && kindOn(item, canvas.attribute());
  if (
    !item ||
    (kind !== "blur" && kind !== "radius") ||
    (tool !== "nodes" && tool !== "blur" && tool !== "sample")
  )
    return null;
  const own = stageFromItem(map, item);
  if (!(lengthScale(own) > 0)) return null;
  const edges = SIDES.flatMap((side) => {
    const list = stopsOf(item, side, kind);
    return list ? item.paths.map((path) => polyline(bandOf(item, path, own, side, list))) : [];
  }).join("");
  return edges === "" ? null : (
    <>
      <path class="band-rim" d={edges} />
      <path class="band" d={edges} />
    </>
  );
}

/** The circles and tiles of the primary curve's paints. */
function Paints({ canvas, map }: { readonly canvas: Canvas; readonly map: Affine }) {
  const { editor } = canvas;
  const item = canvas.primaryCurve();
  const attribute = canvas.attribute();
  if (!item || attribute === "blur" || editor.tool.value !== "nodes") return null;
  const own = stageFromItem(map, item);
  const data = shownPaints(editor.drawing, item, attribute)
    .map((paint) => paintOutline(paint, own))
    .join("");
  return data === "" ? null : (
    <>
      <path class="band-rim" d={data} />
      <path class="band" d={data} />
    </>
  );
}

/** From a node to its handle, from the curve to a bracket, from the box to what turns it. */
function HandleLine({ mark }: { readonly mark: Mark }) {
  if (mark.kind === "node" || mark.kind === "stop" || mark.kind === "scale") return null;
  const ends = { x1: mark.foot[0], y1: mark.foot[1], x2: mark.at[0], y2: mark.at[1] };
  return (
    <>
      <line class="thin-rim" {...ends} />
      <line class={mark.kind === "bracket" ? "dash" : "thin"} {...ends} />
    </>
  );
}
