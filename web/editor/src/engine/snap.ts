// Curves moved to the edges of a photo.
import { snappedPath } from "../geometry/edge-snap.js";
import { edgeMap } from "../geometry/magnet.js";
import type { CubicPath } from "../geometry/cubic.js";
import type { SnapWish } from "./types.js";

/** null: there is no edge within reach. */
export function snapped({ photo, paths, reach }: SnapWish): readonly (CubicPath | null)[] {
  const edges = edgeMap(photo);
  return paths.map((path) => snappedPath(edges, path, reach));
}
