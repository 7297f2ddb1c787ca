// Rulers along the upper and the left edge of the stage, in units of the drawing.
import type { Canvas } from "../canvas.js";
import { numberText } from "../../geometry/path.js";
import { roundStep } from "../snap.js";
import { RULER } from "./drag.js";

/** Labels are at least so far apart, CSS pixels. */
const LABEL_GAP = 64;
/** More labels than a stage has. */
const MOST_LABELS = 400;
/** Lengths of ticks: with a label, and between. */
const LONG = 10;
const SHORT = 5;
/** Between two labels so many parts, by the first digit of their distance. */
const PARTS: Readonly<Record<string, number>> = { 1: 10, 2: 4, 5: 5 };

interface Scale {
  /** Artboard units between labels, and the number of parts between them. */
  readonly step: number;
  readonly parts: number;
  /** Multiples of the step that are seen. */
  readonly labels: readonly number[];
}

function scaleOf(zoom: number, origin: number, extent: number): Scale {
  const step = roundStep(LABEL_GAP / zoom);
  const parts = PARTS[step.toExponential(0)[0]] ?? 1;
  const first = Math.floor(-origin / zoom / step);
  const count = Math.min(Math.ceil(extent / zoom / step) + 2, MOST_LABELS);
  return { step, parts, labels: Array.from({ length: count }, (_, k) => first + k) };
}

/** Ticks along one direction, as path data. @param place maps a place along the ruler and a depth to a point */
function ticks({ step, parts, labels }: Scale, to: (units: number) => number, line: (at: number, length: number) => string) {
  return labels
    .flatMap((label) =>
      Array.from({ length: parts }, (_, k) => line(to((label + k / parts) * step), k === 0 ? LONG : SHORT)),
    )
    .join("");
}

export function Rulers({ canvas }: { readonly canvas: Canvas }) {
  const { editor } = canvas;
  const { width, height } = editor.stage.value;
  const [zoom, , , , x0, y0] = canvas.stageFromArtboard();
  const across = scaleOf(zoom, x0, width);
  const down = scaleOf(zoom, y0, height);
  const toX = (units: number) => units * zoom + x0;
  const toY = (units: number) => units * zoom + y0;
  const label = (units: number, { step }: Scale) => numberText(units * step, step);
  return (
    <svg class="overlay rulers" aria-hidden="true">
      <path class="ruler" d={`M0 0H${width}V${RULER}H${RULER}V${height}H0Z`} />
      <path class="ruler-ticks" d={ticks(across, toX, (x, length) => `M${x.toFixed(1)} ${RULER}v${-length}`)} />
      <path class="ruler-ticks" d={ticks(down, toY, (y, length) => `M${RULER} ${y.toFixed(1)}h${-length}`)} />
      {across.labels.map((k) => (
        <text key={`x${k}`} x={toX(k * across.step) + 3} y={9}>
          {label(k, across)}
        </text>
      ))}
      {down.labels.map((k) => (
        <text key={`y${k}`} transform={`translate(9 ${toY(k * down.step) - 3}) rotate(-90)`}>
          {label(k, down)}
        </text>
      ))}
      <PointerMarks canvas={canvas} />
      <path class="ruler-corner" d={`M0 0H${RULER}V${RULER}H0Z`} />
    </svg>
  );
}

/** The place of the pointer on both rulers. */
function PointerMarks({ canvas }: { readonly canvas: Canvas }) {
  const at = canvas.editor.pointer.value;
  if (!at) return null;
  const [x, y] = canvas.toStage(at);
  return <path class="ruler-pointer" d={`M${x} 0V${RULER}M0 ${y}H${RULER}`} />;
}
