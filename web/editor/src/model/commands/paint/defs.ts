// <defs> of a document: what is put there.
import type { Drawing } from "../../types.js";
import type { Draft } from "../curves/draft.js";
import { childLead, deeperLead, insertion } from "../structure/layout.js";
import { svgName } from "../markup.js";
import type { ElementNode } from "../../../source/tree.js";
import { SVG } from "../../../source/attributes.js";

/** Elements at the head of a document that draw nothing. */
const HEAD = new Set(["title", "desc", "metadata", "style", "namedview", "script"]);

/**
 * Puts markup into the document's <defs>, which is made where there is none.
 * @param going elements that the same draft removes: they are no place to stand behind
 */
export function intoDefs(
  d: Drawing,
  draft: Draft,
  pieces: readonly string[],
  going: readonly ElementNode[] = [],
): void {
  if (pieces.length === 0) return;
  const { text, root } = d;
  const stays = (element: ElementNode) => !going.includes(element);
  const isDefs = ({ local, namespace }: ElementNode) => local === "defs" && namespace === SVG;
  const defs = root.children.find((child) => isDefs(child) && stays(child));
  if (defs) {
    const after = defs.children.filter(stays).at(-1) ?? null;
    draft.add([insertion(text, defs, after, pieces).edit]);
    return;
  }
  const behindHead = root.children.findIndex(({ local }) => !HEAD.has(local));
  const head = behindHead < 0 ? root.children.length : behindHead;
  const lead = childLead(text, root);
  const inner = deeperLead(text, root, lead);
  const name = svgName(root, "defs");
  const markup = `<${name}>${pieces.map((piece) => inner + piece).join("")}${lead}</${name}>`;
  draft.add([insertion(text, root, root.children[head - 1] ?? null, [markup]).edit]);
}
