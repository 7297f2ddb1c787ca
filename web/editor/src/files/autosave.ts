// Drawings that this browser keeps, so that no closed or killed page loses one.
import { createStore, delMany, get, getMany, keys, setMany } from "idb-keyval";
import type { UseStore } from "idb-keyval";

/** The data of a stored drawing that is read without its text. */
export interface KeptHead {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly time: number;
  readonly curves: number;
  /** A file has the drawing, or nothing was changed: stored for a reload alone, and not listed. */
  readonly isSafe?: true;
}

/** A stored drawing as lists show it. */
export interface KeptEntry extends KeptHead {
  /** null: none was stored. */
  readonly picture: Blob | null;
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
/** Drawings that are stored for a reload alone: how many, and for how long, milliseconds. */
export const mostSafe = 4;
export const safeTime = 24 * 3600 * 1000;
/** Characters of a text that is stored for a reload alone. */
const mostSafeText = 4e6;
export const pauseBeforeKeeping = 1000;

/** The database; opened at the first request, since a browser may refuse it. */
export const editorStore = (): UseStore => createStore("sfumato-editor", "drawings");

const headKey = (id: string) => `head:${id}`;
const bodyKey = (id: string) => `body:${id}`;
const pictureKey = (id: string) => `picture:${id}`;
const keysOf = (id: string) => [headKey(id), bodyKey(id), pictureKey(id)];

const isFull = (error: unknown) => error instanceof DOMException && error.name === "QuotaExceededError";

function isHead(value: unknown): value is KeptHead {
  const { id, name, time, curves } = (value ?? {}) as Partial<Record<keyof KeptHead, unknown>>;
  return typeof id === "string" && typeof name === "string" && Number.isFinite(time) && Number.isFinite(curves);
}

const isBody = (value: unknown): value is KeptDrawing =>
  typeof value === "object" && typeof (value as Partial<KeptDrawing> | null)?.text === "string";

/** Returns the heads of all stored drawings, the newest first. Omits damaged ones. @throws DOMException */
async function headsIn(store: UseStore): Promise<KeptHead[]> {
  const heads = (await keys<string>(store)).filter((key) => key.startsWith("head:"));
  const found = await getMany<unknown>(heads, store);
  return found.filter(isHead).sort((a, b) => b.time - a.time);
}

/** The newest first. Empty where the browser refuses. */
export async function keptDrawings(store: UseStore = editorStore()): Promise<readonly KeptEntry[]> {
  try {
    const heads = (await headsIn(store)).filter(({ isSafe }) => !isSafe);
    const pictures = await getMany<unknown>(heads.map(({ id }) => pictureKey(id)), store);
    return heads.map((head, i) => ({ ...head, picture: pictures[i] instanceof Blob ? pictures[i] : null }));
  } catch {
    return [];
  }
}

/** @returns null where it is gone or damaged, or the browser refuses */
export async function recoverDrawing(id: string, store: UseStore = editorStore()): Promise<Kept | null> {
  try {
    const [head, body] = await getMany<unknown>([headKey(id), bodyKey(id)], store);
    return isHead(head) && isBody(body) ? { ...head, ...body } : null;
  } catch {
    return null;
  }
}

export async function forgetDrawings(ids: readonly string[], store: UseStore = editorStore()): Promise<void> {
  await delMany(ids.flatMap(keysOf), store).catch(() => undefined);
}

/** Stores the picture of a stored drawing. Does nothing if there is no such drawing, or the browser refuses. */
export async function keepPicture(id: string, picture: Blob, store: UseStore = editorStore()): Promise<void> {
  try {
    const isThere = isHead(await get<unknown>(headKey(id), store));
    if (isThere) await setMany([[pictureKey(id), picture]], store);
  } catch {
    // Lists show a drawing without a picture, too.
  }
}

/** Keeps head and body in one transaction: a killed page leaves the last state or this one. @throws DOMException */
async function keep(kept: Kept, store: UseStore): Promise<void> {
  const { text, undo, place, ...head } = kept;
  const body: KeptDrawing = { text, undo, place };
  await setMany([[headKey(kept.id), head], [bodyKey(kept.id), body]], store);
}

/** Removes the oldest drawings beyond the limits, and drawings that only a reload would have needed. */
async function prune(own: string, store: UseStore): Promise<void> {
  const others = (await headsIn(store)).filter(({ id }) => id !== own);
  const old = others.filter(({ isSafe }) => !isSafe).slice(mostKept - 1);
  const safe = others.filter(({ isSafe }) => isSafe);
  const over = safe.filter(({ time }, i) => i >= mostSafe || Date.now() - time > safeTime);
  const gone = [...old, ...over].map(({ id }) => id);
  if (gone.length > 0) await forgetDrawings(gone, store);
}

type State = Omit<Kept, "id" | "time">;

/** A state that is still to be stored. */
interface Waiting {
  readonly state: () => State;
  readonly isSafe: boolean;
}

/** Keeps the drawing that a page works on, a second after its last edit. */
export class Autosave {
  #id: string;
  #timer: ReturnType<typeof setTimeout> | null = null;
  #waiting: Waiting | null = null;
  /** Whether the drawing is stored for a reload alone. */
  #isSafe = false;
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

  /**
   * Switches to another drawing; `id`: that of a stored one. Stores pending changes first, and removes a
   * drawing that was stored for a reload alone.
   */
  begin(id: string = crypto.randomUUID(), isSafe = false): void {
    if (this.#waiting?.isSafe) this.drop();
    if (this.#isSafe && this.#waiting === null && id !== this.#id) void this.forget();
    else void this.flush();
    this.#id = id;
    this.#isSafe = isSafe;
  }

  /** Whether an edit has come that is not being written yet. */
  get isWaiting(): boolean {
    return this.#waiting !== null && !this.#waiting.isSafe;
  }

  /** An edit: `state` is called when the drawing is kept. */
  edited(state: () => State): void {
    this.#wait({ state, isSafe: false });
  }

  /** Stores a drawing that a file has, or that was not changed yet, so that a reload shows it again. */
  safe(state: () => State): void {
    this.#wait({ state, isSafe: true });
  }

  #wait(waiting: Waiting): void {
    this.#waiting = waiting;
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.flush(), pauseBeforeKeeping);
  }

  /** Keeps at once what waits: when the page is hidden. */
  flush(): Promise<void> {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    const waiting = this.#waiting;
    this.#waiting = null;
    if (!waiting) return this.#last;
    const kept: Kept = { ...waiting.state(), id: this.#id, time: Date.now() };
    this.#isSafe = waiting.isSafe;
    const write = () => (waiting.isSafe ? this.#keepSafe(kept) : this.#keep(kept));
    return (this.#last = this.#last.then(write));
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

  /** Replaces what was stored before; a text that is too large for it is not stored. A refusal is no loss. */
  async #keepSafe(kept: Kept): Promise<void> {
    try {
      if (kept.text.length > mostSafeText) return await forgetDrawings([kept.id], this.#opened());
      await keep({ ...kept, isSafe: true }, this.#opened());
      await prune(kept.id, this.#opened());
    } catch {
      this.#store = null;
    }
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
