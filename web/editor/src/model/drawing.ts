// The document: a text, its tree, and the items that the tree says.
import { composed } from "../geometry/affine.js";
import type { Box } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import { geometryAttributes } from "../geometry/path.js";
import { attributeOf, SFUMATO, SVG } from "../source/attributes.js";
import { encodeValue } from "../source/entities.js";
import { elementsOf } from "../source/nodes.js";
import type { Attribute, Element } from "../source/nodes.js";
import { counter, parseDocument, rereadTag } from "../source/parse.js";
import { applied } from "../source/patch.js";
import type { Patch } from "../source/patch.js";
import { failure } from "../source/scan.js";
import { Styles } from "../source/styles.js";
import { SourceError } from "../source/tree.js";
import { readArtboard, readInterpolation, saidBackground } from "./artboard.js";
import type { Artboard } from "./artboard.js";
import { buildItems, ownTransform } from "./building.js";
import type { Built, Sources } from "./building.js";
import { changedAttributes, isStructural } from "./changes.js";
import { countCopies } from "./copies.js";
import { readCurve } from "./curve-reading.js";
import { itemOf } from "./item-object.js";
import type { Building, BuildingItem, Within } from "./item-object.js";
import { readCommon } from "./item-reading.js";
import { keepHandles } from "./kept-handles.js";
import { reuseItems } from "./reuse.js";
import type { Change, CurveItem, Drawing, Handle, Item, UseItem } from "./types.js";

type Known = Sources["known"];

class TextDrawing implements Drawing {
  text: string;
  revision = 0;
  root: Element;
  readOnly: string | null;
  artboard: Box = [0, 0, 1, 1];
  interpolation: Drawing["interpolation"] = "srgb";
  background: Rgb | null = null;
  ids: ReadonlyMap<string, Element> = new Map();
  readonly #newHandle = counter();
  /** In the order of the text. */
  #elements: Element[] = [];
  #styles: Styles;
  #frame!: Artboard;
  #built!: Built;

