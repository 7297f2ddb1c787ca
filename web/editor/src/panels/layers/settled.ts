// The drawing after it has rested: for what may lag behind a drag (thumbs, counts of copies).
import { computed, effect, signal, type ReadonlySignal } from "@preact/signals";
import type { Editor } from "../../app/types.js";
import type { Handle } from "../../model/types.js";

/** Milliseconds. */
const REST = 250;

export interface Settled {
  /** Grows when the drawing has changed and come to rest. */
  readonly revision: ReadonlySignal<number>;
  /** How many <use> show an item. */
  readonly uses: ReadonlySignal<ReadonlyMap<Handle, number>>;
}

const known = new WeakMap<Editor, Settled>();

function countUses(editor: Editor): ReadonlyMap<Handle, number> {
  const uses = new Map<Handle, number>();
  for (const item of editor.drawing.all()) {
    if (item.kind === "use" && item.target)
      uses.set(item.target.handle, (uses.get(item.target.handle) ?? 0) + 1);
  }
  return uses;
}

/** One for each editor, kept as long as it exists. */
export function settledOf(editor: Editor): Settled {
  const found = known.get(editor);
  if (found) return found;
  const revision = signal(editor.drawing.revision);
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const now = editor.drawing.revision;
    clearTimeout(timer);
    timer = setTimeout(() => {
      revision.value = now;
    }, REST);
  });
  let counted: { revision: number; uses: ReadonlyMap<Handle, number> } = {
    revision: -1,
    uses: new Map(),
  };
  const uses = computed(() => {
    if (counted.revision !== revision.value)
      counted = { revision: revision.value, uses: countUses(editor) };
    return counted.uses;
  });
  const settled = { revision, uses };
  known.set(editor, settled);
  return settled;
}
