// Parts of curves that can be chosen.
import type { Part } from "../model/types.js";

export function isSamePart(a: Part, b: Part): boolean {
  const [mine, others] = [Object.entries(a), new Map(Object.entries(b))];
  return mine.length === others.size && mine.every(([name, value]) => others.get(name) === value);
}
