// A drawing without text, and commands that change it: the part of the model that the canvas needs.
import type { Affine, Box, Point } from "../../../../web/editor/src/geometry/affine.js";
import {
  composed,
  IDENTITY,
  mapped,
  translation,
} from "../../../../web/editor/src/geometry/affine.js";
import type { CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import { closedByEnd } from "../../../../web/editor/src/geometry/nodes.js";
import { pieceAt, split } from "../../../../web/editor/src/geometry/cubic.js";
import type { NewCurve, NodesBySubpath } from "../../../../web/editor/src/model/commands/index.js";
import type {
  ContainerItem,
  CurveItem,
  Drawing,
  Handle,
  Item,
  Outcome,
  ReferenceItem,
  Side,
  SideValue,
  SideValues,
  UseItem,
} from "../../../../web/editor/src/model/types.js";
import type { ElementNode } from "../../../../web/editor/src/source/tree.js";

let handles = 0;

export function elementOf(
  local: string,
  attributes: Readonly<Record<string, string>> = {},
): ElementNode {
  handles += 1;
  const none = { start: 0, end: 0 };
  return {
    name: local,
    local,
    namespace: "http://www.w3.org/2000/svg",
    parent: null,
    children: [],
    attributes: Object.entries(attributes).map(([name, value]) => ({
      name,
      local: name,
      namespace: "",
      value,
      range: none,
      valueRange: none,
      quote: '"' as const,
    })),
    range: { start: handles * 100, end: handles * 100 + 99 },
    startTag: none,
    content: none,
    closesItself: true,
    handle: handles,
  };
}

const OPEN = { kind: "open" } as const;
export const NO_SIDES: SideValues = { color: OPEN, opacity: OPEN, blur: OPEN };

export function stopsOf<V>(...stops: readonly (readonly [number, V])[]): SideValue<V> {
  return {
    kind: "stops",
    space: "arc",
    stops: stops.map(([offset, value]) => ({ offset, value })),
  };
}

function base(element: ElementNode, name: string) {
  return {
    handle: element.handle,
    element,
    parent: null,
    children: [],
    name,
    artboardFromItem: IDENTITY,
    hidden: false,
    locked: false,
    opacity: 1,
    blend: "normal",
  };
}

export function curve(
  name: string,
  paths: readonly CubicPath[],
  more: Partial<CurveItem> = {},
): CurveItem {
  return {
    ...base(elementOf("path"), name),
    kind: "curve",
    paths,
    isPath: true,
    left: NO_SIDES,
    right: NO_SIDES,
    radius: OPEN,
    layerFromItem: IDENTITY,
    copies: 1,
    ...more,
  };
}

export function layer(
  name: string,
  children: readonly Item[],
  more: Partial<ContainerItem> = {},
): ContainerItem {
  const element = elementOf("g");
  const item: ContainerItem = { ...base(element, name), kind: "layer", children, ...more };
  for (const child of children) {
    (child as { parent: Item | null }).parent = item;
    // The engine finds a layer by the places of its curves in the text.
    const range = element.range as { start: number; end: number };
    range.start = Math.min(range.start, child.element.range.start);
  }
  return item;
}

export function use(
  name: string,
  target: Item,
  at: Affine,
  attributes: Readonly<Record<string, string>> = {},
): UseItem {
  return { ...base(elementOf("use", attributes), name), kind: "use", target, artboardFromItem: at };
}

export function reference(
  name: string,
  box: Box,
  more: Partial<ReferenceItem> = {},
): ReferenceItem {
  return { ...base(elementOf("image"), name), kind: "reference", href: "", box, ...more };
}

/** Returns a line as a curve of one piece. */
export function line(from: Point, to: Point): CubicPath {
  const third = (k: number): Point => [
    from[0] + ((to[0] - from[0]) * k) / 3,
    from[1] + ((to[1] - from[1]) * k) / 3,
  ];
  return { points: [from, third(1), third(2), to], closed: false };
}

export class FakeDrawing implements Drawing {
  readonly text = "";
  readonly root = elementOf("svg");
  readonly ids = new Map();
  readonly background = null;
  readonly readOnly = null;
  interpolation: Drawing["interpolation"] = "srgb";
  artboard: Box = [0, 0, 400, 300];
  revision = 0;

  constructor(public items: readonly Item[]) {}

  item(handle: Handle): Item | undefined {
    return [...this.all()].find((item) => item.handle === handle);
  }

  itemAt(): undefined {
    return undefined;
  }

  *all(): Iterable<Item> {
    const inside = function* (items: readonly Item[]): Iterable<Item> {
      for (const item of items) {
        yield item;
        yield* inside(item.children);
      }
    };
    yield* inside(this.items);
  }

  apply(): never {
    throw new Error("a fake drawing has no text");
  }
}

/** An outcome that carries the new items. */
export interface FakeOutcome extends Outcome {
  readonly items: readonly Item[];
}

function outcome(items: readonly Item[]): FakeOutcome {
  return { patch: [], items };
}

/** Returns the items with some changed, and with new parents above them. */
function changed(
  items: readonly Item[],
  of: ReadonlySet<Handle>,
  make: (item: Item) => Item,
  parent: Item | null = null,
): Item[] {
  return items.map((item) => {
    const now: Item = { ...(of.has(item.handle) ? make(item) : item), parent } as Item;
    (now as { children: readonly Item[] }).children = changed(now.children, of, make, now);
    return now;
  });
}

function changedCurve(
  d: Drawing,
  h: Handle,
  make: (item: CurveItem) => Partial<CurveItem>,
): Outcome {
  return outcome(
    changed(d.items, new Set([h]), (item) => ({ ...item, ...make(item as CurveItem) }) as Item),
  );
}

function withPath(item: CurveItem, k: number, path: CubicPath): Partial<CurveItem> {
  return { paths: item.paths.map((old, i) => (i === k ? path : old)) };
}

function pathWith(d: Drawing, h: Handle, k: number): CubicPath {
  return (d.item(h) as CurveItem).paths[k];
}

function side<K extends keyof SideValues>(
  d: Drawing,
  h: Handle,
  name: Side,
  kind: K,
  to: SideValues[K],
): Outcome {
  return changedCurve(d, h, (item) => ({ [name]: { ...item[name], [kind]: to } }));
}

function withMoved(path: CubicPath, nodes: readonly number[], by: Point): CubicPath {
  const last = path.points.length - 1;
  const moved = new Set(
    nodes
      .flatMap((n) => [3 * n - 1, 3 * n, 3 * n + 1])
      .map((i) => (path.closed ? (i + last) % last : i)),
  );
  const points = path.points.map((p, i): Point =>
    moved.has(i) || (path.closed && i === last && moved.has(0)) ? [p[0] + by[0], p[1] + by[1]] : p,
  );
  return { ...path, points };
}

/** Replaces model/commands: the same names, on items. */
export const fakeCommands = {
  setPath: (d: Drawing, h: Handle, k: number, to: CubicPath) =>
    changedCurve(d, h, (item) => withPath(item, k, to)),
  moveNodes: (d: Drawing, h: Handle, nodes: NodesBySubpath, by: Point): Outcome =>
    changedCurve(d, h, (item) => ({
      paths: item.paths.map((path, k) => withMoved(path, nodes.get(k) ?? [], by)),
    })),
  splitPiece(d: Drawing, h: Handle, k: number, piece: number, t: number): Outcome {
    const path = pathWith(d, h, k);
    const [a, b] = split(pieceAt(path, piece), t);
    const points = [
      ...path.points.slice(0, 3 * piece),
      ...a.slice(0, 3),
      ...b,
      ...path.points.slice(3 * piece + 4),
    ];
    return changedCurve(d, h, (item) => withPath(item, k, { ...path, points }));
  },
  deleteNodes(d: Drawing, h: Handle, nodes: NodesBySubpath): Outcome {
    const without = (path: CubicPath, of: readonly number[]): CubicPath => {
      const gone = new Set(of.flatMap((n) => [3 * n, 3 * n + 1, 3 * n + 2]));
      return { ...path, points: path.points.filter((_, i) => !gone.has(i)) };
    };
    return changedCurve(d, h, (item) => ({
      paths: item.paths.map((path, k) => without(path, nodes.get(k) ?? [])),
    }));
  },
  closeByEnd: (d: Drawing, h: Handle, k: number, node: number): Outcome =>
    changedCurve(d, h, (item) => withPath(item, k, closedByEnd(item.paths[k], node)!.path)),
  setNodeKind: (d: Drawing) => outcome(d.items),
  setColor: (d: Drawing, h: Handle, name: Side, to: SideValues["color"]) =>
    side(d, h, name, "color", to),
  setNumbers: (
    d: Drawing,
    h: Handle,
    name: Side,
    kind: "opacity" | "blur",
    to: SideValue<number>,
  ) => side(d, h, name, kind, to),
  setBoth: (d: Drawing, h: Handle, kind: "opacity" | "blur", to: SideValue<number>) =>
    changedCurve(d, h, (item) => ({
      left: { ...item.left, [kind]: to },
      right: { ...item.right, [kind]: to },
    })),
  setRadius: (d: Drawing, h: Handle, to: SideValue<number>) =>
    changedCurve(d, h, () => ({ radius: to })),
  addCurves(d: Drawing, into: Handle | null, curves: readonly NewCurve[]): Outcome {
    const made = curves.map(({ path, left, right, radius }) =>
      curve("new", [path], {
        left: { ...NO_SIDES, color: left },
        right: { ...NO_SIDES, color: right },
        ...(radius ? { kind: "stroke" as const, radius } : {}),
      }),
    );
    const select = made.map((item) => ({ at: item.handle }));
    if (into === null) return { ...outcome([...d.items, ...made]), select };
    const items = changed(
      d.items,
      new Set([into]),
      (item) => ({ ...item, children: [...item.children, ...made] }) as Item,
    );
    return { ...outcome(items), select };
  },
  transform(d: Drawing, of: readonly Handle[], map: Affine): Outcome {
    const make = (item: Item): Item =>
      "paths" in item
        ? {
            ...item,
            paths: item.paths.map((path) => ({
              ...path,
              points: path.points.map((p) => mapped(map, p)),
            })),
          }
        : ({ ...item, artboardFromItem: composed(map, item.artboardFromItem) } as Item);
    const within = new Set([
      ...of,
      ...of.flatMap((h) => d.item(h)?.children.map((child) => child.handle) ?? []),
    ]);
    return outcome(changed(d.items, within, make));
  },
  duplicate(d: Drawing, of: readonly Handle[], by: Point): Outcome {
    const copies = of.map((h) => {
      const item = d.item(h) as CurveItem;
      return curve(
        `${item.name} copy`,
        item.paths.map((path) => ({
          ...path,
          points: path.points.map((p) => mapped(translation(...by), p)),
        })),
      );
    });
    return {
      ...outcome([...d.items, ...copies]),
      select: copies.map((item) => ({ at: item.handle })),
    };
  },
  deleteItems: (d: Drawing, of: readonly Handle[]) =>
    outcome(d.items.filter((item) => !of.includes(item.handle))),
  together(outcomes: readonly (Outcome | null)[]): Outcome | null {
    return outcomes.find((one) => one !== null) ?? null;
  },
};
