// Groups taken apart where the picture stays as it is.
import { setAttribute, valueOf } from "../../../source/attributes.js";
import { keywordOf } from "../../../source/css.js";
import type { Edit } from "../../../source/patch.js";
import { setStyle } from "../../../source/set-style.js";
import { declarationsOf } from "../../../source/declarations.js";
import { isSvg, Styles } from "../../../source/styles.js";
import type { ElementNode } from "../../../source/tree.js";
import { ownTransform } from "../../building.js";
import type { Drawing, Handle, Item, Outcome } from "../../types.js";
import { Draft } from "../curves/draft.js";
import { layerOf, outermost } from "./items.js";
import { leadOf, removalOf } from "./layout.js";
import { finestStep, isIdentity, mapping } from "../mapping.js";
import { isNamed } from "./references.js";

const DRAWS_NOTHING = new Set(
  ("defs title desc metadata style script linearGradient radialGradient pattern symbol clipPath " +
    "mask filter marker").split(" "),
);

/** Properties that children inherit. */
const INHERITED =
  /^(fill|stroke|color|visibility|font|text|paint-order|shape-rendering)($|-)|^(letter|word)-spacing$/;

/** Properties of a group that its children cannot take over. */
const OF_GROUPS_ALONE = ["clip-path", "mask", "filter"];

/** Takes groups apart. null: one cannot be without a change of the picture, or is no plain group. */
export function ungroup(d: Drawing, handles: readonly Handle[]): Outcome | null {
  const ungrouping = new Ungrouping(d);
  for (const item of outermost(d, handles)) {
    const isGroup = item.kind === "group" && item.element.local === "g";
    if (!isGroup || !ungrouping.dissolve(item)) return null;
  }
  return ungrouping.draft.outcome();
}

/** Returns an element's own value of a property, from its style or an attribute. */
function saidBy(element: ElementNode, name: string): string | undefined {
  const declared = declarationsOf(valueOf(element, "style") ?? "");
  return declared.filter((it) => it.name === name).at(-1)?.value ?? valueOf(element, name);
}

/** Whether children may refer to custom properties of an element. */
function declaresVariables(element: ElementNode): boolean {
  return declarationsOf(valueOf(element, "style") ?? "").some(({ name }) => name.startsWith("--"));
}

function isIsolated(element: ElementNode): boolean {
  return saidBy(element, "isolation")?.trim().toLowerCase() === "isolate";
}

class Ungrouping {
  readonly draft: Draft;
  readonly #styles: Styles;

  constructor(readonly d: Drawing) {
    this.draft = new Draft(d.text);
    this.#styles = new Styles(d.text, d.root);
  }

  /** Whether it could be. */
  dissolve(group: Item): boolean {
    const { element } = group;
    const id = valueOf(element, "id");
    if (id !== undefined && isNamed(this.d.root, id)) return false;
    if (declaresVariables(element)) return false;
    if (OF_GROUPS_ALONE.some((name) => (saidBy(element, name) ?? "none") !== "none")) return false;
    const drawn = element.children.filter((it) => isSvg(it) && !DRAWS_NOTHING.has(it.local));
    const isComposited = !layerOf(group) && isCompositedAlone(group);
    const only = drawn.length === 1 ? this.d.item(drawn[0].handle) : undefined;
    if (isComposited && drawn.length > 0 && !only && !isIsolatedForNothing(group)) return false;
    for (const child of drawn) {
      const edits = this.#handedDown(group, child, isComposited ? only : undefined);
      if (!edits) return false;
      this.draft.add(edits);
    }
    unwrap(this.d.text, this.draft, element);
    for (const { element: child } of group.children) this.draft.selectAt(child.range.start);
    return true;
  }

  /** Returns the properties that a child takes over from its group. null: it cannot. */
  #handedDown(group: Item, child: ElementNode, only: Item | undefined): Edit[] | null {
    const { d } = this;
    const own = ownTransform(group.element);
    const edits = this.#inherited(group.element, child);
    if (keywordOf(this.#styles.value(group.element, "display") ?? "") === "none") {
      edits.push(...setStyle(d.text, this.#styles, child, "display", "none"));
    }
    if (only) edits.push(...this.#compositing(group, only));
    if (isIdentity(own, 1, 1e-9)) return edits;
    const item = d.item(child.handle);
    return item ? [...mapping(d, item, own, finestStep(d)), ...edits] : null;
  }

  /** An isolated group of one: that is composited alone, so that its own blend mode does nothing. */
  #compositing(group: Item, { element, opacity, blend, kind }: Item): Edit[] {
    const { text } = this.d;
    const edits: Edit[] = [];
    if (group.opacity < 1) {
      const product = String(Number((group.opacity * opacity).toPrecision(6)));
      edits.push(...setStyle(text, this.#styles, element, "opacity", product));
    }
    if (blend !== group.blend) {
      edits.push(...setStyle(text, this.#styles, element, "mix-blend-mode", group.blend));
    }
    if (isIsolated(group.element) && kind !== "stroke" && !isIsolated(element)) {
      edits.push(...setAttribute(text, element, "isolation", "isolate"));
    }
    return edits;
  }

  #inherited(group: ElementNode, child: ElementNode): Edit[] {
    const declared = declarationsOf(valueOf(group, "style") ?? "");
    const attributes = group.attributes.filter(({ namespace }) => namespace === "");
    const said = new Map([...attributes, ...declared].map(({ name, value }) => [name, value]));
    return [...said].flatMap(([name, value]) => {
      const isTaken = INHERITED.test(name) && saidBy(child, name) === undefined;
      return isTaken ? setAttribute(this.d.text, child, name, value) : [];
    });
  }
}

/** Returns whether a group is composited separately. */
function isCompositedAlone({ opacity, blend, element }: Item): boolean {
  return opacity < 1 || blend !== "normal" || isIsolated(element);
}

/** Whether a group of several is isolated, but opaque, and nothing in it blends. */
function isIsolatedForNothing(group: Item): boolean {
  const blends = (item: Item): boolean => item.blend !== "normal" || item.children.some(blends);
  return group.opacity === 1 && group.blend === "normal" && !group.children.some(blends);
}

/** Takes the tags of a group away; what is in it moves to the left by one step. */
function unwrap(text: string, draft: Draft, { range, content, children }: ElementNode): void {
  const inner = text.slice(content.start, content.end);
  if (!/\S/.test(inner)) {
    draft.replace(removalOf(text, range), "");
    return;
  }
  const first = content.start + inner.search(/\S/);
  const last = content.start + inner.trimEnd().length;
  const lead = leadOf(text, range.start);
  draft.replace({ start: range.start, end: first }, "");
  for (const { range: { start } } of children) {
    const own = leadOf(text, start);
    if (start > first && lead !== "" && own !== "") {
      draft.replace({ start: start - own.length, end: start }, lead);
    }
  }
  draft.replace({ start: last, end: range.end }, "");
}
