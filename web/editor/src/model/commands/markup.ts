// New elements as text, in the names and quotes of where they are to stand.
import { encodeValue } from "../../source/entities.js";
import type { ElementNode } from "../../source/tree.js";

/** Names as they are to be written, with values; null leaves an attribute out. */
export type WrittenAttributes = readonly (readonly [name: string, value: string | null])[];

/** The name of an element of SVG within `parent`: with the prefix that its own name has. */
export function svgName(parent: ElementNode, local: string): string {
  return parent.name.slice(0, parent.name.length - parent.local.length) + local;
}

/** A start tag, without its `>` or `/>`. */
export function opening(
  parent: ElementNode,
  local: string,
  attributes: WrittenAttributes,
): string {
  const quote = quoteWithin(parent);
  const written = attributes.map(([name, value]) =>
    value === null ? "" : ` ${name}=${quote}${encodeValue(value, quote)}${quote}`,
  );
  return `<${svgName(parent, local)}${written.join("")}`;
}

/** The quote that attributes near by have. */
function quoteWithin(parent: ElementNode): '"' | "'" {
  const near = parent.children.find((child) => child.attributes.length > 0) ?? parent;
  return near.attributes[0]?.quote ?? '"';
}
