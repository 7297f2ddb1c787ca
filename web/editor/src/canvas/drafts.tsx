// Lines above the picture: of curves, of what is being drawn, and the aids of a gesture.
import type { Affine, Point } from "../geometry/affine.js";
import { pathData } from "./outline.js";
import type { Draft, Guide, Sketch } from "./sketch.js";

export const matrix = (map: Affine): string => `matrix(${map.join(" ")})`;

/** A thin line with its rim. */
export function Light({ data }: { readonly data: string }) {
  if (data === "") return null;
  return (
    <>
      <path class="thin-rim" d={data} />
      <path class="curve-hover" d={data} />
    </>
  );
}

/** The selected curve: a blue core that alternates with white, between dark rims. */
export function Strong({ data }: { readonly data: string }) {
  return (
    <>
      <path class="rim" d={data} />
      <path class="curve-on" d={data} />
      <path class="curve-dash" d={data} />
    </>
  );
}

export function DraftView({ draft, map }: { readonly draft: Draft; readonly map: Affine }) {
  const data = pathData(draft.path);
  const nodes = draft.hasNodes ? draft.path.points.filter((_, k) => k % 3 === 0) : [];
  const place = ([x, y]: Point) => `--x:${x * map[0] + map[4]}px;--y:${y * map[3] + map[5]}px`;
  return (
    <>
      <g transform={matrix(map)}>
        {draft.rubber && <Light data={pathData(draft.rubber)} />}
        {draft.fill && <path class="draft-fill" style={{ "--c": draft.fill }} d={data} />}
        <Strong data={data} />
      </g>
      {nodes.map((point, k) => (
        <g key={k} class="mark" style={place(point)}>
          <rect class="node" x={-4.5} y={-4.5} width={9} height={9} rx={1} />
          {k === 0 && draft.closes && <circle class="stop-on" r={9.5} />}
        </g>
      ))}
    </>
  );
}

/** Guides, the selecting rectangle, the brush. */
export function Aids({ sketch }: { readonly sketch: Sketch }) {
  const { marquee, guides, brush } = sketch;
  return (
    <>
      {guides.map((guide, k) => (
        <GuideMark key={k} guide={guide} />
      ))}
      {marquee && <Marquee from={marquee[0]} to={marquee[1]} />}
      {brush && <circle class="brush-rim" cx={brush.at[0]} cy={brush.at[1]} r={brush.radius} />}
      {brush && <circle class="brush" cx={brush.at[0]} cy={brush.at[1]} r={brush.radius} />}
    </>
  );
}

function GuideMark({ guide: { from, to } }: { readonly guide: Guide }) {
  if (from[0] !== to[0] || from[1] !== to[1]) {
    const ends = { x1: from[0], y1: from[1], x2: to[0], y2: to[1] };
    return (
      <>
        <line class="guide-line-rim" {...ends} />
        <line class="guide-line" {...ends} />
      </>
    );
  }
  return (
    <g class="mark" style={`--x:${to[0]}px;--y:${to[1]}px`}>
      <circle class="guide-rim" r={8} />
      <circle class="guide" r={8} />
    </g>
  );
}

function Marquee({ from, to }: { readonly from: Point; readonly to: Point }) {
  const sides = {
    x: Math.min(from[0], to[0]),
    y: Math.min(from[1], to[1]),
    width: Math.abs(to[0] - from[0]),
    height: Math.abs(to[1] - from[1]),
  };
  return (
    <>
      <rect class="marquee-rim" {...sides} />
      <rect class="marquee" {...sides} />
    </>
  );
}
