// The attributes of one shape, apart from its place.
import type { Box } from "../geometry/affine.js";
import type { CubicPath } from "../geometry/cubic.js";
import { pieceCount } from "../geometry/cubic.js";
import { geometryAttributes, shapePaths } from "../geometry/path.js";
import { sf, valueOf } from "../source/attributes.js";
import { COLORS, RADII, readSide, SHARES } from "../source/stops.js";
import type { Notation } from "../source/stops.js";
import type { ElementNode } from "../source/tree.js";
import type { CurveItem, SideValue, SideValues } from "./types.js";

export type CurveReading = Pick<CurveItem, "paths" | "isPath" | "left" | "right" | "radius">;

export function isShape(local: string): boolean {
  return geometryAttributes(local).length > 0;
}

/** Returns the number of segments of the first subpath: lists with "@" end there. */
function segmentCount(paths: readonly CubicPath[]): number {
  const [first] = paths;
  if (!first) return 1;
  return first.segments ? first.segments.length - 1 : pieceCount(first);
}

/** @param before a reading whose subpaths still hold: no attribute of geometry changed */
export function readCurve(
  element: ElementNode,
  kind: CurveItem["kind"],
  viewBox: Box,
  before: CurveReading | null,
): CurveReading {
  const { local } = element;
  const paths = before?.paths ?? shapePaths(local, (name) => valueOf(element, name), viewBox);
  const segments = segmentCount(paths);
  function side<Value>(notation: Notation<Value>, ...names: string[]): SideValue<Value> {
    for (const name of names) {
      const text = valueOf(element, sf(name));
      if (text !== undefined) return readSide(text, notation, segments);
    }
    return { kind: "open" };
  }
  const isStroke = kind === "stroke";
  const values = (own: "left" | "right", other: "left" | "right"): SideValues => ({
    // A local curve with one side's colours has them on both.
    color: isStroke ? side(COLORS, own, other) : side(COLORS, own),
    opacity: isStroke ? { kind: "open" } : side(SHARES, `${own}-opacity`, "opacity"),
    blur: isStroke ? side(RADII, "blur") : side(RADII, `${own}-blur`, "blur"),
  });
  return {
    paths,
    isPath: local === "path",
    left: values("left", "right"),
    right: values("right", "left"),
    radius: side(RADII, "radius"),
  };
}
