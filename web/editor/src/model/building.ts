// The items of a tree: what can be seen or selected, and where it is.
import { composed, IDENTITY, translation } from "../geometry/affine.js";
import type { Affine, Box } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import { hrefOf, sf, valueOf } from "../source/attributes.js";
import { keywordOf } from "../source/css.js";
import { fitted, parseLength, parseTransform, parseViewBox } from "../source/lengths.js";
import { isSvg } from "../source/styles.js";
import type { Styles } from "../source/styles.js";
import type { ElementNode } from "../source/tree.js";
import type { Artboard } from "./artboard.js";
import { backgroundOf, boxOf } from "./background.js";
import { isShape, readCurve } from "./curve-reading.js";
import type { CurveReading } from "./curve-reading.js";
import { itemOf } from "./item-object.js";
import type { Building, BuildingItem, Fields, Within } from "./item-object.js";
import { readCommon, saidName } from "./item-reading.js";
import type { ContainerItem, CurveItem, Handle, Item, ReferenceItem, UseItem } from "./types.js";

/** Elements within each other that are read: as many as the engine reads. */
const DEEPEST = 256;

/** The values that an element gets from its surroundings. */
export interface Place {
  readonly artboardFromUser: Affine;
  /** null outside of layers. */
  readonly layerFromUser: Affine | null;
}

export interface Sources {
  readonly root: ElementNode;
  readonly styles: Styles;
  readonly artboard: Artboard;
  readonly elementOfId: ReadonlyMap<string, ElementNode>;
  /** The curve of an element as it was read before and still is, or null. */
  readonly known: (element: ElementNode, kind: CurveItem["kind"]) => CurveReading | null;
}

export interface Built {
  readonly items: Item[];
  /** Copied by <use>, but not of the outermost level: within <defs>. */
  readonly detached: Item[];
  readonly byHandle: Map<Handle, Item>;
  readonly places: Map<Handle, Place>;
  readonly uses: Within<UseItem>[];
  /** Colour of the <rect> that is the background. */
  readonly background: Rgb | null;
}

/** Names of kinds with a number, for what has neither a label nor an id. */
const KIND_NAMES: Readonly<Record<Item["kind"], string>> = {
  layer: "Layer",
  group: "Group",
  use: "Instance",
  curve: "Curve",
  stroke: "Stroke",
  reference: "Photo",
};

export function ownTransform(element: ElementNode): Affine {
  const text = valueOf(element, "transform");
  return text === undefined ? IDENTITY : (parseTransform(text) ?? IDENTITY);
}

/** The element that a <use> copies, or undefined. */
export function referredElement(
  use: ElementNode,
  elementOfId: ReadonlyMap<string, ElementNode>,
): ElementNode | undefined {
  const href = hrefOf(use)?.value.trim() ?? "";
  return href.startsWith("#") ? elementOfId.get(href.slice(1)) : undefined;
}

function moved(place: Place, by: Affine): Place {
  const { artboardFromUser, layerFromUser } = place;
  if (by === IDENTITY) return place;
  return {
    artboardFromUser: composed(artboardFromUser, by),
    layerFromUser: layerFromUser && composed(layerFromUser, by),
  };
}

class Builder {
  readonly #from: Sources;
  readonly #counts = new Map<Item["kind"], number>();
  readonly built: Building<Built> = {
    items: [],
    detached: [],
    byHandle: new Map(),
    places: new Map(),
    uses: [],
    background: null,
  };
  /** Whether nothing was painted yet, but may be. */
  #mayBeBackground: boolean;

  constructor(from: Sources) {
    this.#from = from;
    this.#mayBeBackground = keywordOf(from.styles.value(from.root, "display") ?? "") !== "none";
  }

