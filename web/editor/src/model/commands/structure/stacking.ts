// Items removed, or moved in the stacking order.
import { applied } from "../../../source/patch.js";
import type { ElementNode } from "../../../source/tree.js";
import type { Drawing, Handle, Item, Outcome } from "../../types.js";
import { intoDefs } from "../paint/defs.js";
import { Draft } from "../curves/draft.js";
import { elementBefore, outermost, siblingsOf } from "./items.js";
import { insertion, removalsOf } from "./layout.js";
import { namedFromOutside } from "./references.js";

/** Deletes items. Content that others show or use moves to <defs>, so that the others stay as they are. */
export function deleteItems(d: Drawing, handles: readonly Handle[]): Outcome | null {
  const elements = outermost(d, handles).map(({ element }) => element);
  const draft = new Draft(d.text);
  for (const range of removalsOf(d.text, elements)) draft.replace(range, "");
  const kept = namedFromOutside(d.root, elements);
  if (kept.length > 0) {
    intoDefs(d, draft, kept.map(({ range }) => d.text.slice(range.start, range.end)), elements);
  }
  return draft.outcome();
}

/** Elements that move: behind a child of a parent, or with null to the front of it. */
export interface Move {
  readonly parent: ElementNode;
  readonly after: ElementNode | null;
  readonly elements: readonly ElementNode[];
  /** Their text where they arrive. */
  readonly pieces: readonly string[];
}

/** Carries moves out; all that moved is selected. null: the text would be the same. */
export function carriedOut(d: Drawing, draft: Draft, moves: readonly Move[]): Outcome | null {
  const all = moves
    .flatMap(({ elements }) => elements)
    .sort((a, b) => a.range.start - b.range.start);
  for (const range of removalsOf(d.text, all)) draft.replace(range, "");
  for (const { parent, after, pieces } of moves) {
    if (pieces.length === 0) continue;
    const { edit, starts } = insertion(d.text, parent, after, pieces);
    draft.add([edit]);
    for (const start of starts) draft.selectWithin(edit, start);
  }
  const outcome = draft.outcome();
  return outcome && applied(d.text, outcome.patch) === d.text ? null : outcome;
}

/** Siblings after each chosen one went `steps` up; chosen ones do not pass each other. */
function restacked(siblings: readonly Item[], chosen: ReadonlySet<Item>, steps: number): Item[] {
  const order = [...siblings];
  const up = steps > 0;
  const indices = order.flatMap((item, i) => (chosen.has(item) ? [i] : []));
  let limit = up ? order.length - 1 : 0;
  for (const from of up ? indices.reverse() : indices) {
    const to = up ? Math.min(from + steps, limit) : Math.max(from + steps, limit);
    order.splice(to, 0, ...order.splice(from, 1));
    limit = up ? to - 1 : to + 1;
  }
  return order;
}

/** Steps among its siblings: +1 up (on top), -1 down; ±Infinity to the end. */
export function restack(d: Drawing, handles: readonly Handle[], steps: number): Outcome | null {
  const chosen = new Set(outermost(d, handles));
  const families = new Set([...chosen].map((item) => siblingsOf(d, item)));
  const moves = [...families].flatMap((siblings) => movesOf(d.text, siblings, chosen, steps));
  return carriedOut(d, new Draft(d.text), moves);
}

function movesOf(
  text: string,
  siblings: readonly Item[],
  chosen: ReadonlySet<Item>,
  steps: number,
): Move[] {
  const order = restacked(siblings, chosen, Math.trunc(steps) || 0);
  if (order.every((item, i) => item === siblings[i])) return [];
  const elements = new Set([...chosen].map(({ element }) => element));
  const moves: Move[] = [];
  let run: ElementNode[] = [];
  const end = (next: Item | undefined) => {
    if (run.length === 0) return;
    const pieces = run.map(({ range }) => text.slice(range.start, range.end));
    moves.push({ ...placeBefore(siblings, next, elements), elements: run, pieces });
    run = [];
  };
  for (const item of order) {
    if (chosen.has(item)) run.push(item.element);
    else end(item);
  }
  end(undefined);
  return moves;
}

/** Returns the place before an item that stays, or behind the last one that stays. */
function placeBefore(
  siblings: readonly Item[],
  next: Item | undefined,
  moving: ReadonlySet<ElementNode>,
): Pick<Move, "parent" | "after"> {
  const last = siblings[siblings.length - 1].element;
  const parent = last.parent as ElementNode;
  const isMoving = (element: ElementNode) => moving.has(element);
  if (next) return { parent, after: elementBefore(next.element, isMoving) };
  return { parent, after: isMoving(last) ? elementBefore(last, isMoving) : last };
}

