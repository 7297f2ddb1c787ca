// One mark on the picture: a button that can be focused, in pixels around its place.
import type { ComponentChildren } from "preact";
import { hexOf } from "../geometry/colortext.js";
import type { Point } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import type { BoxMark, Mark, NodeMark, PaintMark, StopMark } from "./marks.js";
import { keyOf } from "./walk.js";

/** Radii, CSS pixels. */
const STOP = 7;
const STOP_FILL = 4.75;
const STOP_ON = 9.5;
const HANDLE = 4;
const CHEQUER = 2.4;

export function MarkView({ mark }: { readonly mark: Mark }) {
  return (
    <g
      class={mark.isChosen ? "mark on" : "mark"}
      style={`--x:${mark.at[0]}px;--y:${mark.at[1]}px`}
      role="button"
      aria-label={mark.label}
      aria-pressed={mark.isChosen}
      tabindex={-1}
      data-mark={keyOf(mark)}
    >
      {shapeOf(mark)}
    </g>
  );
}

function shapeOf(mark: Mark): ComponentChildren {
  switch (mark.kind) {
    case "node":
    case "scale":
      return <Square mark={mark} />;
    case "handle":
      return <circle class="handle" r={HANDLE} />;
    case "paint":
      return <Diamond mark={mark} />;
    case "turn":
      return <Turn mark={mark} />;
    case "stop":
      return <Stop mark={mark} />;
    case "bracket":
      return <Bracket mark={mark} />;
  }
}

function Square({ mark }: { readonly mark: NodeMark | BoxMark }) {
  return (
    <>
      {mark.isChosen && <rect class="node-rim" x={-5.5} y={-5.5} width={11} height={11} rx={2} />}
      <rect class="node" x={-4.5} y={-4.5} width={9} height={9} rx={1} />
    </>
  );
}

function Diamond({ mark }: { readonly mark: PaintMark }) {
  return (
    <g transform="rotate(45)">
      {mark.isChosen && <rect class="node-rim" x={-5.5} y={-5.5} width={11} height={11} rx={2} />}
      <rect class="node" x={-4.5} y={-4.5} width={9} height={9} rx={1} />
    </g>
  );
}

function Turn({ mark }: { readonly mark: BoxMark }) {
  return (
    <>
      {mark.isChosen && <circle class="node-rim" r={HANDLE + 1.5} />}
      <circle class={mark.isChosen ? "node" : "handle"} r={HANDLE} />
    </>
  );
}

/** From the curve to a stop: a line that begins where the curve's rim ends. */
function Stem({ mark }: { readonly mark: StopMark }) {
  const [dx, dy] = [mark.foot[0] - mark.at[0], mark.foot[1] - mark.at[1]];
  const length = Math.hypot(dx, dy) || 1;
  const along = (distance: number): Point => [(dx / length) * distance, (dy / length) * distance];
  const [from, to] = [along(STOP), along(Math.max(STOP, length - 3))];
  return (
    <>
      <line class="stem-rim" x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />
      <line class="stem" x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />
    </>
  );
}

function Stop({ mark }: { readonly mark: StopMark }) {
  const isColor = mark.attribute === "color";
  return (
    <>
      <Stem mark={mark} />
      {mark.isChosen && <circle class="stop-on-rim" r={STOP_ON} />}
      {mark.isChosen && <circle class="stop-on" r={STOP_ON} />}
      <circle class="stop-ring" r={STOP} />
      {isColor ? (
        <circle class="stop-fill" r={STOP_FILL} fill={hexOf(mark.value as Rgb)} />
      ) : (
        <>
          <Chequers />
          <circle class="stop-fill" r={STOP_FILL} fill="#000" fill-opacity={Number(mark.value)} />
        </>
      )}
    </>
  );
}

/** The ground that shows through an opacity stop. */
function Chequers() {
  return (
    <>
      <circle class="chequer-light" r={STOP_FILL} />
      <path
        class="chequer-dark"
        d={`M0 0V${-2 * CHEQUER}A${2 * CHEQUER} ${2 * CHEQUER} 0 0 1 ${2 * CHEQUER} 0ZM0 0V${2 * CHEQUER}A${2 * CHEQUER} ${2 * CHEQUER} 0 0 1 ${-2 * CHEQUER} 0Z`}
      />
    </>
  );
}

/** A bracket across the normal, open towards the curve. */
function Bracket({ mark }: { readonly mark: StopMark }) {
  const [nx, ny] = mark.normal;
  const point = (out: number, along: number) => `${nx * out - ny * along} ${ny * out + nx * along}`;
  const d = `M${point(-4.5, -9)}L${point(0, -9)} ${point(0, 9)} ${point(-4.5, 9)}`;
  return (
    <>
      <path class={mark.isChosen ? "bracket-rim on" : "bracket-rim"} d={d} />
      <path class={mark.isChosen ? "bracket on" : "bracket"} d={d} />
    </>
  );
}
