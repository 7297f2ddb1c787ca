// Changes of the text, one after another, as one.
import type { Change, Handle } from "../model/types.js";

export function united(changes: readonly Change[]): Change {
  const touched = new Map<Handle, Set<string>>();
  for (const change of changes) {
    for (const [handle, names] of change.touched) {
      const all = touched.get(handle) ?? new Set();
      names.forEach((name) => all.add(name));
      touched.set(handle, all);
    }
  }
  return { isStructural: changes.some((change) => change.isStructural), touched };
}
