// Drawings that this browser keeps, so that no closed or killed page loses one.
import { createStore, delMany, get, getMany, keys, setMany } from "idb-keyval";
import type { UseStore } from "idb-keyval";

/** The data that a list of stored drawings shows. */
export interface KeptHead {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly time: number;
  readonly curves: number;
}

/** A drawing as it is kept. `undo`, `place`: whatever can be cloned; the log of undo, and where it was opened. */
export interface KeptDrawing {
  readonly text: string;
  readonly undo: unknown;
  readonly place: unknown;
}

export interface Kept extends KeptHead, KeptDrawing {}

/** Where the newest state is: in this browser, or nowhere, and why. */
export type KeptWhere =
  | { readonly kept: "browser" }
  | { readonly kept: "nowhere"; readonly lost: "refused" | "full" };

export const mostKept = 20;
export const pauseBeforeKeeping = 1000;

/** The database; opened at the first request, since a browser may refuse it. */
export const editorStore = (): UseStore => createStore("sfumato-editor", "drawings");

const headKey = (id: string) => `head:${id}`;
const bodyKey = (id: string) => `body:${id}`;

const isFull = (error: unknown) => error instanceof DOMException && error.name === "QuotaExceededError";

/** The newest first. Empty where the browser refuses. */
export async function keptDrawings(store: UseStore = editorStore()): Promise<readonly KeptHead[]> {
  try {
    const heads = (await keys<string>(store)).filter((key) => key.startsWith("head:"));
    const found = await getMany<KeptHead>(heads, store);
    return found.filter((head) => head !== undefined).sort((a, b) => b.time - a.time);
  } catch {
    return [];
  }
}

/** @returns null where it is gone, or the browser refuses */
export async function recoverDrawing(id: string, store: UseStore = editorStore()): Promise<Kept | null> {
  try {
    const head = await get<KeptHead>(headKey(id), store);
    const body = await get<KeptDrawing>(bodyKey(id), store);
    return head && body ? { ...head, ...body } : null;
  } catch {
    return null;
  }
}

export async function forgetDrawings(ids: readonly string[], store: UseStore = editorStore()): Promise<void> {
  await delMany(ids.flatMap((id) => [headKey(id), bodyKey(id)]), store).catch(() => undefined);
}

/** Keeps head and body in one transaction: a killed page leaves the last state or this one. @throws DOMException */
async function keep(kept: Kept, store: UseStore): Promise<void> {
  const { text, undo, place, ...head } = kept;
  const body: KeptDrawing = { text, undo, place };
  await setMany([[headKey(kept.id), head], [bodyKey(kept.id), body]], store);
}

async function prune(own: string, store: UseStore): Promise<void> {
  const kept = await keptDrawings(store);
  const old = kept.filter(({ id }) => id !== own).slice(mostKept - 1);
  if (old.length > 0) await forgetDrawings(old.map(({ id }) => id), store);
}

type State = Omit<Kept, "id" | "time">;

/** Keeps the drawing that a page works on, a second after its last edit. */
export class Autosave {
  #id: string;
  #timer: ReturnType<typeof setTimeout> | null = null;
  #waiting: (() => State) | null = null;
  /** Writes follow one another. */
  #last: Promise<void> = Promise.resolve();
  #store: UseStore | null = null;

  /** @param tell called whenever a state was stored, or could not be */
  constructor(
    private readonly tell: (where: KeptWhere) => void,
    private readonly open: () => UseStore = editorStore,
  ) {
    this.#id = crypto.randomUUID();
  }

  get id(): string {
    return this.#id;
  }

  /** Switches to another drawing; `id`: that of a recovered one. Stores pending changes first. */
  begin(id: string = crypto.randomUUID()): void {
    void this.flush();
    this.#id = id;
  }

  /** Whether an edit has come that is not being written yet. */
  get isWaiting(): boolean {
    return this.#waiting !== null;
  }

  /** An edit: `state` is called when the drawing is kept. */
  edited(state: () => State): void {
    this.#waiting = state;
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.flush(), pauseBeforeKeeping);
  }

  /** Keeps at once what waits: when the page is hidden. */
  flush(): Promise<void> {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    const state = this.#waiting;
    this.#waiting = null;
    if (!state) return this.#last;
    const kept: Kept = { ...state(), id: this.#id, time: Date.now() };
    return (this.#last = this.#last.then(() => this.#keep(kept)));
  }

  /** Drops pending changes: another tab edits the drawing now. */
  drop(): void {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = this.#waiting = null;
  }

  /** The drawing is safe in a file. */
  forget(): Promise<void> {
    this.drop();
    const id = this.#id;
    return (this.#last = this.#last.then(() => forgetDrawings([id], this.#opened())).catch(() => undefined));
  }

  #opened(): UseStore {
    return (this.#store ??= this.open());
  }

  async #keep(kept: Kept): Promise<void> {
    try {
      await keep(kept, this.#opened());
      await prune(kept.id, this.#opened());
      this.tell({ kept: "browser" });
    } catch (error) {
      this.#store = null;
      this.tell({ kept: "nowhere", lost: isFull(error) ? "full" : "refused" });
    }
  }
}
