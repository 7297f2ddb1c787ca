// Steps of undo: patches, with what was selected before and after.
import { signal, type ReadonlySignal } from "@preact/signals";
import { inverse, type Patch } from "../source/patch.js";
import type { Part } from "../model/types.js";

/** What was selected, by places in the text of that time. */
export type Places = readonly { readonly at: number; readonly part: Part }[];

export interface Step {
  readonly label: string;
  readonly patch: Patch;
  readonly before: Places;
  readonly after: Places;
  /** Steps of one number are undone together. */
  readonly group: number;
}

/** As autosave keeps it. */
export interface HistoryLog {
  readonly done: readonly Step[];
  readonly undone: readonly Step[];
}

/** Characters of all patches; the oldest steps go first. */
const MOST_CHARACTERS = 20e6;
/** Within this a step of the same kind joins the last one, milliseconds. */
const MERGE_TIME = 800;

function sizeOf({ patch }: Step): number {
  return patch.reduce((sum, edit) => sum + edit.removed.length + edit.inserted.length, 200);
}

/** Parts of a text hold the whole of it in memory: copies do not. */
const detached = (patch: Patch): Patch => JSON.parse(JSON.stringify(patch)) as Patch;

export class History {
  #done: Step[] = [];
  #undone: Step[] = [];
  #size = 0;
  #group = 0;
  #merge: { key: string; time: number } | null = null;
  readonly #undoLabel = signal<string | null>(null);
  readonly #redoLabel = signal<string | null>(null);

  get undoLabel(): ReadonlySignal<string | null> {
    return this.#undoLabel;
  }
  get redoLabel(): ReadonlySignal<string | null> {
    return this.#redoLabel;
  }

  /** @param merge steps with the same key, one soon after the other, are one; "" never */
  push(step: Omit<Step, "group">, merge = "", now = performance.now()): void {
    const isMerged =
      merge !== "" && this.#merge?.key === merge && now - this.#merge.time < MERGE_TIME;
    if (!isMerged) this.#group += 1;
    this.#merge = { key: merge, time: now };
    this.#done.push({ ...step, patch: detached(step.patch), group: this.#group });
    this.#size += sizeOf(step as Step);
    this.#undone = [];
    while (this.#size > MOST_CHARACTERS && this.#done.length > 1) {
      this.#size -= sizeOf(this.#done.shift()!);
    }
    this.#show();
  }

  /** Patches that lead back, in the order in which they apply; empty where there are none. */
  undo(): readonly { readonly patch: Patch; readonly select: Places }[] {
    const steps = this.#take(this.#done, this.#undone);
    return steps.map((step) => ({ patch: inverse(step.patch), select: step.before }));
  }

  redo(): readonly { readonly patch: Patch; readonly select: Places }[] {
    const steps = this.#take(this.#undone, this.#done);
    return steps.map((step) => ({ patch: step.patch, select: step.after }));
  }

  /** Moves the last group from one list to the other. */
  #take(from: Step[], to: Step[]): Step[] {
    const group = from.at(-1)?.group;
    const steps: Step[] = [];
    while (from.length > 0 && from.at(-1)!.group === group) steps.push(from.pop()!);
    to.push(...steps);
    this.#merge = null;
    this.#show();
    return steps;
  }

  get log(): HistoryLog {
    return { done: [...this.#done], undone: [...this.#undone] };
  }

  /** Takes the place of all that was done. */
  restore({ done, undone }: HistoryLog): void {
    this.#done = [...done];
    this.#undone = [...undone];
    this.#size = done.reduce((sum, step) => sum + sizeOf(step), 0);
    this.#group = [...done, ...undone].reduce((most, step) => Math.max(most, step.group), 0);
    this.#merge = null;
    this.#show();
  }

  #show() {
    this.#undoLabel.value = this.#done.at(-1)?.label ?? null;
    this.#redoLabel.value = this.#undone.at(-1)?.label ?? null;
  }
}
