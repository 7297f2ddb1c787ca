// The kind of window.
import { signal, type ReadonlySignal } from "@preact/signals";

const known = new Map<string, ReadonlySignal<boolean>>();

/** Returns a signal of whether a media query holds; one for each query, kept until the page closes. */
export function media(query: string): ReadonlySignal<boolean> {
  const found = known.get(query);
  if (found) return found;
  const list = matchMedia(query);
  const holds = signal(list.matches);
  list.addEventListener("change", () => {
    holds.value = list.matches;
  });
  known.set(query, holds);
  return holds;
}

/** Panels are a sheet and tools a row. */
export const isPhone = () => media("(max-width: 799px)");
