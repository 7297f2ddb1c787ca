// Markup from another text in the prefixes of this one.
import { hrefOf, prefixOf, SFUMATO, sfName, SVG, XLINK } from "../../../source/attributes.js";
import { parse } from "../../../source/parse.js";
import { applied } from "../../../source/patch.js";
import type { Edit } from "../../../source/patch.js";
import type { AttributeNode, ElementNode } from "../../../source/tree.js";
import { removalOf } from "../structure/layout.js";
import { svgName } from "../markup.js";
import { within } from "../structure/references.js";

/** Returns the name of an attribute within `parent`; null: it would have no meaning there. */
function attributeName(parent: ElementNode, owner: ElementNode, it: AttributeNode): string | null {
  const { name, local, namespace } = it;
  if (namespace === "" || name.startsWith("xml:") || name.startsWith("xmlns")) return name;
  if (namespace === SFUMATO) return sfName(parent, local);
  const prefix = prefixOf(parent, namespace);
  if (prefix !== null) return `${prefix}:${local}`;
  return namespace === XLINK && local === "href" && hrefOf(owner) === it ? "href" : null;
}

function elementEdits(text: string, parent: ElementNode, element: ElementNode): Edit[] | null {
  const { name, local, namespace, range, closesItself } = element;
  const prefix = namespace === SVG ? null : prefixOf(parent, namespace);
  if (namespace !== SVG && prefix === null) return null;
  const to = prefix === null ? svgName(parent, local) : `${prefix}:${local}`;
  const edits: Edit[] = [];
  const rename = (at: number, from: string, inserted: string) => {
    if (from !== inserted) edits.push({ at, removed: from, inserted });
  };
  rename(range.start + 1, name, to);
  for (const attribute of element.attributes) {
    const spelled = attributeName(parent, element, attribute);
    const { start, end } = attribute.range;
    if (spelled !== null) rename(start, attribute.name, spelled);
    else edits.push({ at: start - 1, removed: text.slice(start - 1, end), inserted: "" });
  }
  if (!closesItself) rename(element.content.end + 2, name, to);
  return edits;
}

/**
 * Returns the markup of one element, whose prefixes `rootTag` declares, as it must stand within `parent`.
 * Leaves out content of programs that the document there does not know.
 */
export function respelled(rootTag: string, markup: string, parent: ElementNode): string {
  const root = parse(`${rootTag}${markup}</${/^<([^\s>]+)/.exec(rootTag)?.[1] ?? "svg"}>`);
  const text = rootTag + markup;
  const edits: Edit[] = [];
  let behind = 0;
  for (const element of within(root.children[0])) {
    if (element.range.start < behind) continue;
    const own = elementEdits(text, parent, element);
    if (own) {
      edits.push(...own);
      continue;
    }
    const { start, end } = removalOf(text, element.range);
    edits.push({ at: start, removed: text.slice(start, end), inserted: "" });
    behind = end;
  }
  return applied(text, edits.sort((a, b) => a.at - b.at)).slice(rootTag.length);
}
