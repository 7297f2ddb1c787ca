// The tree's nodes as the parser makes them. Places within an element count from its own `<`, so
// that an edit moves the elements behind it by one number each.
import type { AttributeNode, ElementNode, Range } from "./tree.js";

export class Attribute implements AttributeNode {
  constructor(
    readonly owner: Element,
    readonly name: string,
    readonly local: string,
    readonly namespace: string,
    readonly value: string,
    /** Places of the name, the value and the closing quote, from the element's `<`. */
    readonly nameAt: number,
    readonly valueAt: number,
    readonly valueEnd: number,
    readonly quote: '"' | "'",
  ) {}

  get range(): Range {
    return { start: this.owner.at + this.nameAt, end: this.owner.at + this.valueEnd + 1 };
  }

  get valueRange(): Range {
    return { start: this.owner.at + this.valueAt, end: this.owner.at + this.valueEnd };
  }
}

export class Element implements ElementNode {
  readonly children: Element[] = [];
  attributes: readonly Attribute[] = [];
  /** Lengths from `<`: of the start tag, up to the end tag, of all. */
  tagLength = 0;
  contentLength = 0;
  length = 0;

  constructor(
    readonly parent: Element | null,
    readonly name: string,
    readonly local: string,
    readonly namespace: string,
    public handle: number,
    /** Where `<` stands. */
    public at: number,
    readonly closesItself: boolean,
  ) {}

  get range(): Range {
    return { start: this.at, end: this.at + this.length };
  }

  get startTag(): Range {
    return { start: this.at, end: this.at + this.tagLength };
  }

  get content(): Range {
    return { start: this.at + this.tagLength, end: this.at + this.contentLength };
  }
}

/** An element and all within, each before its children; of any depth. */
export function* elementsOf<Node extends ElementNode>(root: Node): Iterable<Node> {
  const waiting: Node[] = [root];
  for (let node = waiting.pop(); node; node = waiting.pop()) {
    yield node;
    for (let i = node.children.length - 1; i >= 0; i -= 1) waiting.push(node.children[i] as Node);
  }
}
