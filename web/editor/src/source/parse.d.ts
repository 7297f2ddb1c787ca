// contract
import type { ElementNode } from "./tree.js";

/** The outermost element of an XML file. @throws SourceError */
export function parse(text: string): ElementNode;
