// Where a drawing was read from, and is saved to.
import type { TextForm } from "./text.js";
import { plainForm } from "./text.js";

export type Target =
  /** Nowhere that can be written again: saving asks, or downloads. */
  | { readonly kind: "none" }
  /** `modified`: of the file when it was last read or written. */
  | { readonly kind: "handle"; readonly handle: FileSystemFileHandle; readonly modified: number }
  /** `sfumato edit` has it; `tag`: what it held when it was last read or written. */
  | { readonly kind: "served"; readonly tag: string };

export interface Place {
  readonly name: string;
  readonly form: TextForm;
  readonly target: Target;
}

/** Of a drawing that no file has. */
export const newPlace = (name: string): Place => ({ name, form: plainForm, target: { kind: "none" } });

/** A name with an extension in the place of its own: "a.xml", "svg" → "a.svg". */
export function withExtension(name: string, extension: string): string {
  return `${name.replace(/(?<=[^/\\])\.(svgz?|xml|png|html?)$/i, "")}.${extension}`;
}
