// contract
import type { Drawing, Handle, Outcome } from "../types.js";

/** SVG text of items, with what they refer to, that paste() takes. */
export function copyItems(d: Drawing, handles: readonly Handle[]): string;
/** @throws SourceError where the text is none of that kind */
export function paste(d: Drawing, text: string, into: Handle | null): Outcome | null;
