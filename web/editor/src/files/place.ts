// Where a drawing was read from, and is saved to.
import type { TextForm } from "./text.js";
import { plainForm } from "./text.js";

export type Target =
  /** Nowhere that can be written again: saving asks, or downloads. */
  | { readonly kind: "none" }
  /** `modified`: of the file when it was last read or written. */
  | { readonly kind: "handle"; readonly handle: FileSystemFileHandle; readonly modified: number }
  /** `sfumato edit` holds the file; `tag`: its content when it was last read or written. */
  | { readonly kind: "served"; readonly tag: string };

export interface Place {
  readonly name: string;
  readonly form: TextForm;
  readonly target: Target;
  /** A drawing of the gallery: the editor has the pictures that it names. */
  readonly isExample?: true;
}

/** Returns whether a stored value is a place; a damaged one is not. */
export function isPlace(value: unknown): value is Place {
  const { name, form, target } = (value ?? {}) as Partial<Place>;
  return typeof name === "string" && typeof form?.encoding === "string" && typeof target?.kind === "string";
}

/** The result of saving. */
export type Saved =
  /** The drawing is safe there. */
  | { readonly kind: "saved"; readonly place: Place }
  /** The browser received the file; nothing reports whether it arrived. */
  | { readonly kind: "downloaded"; readonly place: Place }
  /** The person left the dialog. */
  | { readonly kind: "cancelled" }
  /** Somebody else has written the file since: save() with `anyway` replaces it. */
  | { readonly kind: "changed"; readonly reason: string }
  | { readonly kind: "problem"; readonly reason: string };

/** Returns the place of a drawing without a file. */
export const newPlace = (name: string): Place => ({ name, form: plainForm, target: { kind: "none" } });

/** A name with an extension in the place of its own: "a.xml", "svg" → "a.svg". */
export function withExtension(name: string, extension: string): string {
  return `${name.replace(/(?<=[^/\\])\.(svgz?|xml|png|html?|pdf)$/i, "")}.${extension}`;
}
