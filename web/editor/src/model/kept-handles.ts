// Which elements live through a change of the text.
import type { Element } from "../source/nodes.js";
import type { Patch } from "../source/patch.js";

/**
 * Gives elements that lived through a patch their old handles.
 * @returns those whose attributes are also as they were
 */
export function keepHandles(
  before: readonly Element[],
  now: readonly Element[],
  patch: Patch,
): Element[] {
  const old = new Map<number, Element>();
  let next = 0;
  let shift = 0;
  for (const element of before) {
    // Edits that end at or before `<`.
    for (; next < patch.length; next += 1) {
      const { at, removed, inserted } = patch[next];
      if (at + removed.length > element.at) break;
      shift += inserted.length - removed.length;
    }
    const edit = patch[next];
    if (!edit || edit.at > element.at) old.set(element.at + shift, element);
  }
  const same: Element[] = [];
  for (const element of now) {
    const lived = old.get(element.at);
    if (!lived) continue;
    // Also under another name: a circle that became a path is the same curve.
    element.handle = lived.handle;
    if (lived.name === element.name && hasSameAttributes(lived, element)) same.push(element);
  }
  return same;
}

function hasSameAttributes(a: Element, b: Element): boolean {
  if (a.attributes.length !== b.attributes.length) return false;
  return a.attributes.every(({ local, namespace, value }, i) => {
    const other = b.attributes[i];
    return other.local === local && other.namespace === namespace && other.value === value;
  });
}