  build(): Built {
    const { root, artboard } = this.#from;
    const place = { artboardFromUser: artboard.artboardFromUser, layerFromUser: null };
    if (valueOf(root, sf("diffuse")) === "true") {
      this.built.items.push(this.#container(root, place, null, place, 0) as Item);
    } else {
      this.built.items = this.#children(root, place, null, 0);
    }
    this.#mayBeBackground = false;
    this.#addTargets();
    return this.built;
  }

  /** Builds what uses refer to and stands nowhere else, with the uses therein. */
  #addTargets(): void {
    const { built } = this;
    const { elementOfId } = this.#from;
    for (let i = 0; i < built.uses.length; i += 1) {
      const use = built.uses[i];
      const element = referredElement(use.element, elementOfId);
      if (!element || built.byHandle.has(element.handle) || isWithin(use.element, element))
        continue;
      const item = this.#item(element, this.#placeOfCopy(use), null, 0, use.element);
      if (item) built.detached.push(item as Item);
    }
    // An item that was built alone and then again as part of a larger one is the part.
    const isLast = (item: { handle: Handle }) => built.byHandle.get(item.handle) === item;
    built.detached = built.detached.filter(isLast);
    built.uses = built.uses.filter(isLast);
    for (const use of built.uses) {
      const element = referredElement(use.element, elementOfId);
      use.target = (element && built.byHandle.get(element.handle)) ?? null;
    }
  }

