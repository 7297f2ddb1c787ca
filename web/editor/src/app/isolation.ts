// The isolated layer or group. It belongs to the view, not to the file, and follows its element through edits.
import { computed, signal } from "@preact/signals";
import { isHidden, isWithin } from "../model/standing.js";
import type { Drawing, Handle, Item } from "../model/types.js";
import { valueOf } from "../source/attributes.js";

export class Isolation {
  readonly #kept = signal<{ readonly handle: Handle; readonly id: string | null } | null>(null);

  /** @param drawing returns the present drawing; reading it subscribes */
  constructor(readonly drawing: () => Drawing) {}

  /** null: nothing is isolated. */
  readonly handle = computed(() => this.#item()?.handle ?? null);

  /** An element that an edit has moved is another item, with the same id. */
  #item(): Item | null {
    const kept = this.#kept.value;
    if (!kept) return null;
    const drawing = this.drawing();
    const hasId = ({ element }: Item) => kept.id !== null && valueOf(element, "id") === kept.id;
    const item = drawing.item(kept.handle) ?? [...drawing.all()].find(hasId);
    return item && !isHidden(item) ? item : null;
  }

  /** Isolates an item, unless it is hidden; null: ends the isolation. */
  set(handle: Handle | null): void {
    const item = handle === null ? undefined : this.drawing().item(handle);
    this.#kept.value = item && !isHidden(item) ? { handle: item.handle, id: valueOf(item.element, "id") ?? null } : null;
  }

  /** After an edit: an item that is gone or hidden is not isolated again. */
  follow(): void {
    this.set(this.handle.value);
  }

  /** Whether an item may be edited: also between an edit and follow(). */
  has(item: Item | null): boolean {
    const around = this.#item();
    return around === null || isWithin(item, new Set([around.handle]));
  }
}
