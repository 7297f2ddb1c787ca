// Changes of a text, and what undoes them.

/**
 * `removed` stands at `at` in the text before, and `inserted` takes its place. Offsets count UTF-16
 * units.
 */
export interface Edit {
  readonly at: number;
  readonly removed: string;
  readonly inserted: string;
}

/** Edits in ascending order that do not overlap; all offsets refer to the text before. */
export type Patch = readonly Edit[];

/** @throws RangeError where the text is not the one that the patch was made for */
export function applied(text: string, patch: Patch): string {
  const parts: string[] = [];
  let at = 0;
  for (const edit of patch) {
    const end = edit.at + edit.removed.length;
    if (edit.at < at || text.slice(edit.at, end) !== edit.removed) {
      throw new RangeError("the patch is for another text");
    }
    parts.push(text.slice(at, edit.at), edit.inserted);
    at = end;
  }
  parts.push(text.slice(at));
  return parts.join("");
}

/** The patch that leads back. */
export function inverse(patch: Patch): Patch {
  let shift = 0;
  return patch.map(({ at, removed, inserted }) => {
    const back = { at: at + shift, removed: inserted, inserted: removed };
    shift += inserted.length - removed.length;
    return back;
  });
}
