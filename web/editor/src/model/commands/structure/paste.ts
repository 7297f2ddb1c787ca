// SVG text put into the drawing: what copyItems() made, or another drawing.
import { declare, isOfSfumato, SFUMATO, valueOf } from "../../../source/attributes.js";
import { parse } from "../../../source/parse.js";
import { applied } from "../../../source/patch.js";
import type { Edit } from "../../../source/patch.js";
import { withoutSheets } from "../../../source/inline.js";
import { Styles } from "../../../source/styles.js";
import { SourceError } from "../../../source/tree.js";
import type { ElementNode } from "../../../source/tree.js";
import { openDrawing } from "../../drawing.js";
import type { Drawing, Handle, Item, Outcome } from "../../types.js";
import { adopted } from "./adopt.js";
import { CURVES_MARK, rootTag } from "./copying.js";
import { intoDefs } from "../paint/defs.js";
import { Draft } from "../curves/draft.js";
import { innerFrame, layerOf } from "./items.js";
import { insertion, removalOf } from "./layout.js";
import { svgName } from "../markup.js";
import { reframing } from "../mapping.js";
import { innerPlace, newLayer, outerPlace } from "./places.js";
import type { Place } from "./places.js";
import { freshNames, neededBy, renaming, within } from "./references.js";
import { respelled } from "../paint/respell.js";

/**
 * Puts what a text holds into the drawing, where it was on its artboard. Curves go into the layer
 * that `into` is or stands in, else into a new layer; all else goes on top of that layer, or into
 * that group. A text without Sfumato's attributes has nothing to put in: the engine's importSvg()
 * makes a drawing of it.
 * @throws SourceError where the text is no SVG
 */
export function paste(d: Drawing, text: string, into: Handle | null): Outcome | null {
  const root = parse(text);
  if (root.local !== "svg") throw new SourceError("this is no SVG; expected <svg>", 0, 1, 1);
  if (![...within(root)].some(isOfSfumato)) return null;
  // The text's style sheets stay behind.
  const plain = withoutSheets(text, new Styles(text, root), root);
  const from = openDrawing(adopted(plain, plain === text ? root : parse(plain)));
  if (d.root.children.length === 0) return pastedIntoNothing(d, from);
  return pasted(d, from, into === null ? null : (d.item(into) ?? null));
}

function pasted(d: Drawing, from: Drawing, target: Item | null): Outcome | null {
  const all = from.items.filter((item) => isPasted(from, item));
  const curves = all.filter(isOfCurves).flatMap(({ children }) => children);
  const others = all.filter((item) => !isOfCurves(item));
  const pasting = new Pasting(d, from, [...curves, ...others]);
  if (curves.length > 0) pasting.curves(curves, target);
  pasting.others(others, target);
  return pasting.outcome();
}

/**
 * Where there is no element to stand behind, all that is put in would stand at one place: a
 * stand-in parts definitions from what they are for, and goes again.
 */
function pastedIntoNothing(d: Drawing, from: Drawing): Outcome | null {
  const stands = insertion(d.text, d.root, null, [`<${svgName(d.root, "g")}/>`]);
  const opened = openDrawing(applied(d.text, [stands.edit]));
  const outcome = pasted(opened, from, null);
  if (!outcome) return null;
  const { range } = opened.root.children[0];
  const { start, end } = removalOf(opened.text, range);
  const shift = outcome.patch
    .filter(({ at }) => at <= start)
    .reduce((sum, { removed, inserted }) => sum + inserted.length - removed.length, 0);
  const whole = applied(opened.text, outcome.patch);
  const inserted = whole.slice(0, start + shift) + whole.slice(end + shift);
  const select = outcome.select?.map(({ at }) => ({ at: at - (end - start) }));
  return { patch: [{ at: 0, removed: d.text, inserted }], select };
}

function isOfCurves({ element }: Item): boolean {
  return valueOf(element, CURVES_MARK) === "true";
}

function isPasted({ root }: Drawing, { element }: Item): boolean {
  return element.parent === root;
}

class Pasting {
  readonly #draft: Draft;
  readonly #names = new Map<string, string>();
  readonly #ids: ReadonlyMap<string, ElementNode>;
  readonly #tag: string;

  constructor(
    readonly d: Drawing,
    readonly from: Drawing,
    items: readonly Item[],
  ) {
    this.#draft = new Draft(d.text);
    this.#ids = d.ids;
    this.#tag = rootTag(from, items.map(({ element }) => element)).tag;
    const elements = items.map(({ element }) => element);
    const needed = neededBy(elements, from.ids).filter((it) => !this.#isThere(it));
    const taken = new Set(this.#ids.keys());
    for (const element of [...needed, ...elements]) {
      for (const [id, name] of freshNames(element, taken)) {
        if (!this.#names.has(id)) this.#names.set(id, name);
      }
    }
    const definitions = needed.map((it) => this.#text(it, d.root, this.#renaming(it)));
    intoDefs(d, this.#draft, definitions);
    if (items.length > 0) this.#draft.add(declare(d.text, d.root, SFUMATO));
  }

  outcome(): Outcome | null {
    return this.#draft.outcome();
  }

  /** Whether the drawing has an element of this id with this very text. */
  #isThere(element: ElementNode): boolean {
    const found = this.#ids.get(valueOf(element, "id") ?? "");
    if (!found) return false;
    const { start, end } = found.range;
    const text = respelled(this.#tag, this.#source(element), this.d.root);
    return this.d.text.slice(start, end) === text;
  }

  #source({ range }: ElementNode): string {
    return this.from.text.slice(range.start, range.end);
  }

  #renaming(element: ElementNode): Edit[] {
    return renaming(this.from.text, element, this.#names);
  }

  /** As edits of the other text leave it, in the prefixes of a parent. */
  #text(element: ElementNode, parent: ElementNode, edits: readonly Edit[]): string {
    const markup = new Draft(this.from.text).rewritten(element, edits);
    return respelled(this.#tag, markup, parent);
  }

  #pieces(items: readonly Item[], place: Place): string[] {
    const frame = innerFrame(this.d, place.item);
    return items.flatMap((item) => {
      const moved = reframing(this.from, item, frame);
      if (!moved) return [];
      const edits = [...this.#renaming(item.element), ...moved];
      return [this.#text(item.element, place.parent, edits)];
    });
  }

  #insert(place: Place, pieces: readonly string[]): void {
    if (pieces.length === 0) return;
    const { edit, starts } = insertion(this.d.text, place.parent, place.after, pieces);
    this.#draft.add([edit]);
    for (const start of starts) this.#draft.selectWithin(edit, start);
  }

  curves(items: readonly Item[], target: Item | null): void {
    const layer = layerOf(target);
    if (layer && target) {
      this.#insertInto(innerPlace(target), items);
      return;
    }
    const place = outerPlace(this.d, target);
    if (!place) return;
    const pieces = this.#pieces(items, place);
    if (pieces.length > 0) newLayer(this.d, this.#draft, place, pieces);
  }

  #insertInto(place: Place, items: readonly Item[]): void {
    this.#insert(place, this.#pieces(items, place));
  }

  others(items: readonly Item[], target: Item | null): void {
    const place = outerPlace(this.d, target);
    if (place) this.#insertInto(place, items);
  }
}
