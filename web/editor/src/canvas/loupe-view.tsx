// The loupe of the Sample tool: a magnified circle beside the pointer, or above the finger.
import { useLayoutEffect, useRef } from "preact/hooks";
import type { Point } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import { hexOf } from "../geometry/colortext.js";
import { LOUPE_PIXELS } from "./loupe.js";
import type { Loupe } from "./sketch.js";

/** CSS pixels: of a pixel in it, of its ring, and of all of it. */
const SCALE = 10;
const RING = 8;
const SIZE = SCALE * LOUPE_PIXELS + 2 * RING;
/** From the pointer to its middle; a finger hides more. */
const OFF = { mouse: [88, -88], pen: [88, -88], touch: [0, -120] } as const;

interface Props {
  readonly loupe: Loupe;
  readonly stage: { readonly width: number; readonly height: number };
}

/** Where its middle is: on the other side of the pointer where there is no room. */
export function loupePlace({ at, kind }: Pick<Loupe, "at" | "kind">, { width, height }: Props["stage"]): Point {
  const [dx, dy] = OFF[kind];
  const half = SIZE / 2;
  const beside = at[0] + dx + half > width ? at[0] - dx : at[0] + dx;
  const x = Math.min(Math.max(beside, half), Math.max(half, width - half));
  const y = at[1] + dy - half < 0 ? at[1] - dy : at[1] + dy;
  return [x, Math.min(y, Math.max(half, height - half))];
}

export function LoupeView({ loupe, stage }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { pixels, ring, turn, spots, text } = loupe;
  useLayoutEffect(() => {
    const image = new ImageData(new Uint8ClampedArray(pixels), LOUPE_PIXELS, LOUPE_PIXELS);
    canvas.current?.getContext("2d")?.putImageData(image, 0, 0);
  }, [pixels]);
  const [x, y] = loupePlace(loupe, stage);
  const half = SIZE / 2;
  return (
    <div class="loupe" aria-hidden="true" style={`left:${x - half}px;top:${y - half}px;width:${SIZE}px;height:${SIZE}px`}>
      <canvas ref={canvas} width={LOUPE_PIXELS} height={LOUPE_PIXELS} style={`inset:${RING}px`} />
      <svg viewBox={`${-half} ${-half} ${SIZE} ${SIZE}`}>
        <circle class="loupe-rim" r={half - RING / 2} />
        <g transform={`rotate(${(turn * 180) / Math.PI})`}>
          <Half color={ring[0]} sweep={1} />
          <Half color={ring[1]} sweep={0} />
        </g>
        <rect class="loupe-middle" x={-SCALE / 2} y={-SCALE / 2} width={SCALE} height={SCALE} />
        {spots.map(([dx, dy], k) => (
          <circle key={k} class="loupe-spot" cx={dx * SCALE} cy={dy * SCALE} r={SCALE / 2} />
        ))}
      </svg>
      <span class="tag loupe-text">{text}</span>
    </div>
  );
}

/** Half of the ring, above; with `sweep` 0 below. */
function Half({ color, sweep }: { readonly color: Rgb | null; readonly sweep: 0 | 1 }) {
  const radius = SIZE / 2 - RING / 2;
  return color ? (
    <path
      class="loupe-ring"
      d={`M${-radius} 0A${radius} ${radius} 0 0 ${sweep} ${radius} 0`}
      style={`stroke:${hexOf(color)}`}
    />
  ) : null;
}
