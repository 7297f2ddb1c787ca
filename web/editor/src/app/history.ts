// Steps of undo: patches, with the selection before and after each.
import { signal, type ReadonlySignal } from "@preact/signals";
import { inverse, type Patch } from "../source/patch.js";
import type { Part } from "../model/types.js";

/** A selection, by places in the text of that time. */
export type Places = readonly { readonly at: number; readonly part: Part }[];

export interface Step {
  readonly label: string;
  readonly patch: Patch;
  readonly before: Places;
  readonly after: Places;
  /** Steps with the same number are undone together. */
  readonly group: number;
}

/** The history, as autosave stores it. */
export interface HistoryLog {
  readonly done: readonly Step[];
  readonly undone: readonly Step[];
}

const hasFields = (value: unknown, fields: Readonly<Record<string, (field: unknown) => boolean>>): boolean =>
  typeof value === "object" && value !== null &&
  Object.entries(fields).every(([name, isGood]) => isGood((value as Record<string, unknown>)[name]));
const isText = (value: unknown) => typeof value === "string";
const isNumber = (value: unknown) => typeof value === "number";
const isListOf = (isGood: (value: unknown) => boolean) => (value: unknown) => Array.isArray(value) && value.every(isGood);
const isEdit = (value: unknown) => hasFields(value, { at: isNumber, removed: isText, inserted: isText });
const isPlace = (value: unknown) => hasFields(value, { at: isNumber });
const isStep = (value: unknown) =>
  hasFields(value, { label: isText, patch: isListOf(isEdit), before: isListOf(isPlace), after: isListOf(isPlace), group: isNumber });

/** Returns whether a stored value is a history; a damaged one is not. */
export const isHistoryLog = (value: unknown): value is HistoryLog =>
  hasFields(value, { done: isListOf(isStep), undone: isListOf(isStep) });

/** The most characters of all patches. The oldest steps are dropped first. */
const MOST_CHARACTERS = 20e6;
/** A step of the same kind joins the last one within this time, milliseconds. */
const MERGE_TIME = 800;

function sizeOf({ patch }: Step): number {
  return patch.reduce((sum, edit) => sum + edit.removed.length + edit.inserted.length, 200);
}

/** Returns a copy. A substring would keep the whole text in memory. */
const detached = (patch: Patch): Patch => JSON.parse(JSON.stringify(patch)) as Patch;

/** A list of steps that keeps count of its size. */
class Steps {
  #size: number;

  constructor(readonly list: Step[]) {
    this.#size = list.reduce((sum, step) => sum + sizeOf(step), 0);
  }

  get last(): Step | undefined {
    return this.list.at(-1);
  }

  add(step: Step): void {
    this.list.push(step);
    this.#size += sizeOf(step);
  }

  /** Removes the last group of steps. @returns the steps, the last one first */
  takeGroup(): Step[] {
    const group = this.last?.group;
    const steps: Step[] = [];
    while (this.last && this.last.group === group) steps.push(this.list.pop()!);
    for (const step of steps) this.#size -= sizeOf(step);
    return steps;
  }

  /** Removes the oldest steps until the size is within a limit, but never the last step. */
  shorten(most: number): void {
    while (this.#size > most && this.list.length > 1) this.#size -= sizeOf(this.list.shift()!);
  }
}

export class History {
  #done = new Steps([]);
  #undone = new Steps([]);
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

  /** @param merge a step soon after one with the same key joins it; "" never joins */
  push(step: Omit<Step, "group">, merge = "", now = performance.now()): void {
    const isMerged =
      merge !== "" && this.#merge?.key === merge && now - this.#merge.time < MERGE_TIME;
    if (!isMerged) this.#group += 1;
    this.#merge = { key: merge, time: now };
    this.#done.add({ ...step, patch: detached(step.patch), group: this.#group });
    this.#undone = new Steps([]);
    this.#done.shorten(MOST_CHARACTERS);
    this.#show();
  }

  /** Undoes the last group. @returns the patches to apply, in order; empty if there is no step */
  undo(): readonly { readonly patch: Patch; readonly select: Places }[] {
    const steps = this.#take(this.#done, this.#undone);
    return steps.map((step) => ({ patch: inverse(step.patch), select: step.before }));
  }

  redo(): readonly { readonly patch: Patch; readonly select: Places }[] {
    const steps = this.#take(this.#undone, this.#done);
    return steps.map((step) => ({ patch: step.patch, select: step.after }));
  }

  /** Moves the last group from one list to the other. */
  #take(from: Steps, to: Steps): Step[] {
    const steps = from.takeGroup();
    for (const step of steps) to.add(step);
    this.#merge = null;
    this.#show();
    return steps;
  }

  get log(): HistoryLog {
    return { done: [...this.#done.list], undone: [...this.#undone.list] };
  }

  /** Replaces the whole history. */
  restore({ done, undone }: HistoryLog): void {
    this.#done = new Steps([...done]);
    this.#undone = new Steps([...undone]);
    this.#group = [...done, ...undone].reduce((most, step) => Math.max(most, step.group), 0);
    this.#merge = null;
    this.#show();
  }

  #show() {
    this.#undoLabel.value = this.#done.last?.label ?? null;
    this.#redoLabel.value = this.#undone.last?.label ?? null;
  }
}