  #placeOfCopy(use: Within<UseItem>): Place {
    const around = this.built.places.get(use.handle) as Place;
    const { element } = use;
    const [x0, y0, x1, y1] = this.#viewBox;
    const x = parseLength(valueOf(element, "x") ?? "0", x1 - x0) ?? 0;
    const y = parseLength(valueOf(element, "y") ?? "0", y1 - y0) ?? 0;
    return moved(moved(around, ownTransform(element)), translation(x, y));
  }

  get #viewBox(): Box {
    return this.#from.artboard.viewBox;
  }

  #children(
    element: ElementNode,
    place: Place,
    parent: BuildingItem | null,
    depth: number,
  ): Item[] {
    if (depth >= DEEPEST) return [];
    const items: Item[] = [];
    for (const child of element.children) {
      const item = this.#item(child, place, parent, depth + 1, null);
      if (item) items.push(item as Item);
    }
    return items;
  }

  #item(
    element: ElementNode,
    place: Place,
    parent: BuildingItem | null,
    depth: number,
    use: ElementNode | null,
  ): BuildingItem | null {
    if (!isSvg(element)) return null;
    const { local } = element;
    const own = moved(place, ownTransform(element));
    if (local === "g" || local === "a") return this.#container(element, place, parent, own, depth);
    if (local === "svg" || (local === "symbol" && use)) {
      const inside = moved(own, this.#viewport(element, use));
      return this.#container(element, place, parent, inside, depth);
    }
    if (local === "use") return this.#use(element, place, parent, own);
    if (local === "image") return this.#reference(element, place, parent, own);
    return isShape(local) ? this.#curve(element, place, parent, own) : null;
  }

  /** Reads the fields that all items have, and registers the item. */
  #begin<Kind extends Item["kind"]>(
    kind: Kind,
    element: ElementNode,
    place: Place,
    parent: BuildingItem | null,
    own: Place,
  ) {
    const number = (this.#counts.get(kind) ?? 0) + 1;
    this.#counts.set(kind, number);
    this.built.places.set(element.handle, place);
    const { hidden, locked, opacity, blend } = readCommon(element, this.#from.styles);
    return {
      hidden,
      locked,
      opacity,
      blend,
      kind,
      handle: element.handle,
      element,
      around: parent?.inside ?? { item: null },
      inside: { item: null },
      children: [] as readonly Item[],
      name: saidName(element) ?? `${KIND_NAMES[kind]} ${number}`,
      artboardFromItem: own.artboardFromUser,
    };
  }

  #noted<T extends Item>(fields: Fields<T>) {
    const item = itemOf<T>(fields);
    this.built.byHandle.set(fields.handle, item as Item);
    return item;
  }

  #container(
    element: ElementNode,
    place: Place,
    parent: BuildingItem | null,
    own: Place,
    depth: number,
  ): Within<ContainerItem> {
    const isLayer = !own.layerFromUser && valueOf(element, sf("diffuse")) === "true";
    const begun = this.#begin(isLayer ? "layer" : "group", element, place, parent, own);
    const item = this.#noted<ContainerItem>(begun);
    if (isLayer && !item.hidden) this.#mayBeBackground = false;
    const inside = isLayer ? { ...own, layerFromUser: IDENTITY } : own;
    const mayBeBackground = this.#mayBeBackground;
    if (item.hidden) this.#mayBeBackground = false;
    item.children = this.#children(element, inside, item, depth);
    if (item.hidden) this.#mayBeBackground = mayBeBackground;
    return item;
  }

  #use(element: ElementNode, place: Place, parent: BuildingItem | null, own: Place) {
    this.#mayBeBackground = false;
    const begun = this.#begin("use", element, place, parent, own);
    const item = this.#noted<UseItem>({ ...begun, target: null });
    this.built.uses.push(item);
    return item;
  }

  #reference(element: ElementNode, place: Place, parent: BuildingItem | null, own: Place) {
    if (valueOf(element, sf("reference")) !== "true") return null;
    const box = boxOf(element, this.#viewBox) ?? [0, 0, 0, 0];
    const href = hrefOf(element)?.value ?? "";
    const begun = this.#begin("reference", element, place, parent, own);
    return this.#noted<ReferenceItem>({ ...begun, href, box });
  }

  #curve(element: ElementNode, place: Place, parent: BuildingItem | null, own: Place) {
    const { known, styles, artboard } = this.#from;
    const isStroke = !own.layerFromUser;
    if (isStroke && valueOf(element, sf("radius")) === undefined) {
      if (this.#mayBeBackground && !readCommon(element, styles).hidden) {
        const { artboardFromUser } = own;
        this.built.background = backgroundOf(element, styles, artboardFromUser, artboard.viewBox);
        this.#mayBeBackground = false;
      }
      return null;
    }
    const kind = isStroke ? "stroke" : "curve";
    const begun = this.#begin(kind, element, place, parent, own);
    if (isStroke && !begun.hidden) this.#mayBeBackground = false;
    const reading = known(element, kind) ?? readCurve(element, kind, artboard.viewBox, null);
    return this.#noted<CurveItem>({
      ...begun,
      paths: reading.paths,
      isPath: reading.isPath,
      left: reading.left,
      right: reading.right,
      radius: reading.radius,
      layerFromItem: own.layerFromUser ?? IDENTITY,
      copies: 1,
    });
  }

  /** Returns the map from the viewBox of a nested <svg> or, with its <use>, of a <symbol>. */
  #viewport(element: ElementNode, use: ElementNode | null): Affine {
    const [x0, y0, x1, y1] = this.#viewBox;
    const length = (bearer: ElementNode, name: string, whole: number, absent: number) =>
      parseLength(valueOf(bearer, name) ?? "", whole) ?? absent;
    const isSvgElement = element.local === "svg";
    const x = isSvgElement ? length(element, "x", x1 - x0, 0) : 0;
    const y = isSvgElement ? length(element, "y", y1 - y0, 0) : 0;
    const content = parseViewBox(valueOf(element, "viewBox") ?? "");
    if (!content) return translation(x, y);
    const size = (name: string, whole: number) => {
      const bearer = use && valueOf(use, name) !== undefined ? use : element;
      return length(bearer, name, whole, whole);
    };
    const target: Box = [x, y, x + size("width", x1 - x0), y + size("height", y1 - y0)];
    return fitted(content, target, valueOf(element, "preserveAspectRatio") ?? "");
  }
}

/** Whether an element is `outer` or stands within it. */
function isWithin(element: ElementNode, outer: ElementNode): boolean {
  for (let at: ElementNode | null = element; at; at = at.parent) if (at === outer) return true;
  return false;
}

export function buildItems(from: Sources): Built {
  return new Builder(from).build();
}
