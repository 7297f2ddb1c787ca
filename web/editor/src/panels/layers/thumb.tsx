// A small picture of a layer or group: the page's, or its curves in their colours.
import { memo } from "preact/compat";
import { useRef } from "preact/hooks";
import type { Affine } from "../../geometry/affine.js";
import type { CurveItem, Item } from "../../model/types.js";
import { hexOf } from "../../geometry/colortext.js";
import { boxOf } from "../../model/item-boxes.js";
import { useShell } from "../services.js";
import { curvesWithin } from "./rows.js";
import { settledOf } from "./settled.js";

/** More curves than this say no more at this size. */
const MOST = 24;

const mapped = (m: Affine, [x, y]: readonly [number, number]) =>
  `${(m[0] * x + m[2] * y + m[4]).toFixed(1)} ${(m[1] * x + m[3] * y + m[5]).toFixed(1)}`;

function outline(item: CurveItem): string {
  return item.paths
    .map(({ points }) => {
      const [first, ...rest] = points.map((point) => mapped(item.artboardFromItem, point));
      return `M${first}C${rest.join(" ")}`;
    })
    .join("");
}

function color(item: CurveItem): string {
  for (const { color: side } of [item.right, item.left]) {
    if (side.kind === "stops" && side.stops.length > 0) {
      return hexOf(side.stops[Math.floor(side.stops.length / 2)].value);
    }
  }
  return "#ffffff";
}

/** The curves' box with some room, never without extent. */
function viewBox(item: Item): string {
  const [left, top, right, bottom] = boxOf([item]) ?? [0, 0, 1, 1];
  const size = Math.max(right - left, bottom - top, 1e-3);
  const room = size * 0.08;
  return [
    left - room,
    top - room,
    Math.max(right - left, size / 50) + 2 * room,
    Math.max(bottom - top, size / 50) + 2 * room,
  ].join(" ");
}

const isClosed = ({ paths }: CurveItem) => paths.every(({ closed }) => closed);

/** An item with anything else in it is another object. */
const Outlines = memo(({ item }: { readonly item: Item }) => (
  <svg class="thumb" viewBox={viewBox(item)} aria-hidden="true">
    {(curvesWithin(item, MOST) as CurveItem[]).map((curve) => (
      <path
        key={curve.handle}
        d={outline(curve)}
        stroke={color(curve)}
        fill={isClosed(curve) ? color(curve) : "none"}
      />
    ))}
  </svg>
));

/** The item as it was when the drawing last came to rest. */
function useSettled(item: Item): Item {
  const { editor } = useShell();
  const revision = settledOf(editor).revision.value;
  const shown = useRef({ revision, item });
  if (shown.current.revision !== revision || shown.current.item.handle !== item.handle)
    shown.current = { revision, item };
  return shown.current.item;
}

export function Thumb({ item }: { readonly item: Item }) {
  const settled = useSettled(item);
  const url = useShell().services.thumb(item.handle);
  return url ? <img class="thumb" src={url} alt="" /> : <Outlines item={settled} />;
}
