// Items as text for elsewhere, and copies of them beside themselves.
import { declaredPrefix } from "../../../source/parse.js";
import { prefixOf, SFUMATO, SVG } from "../../../source/attributes.js";
import { encodeValue } from "../../../source/entities.js";
import { inlineEdits } from "../../../source/inline.js";
import { Styles } from "../../../source/styles.js";
import type { ElementNode } from "../../../source/tree.js";
import type { Drawing, Handle, Item } from "../../types.js";
import { Draft } from "../curves/draft.js";
import { layerOf, outerFrame, outermost } from "./items.js";
import { finestStep, isIdentity, setTransform, transformText } from "../mapping.js";
import { svgName } from "../markup.js";
import { neededBy } from "./references.js";

/** Marks a layer of the clipboard that is not one: its curves were copied without their layer. */
export const CURVES_MARK = "data-curves";

/** Prefixes as they are declared around elements, the nearest first. */
function declarations(elements: readonly ElementNode[]): Map<string, string> {
  const found = new Map<string, string>();
  for (const element of elements) {
    for (let outer = element.parent; outer; outer = outer.parent) {
      for (const { name, value } of outer.attributes) {
        if (declaredPrefix(name) !== null && !found.has(name)) found.set(name, value);
      }
    }
  }
  return found;
}

/** The outermost start tag of a text of its own that holds elements of this document. */
export function rootTag(d: Drawing, elements: readonly ElementNode[]): { tag: string; sf: string } {
  const declared = declarations(elements);
  if (!declared.has("xmlns") && d.root.name === "svg") declared.set("xmlns", SVG);
  let sf = prefixOf(d.root, SFUMATO);
  if (sf === null) {
    sf = declared.has("xmlns:sf") ? "sfumato" : "sf";
    declared.set(`xmlns:${sf}`, SFUMATO);
  }
  const [x0, y0, x1, y1] = d.artboard;
  const attributes = [
    ...declared,
    ["viewBox", [x0, y0, x1 - x0, y1 - y0].join(" ")],
    [`${sf}:version`, "1"],
  ].map(([name, value]) => ` ${name}="${encodeValue(value, '"')}"`);
  return { tag: `<${d.root.name}${attributes.join("")}>`, sf };
}

/** SVG text of items, with what they refer to, that paste() takes. */
export function copyItems(d: Drawing, handles: readonly Handle[]): string {
  const items = outermost(d, handles);
  const elements = items.map(({ element }) => element);
  const { tag, sf } = rootTag(d, elements);
  const draft = new Draft(d.text);
  const styles = new Styles(d.text, d.root);
  const needed = neededBy(elements, d.ids);
  const lines = [tag];
  if (needed.length > 0) {
    const defs = svgName(d.root, "defs");
    const texts = needed.map((it) => `    ${draft.rewritten(it, inlineEdits(d.text, styles, it))}`);
    lines.push(`  <${defs}>`, ...texts, `  </${defs}>`);
  }
  for (const run of runsOfOneFrame(items)) {
    if (layerOf(run[0].parent)) lines.push(...curvesText(d, draft, styles, run, sf));
    else lines.push(...run.map((item) => `  ${placedText(d, draft, styles, item)}`));
  }
  return `${[...lines, `</${d.root.name}>`].join("\n")}\n`;
}

/** Items one after another that have one parent. */
function runsOfOneFrame(items: readonly Item[]): Item[][] {
  const runs: Item[][] = [];
  for (const item of items) {
    const last = runs.at(-1);
    if (last && last[0].parent === item.parent) last.push(item);
    else runs.push([item]);
  }
  return runs;
}

function curvesText(
  d: Drawing,
  draft: Draft,
  styles: Styles,
  items: readonly Item[],
  sf: string,
): string[] {
  const g = svgName(d.root, "g");
  const frame = transformText(outerFrame(items[0]), 1, finestStep(d));
  const placed = frame === null ? "" : ` transform="${frame}"`;
  const texts = items.map(
    ({ element }) => `    ${draft.rewritten(element, inlineEdits(d.text, styles, element))}`,
  );
  return [`  <${g} ${sf}:diffuse="true" ${CURVES_MARK}="true"${placed}>`, ...texts, `  </${g}>`];
}

/** With the whole way to the artboard as its transform. */
function placedText(d: Drawing, draft: Draft, styles: Styles, item: Item): string {
  const isThere = isIdentity(outerFrame(item), 1, 1e-12);
  const edits = isThere ? [] : setTransform(d, item.element, item.artboardFromItem, finestStep(d));
  return draft.rewritten(item.element, [...edits, ...inlineEdits(d.text, styles, item.element)]);
}
