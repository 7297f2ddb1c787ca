// contract: a lossless tree over the text of an XML file. Elements and attributes have places; everything
// else is text between them that is never analysed.

/** UTF-16 units of the text: from, and up to. */
export interface Range {
  readonly start: number;
  readonly end: number;
}

export interface AttributeNode {
  /** As written, with its prefix. */
  readonly name: string;
  readonly local: string;
  /** "" where the attribute has no prefix. */
  readonly namespace: string;
  /** Between the quotes, entities and line ends decoded. */
  readonly value: string;
  /** From the name's first character to behind the closing quote. */
  readonly range: Range;
  /** Between the quotes. */
  readonly valueRange: Range;
  readonly quote: '"' | "'";
}

export interface ElementNode {
  readonly name: string;
  readonly local: string;
  readonly namespace: string;
  readonly parent: ElementNode | null;
  readonly children: readonly ElementNode[];
  readonly attributes: readonly AttributeNode[];
  /** From `<` to behind the end tag. */
  readonly range: Range;
  /** From `<` to behind `>` of the start tag. */
  readonly startTag: Range;
  /** Between start and end tag; of an element that closes itself the place at its end. */
  readonly content: Range;
  readonly closesItself: boolean;
  /** Returns the same number for the same element throughout its life, also after edits of the text. */
  readonly handle: number;
}

/** XML that cannot be read: where, and in words for its author. */
export class SourceError extends Error {
  constructor(
    readonly reason: string,
    readonly offset: number,
    /** From 1. */
    readonly line: number,
    readonly column: number,
  ) {
    super(`Line ${line}, column ${column}: ${reason}`);
  }
}
