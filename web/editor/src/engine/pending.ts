// The changes of curves that bring a worker's document up to the present text.
import type { QuickChange } from "./types.js";

function keyOf(change: QuickChange): string {
  const { kind, layer, curve } = change;
  if (kind === "points") return `${layer} ${curve}`;
  return `${layer} ${curve} ${change.side} ${change.attribute}`;
}

export class Pending {
  /** The last change of each list of points or stops; null: the whole text is needed. */
  #changes: Map<string, QuickChange> | null = null;

  /** @param quick all changes since the previous text, or undefined if only the text has them */
  add(quick: readonly QuickChange[] | undefined): void {
    if (!quick) return this.lose();
    for (const change of quick) this.#changes?.set(keyOf(change), change);
  }

  /** Notes that the whole text is needed. */
  lose(): void {
    this.#changes = null;
  }

  /** Notes that the worker's document is up to date. */
  reset(): void {
    this.#changes = new Map();
  }

  /** Returns the changes to send now; null: send the whole text. Then calls reset(). */
  take(): readonly QuickChange[] | null {
    const changes = this.#changes && [...this.#changes.values()];
    this.reset();
    return changes;
  }
}
