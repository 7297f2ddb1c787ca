// What a worker's document lacks of the present text, where that can be said by changes of curves.
import type { QuickChange } from "./types.js";

function keyOf(change: QuickChange): string {
  const { kind, layer, curve } = change;
  if (kind === "points") return `${layer} ${curve}`;
  return `${layer} ${curve} ${change.side} ${change.attribute}`;
}

export class Pending {
  /** The last change of each list of points or stops; null: the whole text is needed. */
  #changes: Map<string, QuickChange> | null = null;

  /** @param quick all that changed since the text before, or undefined where that cannot be said */
  add(quick: readonly QuickChange[] | undefined): void {
    if (!quick) return this.lose();
    for (const change of quick) this.#changes?.set(keyOf(change), change);
  }

  /** The whole text is needed. */
  lose(): void {
    this.#changes = null;
  }

  /** Nothing is lacking. */
  reset(): void {
    this.#changes = new Map();
  }

  /** What is to be brought now; null: the whole text. Afterwards nothing is lacking. */
  take(): readonly QuickChange[] | null {
    const changes = this.#changes && [...this.#changes.values()];
    this.reset();
    return changes;
  }
}