  constructor(text: string) {
    const { root, definesEntities } = readText(text, this.#newHandle);
    this.text = text;
    this.root = root;
    this.readOnly = readOnlyReason(definesEntities);
    this.#elements = [...elementsOf(root)];
    this.#styles = new Styles(text, root);
    this.#build(() => null);
  }

  get items(): readonly Item[] {
    return this.#built.items;
  }

  item(handle: Handle): Item | undefined {
    return this.#built.byHandle.get(handle);
  }

  itemAt(offset: number): Item | undefined {
    const element = this.#elements[this.#indexAt(offset)];
    return element?.at === offset ? this.item(element.handle) : undefined;
  }

  *all(): Iterable<Item> {
    const waiting = [...this.#built.items, ...this.#built.detached].reverse();
    for (let item = waiting.pop(); item; item = waiting.pop()) {
      yield item;
      for (let i = item.children.length - 1; i >= 0; i -= 1) waiting.push(item.children[i]);
    }
  }

  apply(patch: Patch): Change {
    const text = applied(this.text, patch);
    const within = this.#applyWithin(patch, text);
    if (within) return within;
    const { root, definesEntities } = readText(text, this.#newHandle);
    const before = this.#elements;
    this.#elements = [...elementsOf(root)];
    const kept = new Set(keepHandles(before, this.#elements, patch));
    const known = this.#knownOf((element) => kept.has(element));
    this.text = text;
    this.root = root;
    this.readOnly = readOnlyReason(definesEntities);
    this.#styles = new Styles(text, root);
    this.revision += 1;
    this.#build(known);
    return { isStructural: true, touched: new Map() };
  }

  /** Index of the last element that begins at or before a place; -1: none. */
  #indexAt(offset: number): number {
    let low = 0;
    let high = this.#elements.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.#elements[middle].at <= offset) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  /** A patch among attributes of one element; null where it is none. */
  #applyWithin(patch: Patch, text: string): Change | null {
    const first = patch[0];
    const index = first ? this.#indexAt(first.at - 1) : -1;
    const element = this.#elements[index];
    if (!element) return null;
    const { at, tagLength, name, closesItself } = element;
    const begin = at + 1 + name.length;
    const end = at + tagLength - (closesItself ? 2 : 1);
    if (patch.some((edit) => edit.at < begin || edit.at + edit.removed.length > end)) return null;
    const tag = applied(
      this.text.slice(at, at + tagLength),
      patch.map((edit) => ({ ...edit, at: edit.at - at })),
    );
    const before = element.attributes;
    try {
      rereadTag(element, tag);
    } catch (error) {
      // Reading the whole text finds the place, or that the tag became another.
      if (error instanceof SourceError) return null;
      throw error;
    }
    const changed = changedAttributes(before, element.attributes);
    if (changed.some(({ name: n }) => n === "xmlns" || n.startsWith("xmlns:"))) {
      element.attributes = before;
      return null;
    }
    this.#shift(index, tag.length - tagLength);
    this.text = text;
    this.revision += 1;
    return this.#attributesChanged(element, before, changed);
  }

  /** Moves what stands behind a start tag that grew. */
  #shift(index: number, by: number): void {
    const element = this.#elements[index];
    element.tagLength += by;
    for (let outer: Element | null = element; outer; outer = outer.parent) {
      outer.contentLength += by;
      outer.length += by;
    }
    for (let i = index + 1; i < this.#elements.length; i += 1) this.#elements[i].at += by;
  }

  #attributesChanged(
    element: Element,
    before: readonly Attribute[],
    changed: readonly Attribute[],
  ): Change {
    // Rules that test an attribute may match other elements now.
    const structural =
      this.#styles.attributesChanged(changed) ||
      changed.some((a) => isStructural(a, before, element.attributes));
    const names = new Set(changed.map(({ local }) => local));
    const item = this.item(element.handle);
    const isCurve = item?.kind === "curve" || item?.kind === "stroke";
    // A curve without a label gets a number, which it does not know alone.
    if (isCurve && !structural && !names.has("label")) {
      this.#replace(item, this.#reread(item, names));
    } else {
      if (element.local === "style") this.#styles = new Styles(this.text, this.root);
      this.#build(
        this.#knownOf((one) => one !== element),
        element.handle,
      );
    }
    return { isStructural: structural, touched: new Map([[element.handle, names]]) };
  }

  /** Reads again a curve whose attributes changed. */
  #reread(item: CurveItem, names: ReadonlySet<string>): CurveItem {
    const { element, kind, handle } = item;
    const place = this.#built.places.get(handle);
    if (!place) throw new RangeError("an item without a place");
    const isMoved = geometryAttributes(element.local).some((name) => names.has(name));
    const reading = readCurve(element, kind, this.#frame.viewBox, isMoved ? null : item);
    const own = ownTransform(element);
    const layerFromUser = place.layerFromUser;
    return itemOf<CurveItem>({
      ...(item as Within<CurveItem>),
      ...reading,
      ...readCommon(element, this.#styles),
      artboardFromItem: composed(place.artboardFromUser, own),
      layerFromItem: layerFromUser ? composed(layerFromUser, own) : item.layerFromItem,
    });
  }

  /** Puts an item into the place of another, with new objects for all around it. */
  #replace(old: Item, fresh: Item): void {
    const built = this.#built;
    for (let [from, to] = [old, fresh]; ;) {
      built.byHandle.set(to.handle, to);
      const { parent } = from;
      if (!parent) {
        (built as Building<Built>).items = exchanged(built.items, from, to);
        (built as Building<Built>).detached = exchanged(built.detached, from, to);
        break;
      }
      const children = exchanged(parent.children, from, to);
      [from, to] = [parent, itemOf({ ...(parent as BuildingItem), children })];
    }
    for (const use of built.uses) this.#retarget(use);
  }

  #retarget(use: Within<UseItem>): void {
    const now = this.item(use.handle) as Within<UseItem>;
    now.target = (now.target && this.item(now.target.handle)) ?? null;
  }

  /** Returns an element's curve from the last build, if the element and the base of 100% are unchanged. */
  #knownOf(isAsItWas: (element: Element) => boolean): Known {
    const { byHandle } = this.#built;
    const { viewBox } = this.#frame;
    return (element, kind) => {
      const item = byHandle.get(element.handle);
      const isHeld = item?.kind === kind && isAsItWas(element as Element);
      return isHeld && viewBox.every((v, i) => v === this.#frame.viewBox[i]) ? item : null;
    };
  }

  /** @param touched what is another object in any case */
  #build(known: Known, touched?: Handle): void {
    const before = this.#built?.byHandle;
    this.ids = idsOf(this.#elements);
    this.#frame = readArtboard(this.root);
    this.artboard = this.#frame.box;
    this.interpolation = readInterpolation(this.root);
    const built = buildItems({
      root: this.root,
      styles: this.#styles,
      artboard: this.#frame,
      elementOfId: this.ids,
      known,
    });
    countCopies(built);
    if (touched !== undefined) before?.delete(touched);
    if (before) reuseItems(built, before);
    this.#built = built;
    const said = saidBackground(this.root);
    this.background = said === undefined ? built.background : said;
  }
}

function idsOf(elements: readonly Element[]): ReadonlyMap<string, Element> {
  const found = new Map<string, Element>();
  for (const element of elements) {
    const id = attributeOf(element, "id")?.value;
    if (id !== undefined && !found.has(id)) found.set(id, element);
  }
  return found;
}

function exchanged(items: readonly Item[], from: Item, to: Item): Item[] {
  return items.map((item) => (item === from ? to : item));
}

function readOnlyReason(definesEntities: boolean): string | null {
  return definesEntities ? "Its DOCTYPE defines entities." : null;
}

function readText(text: string, newHandle: () => number) {
  const parsed = parseDocument(text, newHandle);
  const { root } = parsed;
  // In whatever namespace: so does the engine.
  if (root.local === "svg") return parsed;
  const { start } = root.range;
  throw failure(text, start, `the document is a <${root.name}>; expected <svg xmlns="${SVG}">`);
}

/** Reads a text. @throws SourceError where it is no XML, or no <svg> */
export function openDrawing(text: string): Drawing {
  return new TextDrawing(text);
}

/** The text of a drawing without curves. @param background null: none */
export function blankText(width: number, height: number, background: string | null): string {
  const said = background === null ? "" : ` sf:background="${encodeValue(background, '"')}"`;
  const size = `width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"`;
  return `<svg xmlns="${SVG}" xmlns:sf="${SFUMATO}" ${size} sf:version="1"${said}>
  <g id="layer-1" sf:diffuse="true">
  </g>
</svg>
`;
}
