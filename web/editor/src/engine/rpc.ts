// Calls between the page and a worker: each message is one call or one answer.
import { Status } from "../../../wasm/library.mjs";

/** Functions that a worker answers by, by name. */
export type Handlers = Record<string, (...given: never[]) => unknown>;

/** An answer whose buffers are handed over instead of copied. */
export class Handed<Value> {
  constructor(
    readonly value: Value,
    readonly buffers: Transferable[],
  ) {}
}

interface Call {
  readonly id: number;
  readonly name: string;
  readonly given: unknown[];
}

/** The content of an error, in a form that messages can carry. */
export interface Failure {
  readonly message: string;
  readonly reason: string;
  readonly code: number;
  readonly line: number;
  readonly column: number;
}

/** A report that a worker sends while it works on a call. */
export interface Note {
  readonly note: unknown;
}

interface Answer {
  readonly id: number;
  readonly value?: unknown;
  readonly failure?: Failure;
}

/** A worker's error, on the page's side. Line and column from 1, 0 where unknown. */
export class EngineError extends Error {
  readonly reason: string;
  /** Status code of web/wasm/error.mjs; 0: not the library's. */
  readonly code: number;
  readonly line: number;
  readonly column: number;

  constructor(failure: Failure) {
    super(failure.message);
    this.reason = failure.reason;
    this.code = failure.code;
    this.line = failure.line;
    this.column = failure.column;
  }

  static of(error: unknown): EngineError {
    return error instanceof EngineError ? error : new EngineError(failureOf(error));
  }

  /** Whether the text is to blame: the library said so, and can go on. */
  get isOfText(): boolean {
    return [Status.badInput, Status.limit, Status.unavailable, Status.badUsage].includes(this.code as never);
  }
}

function failureOf(error: unknown): Failure {
  const from = error as Partial<Failure> & { message?: string };
  const message = from?.message ?? String(error);
  const { reason = message, code = 0, line = 0, column = 0 } = from ?? {};
  return { message, reason, code, line, column };
}

/** A worker that was asked nothing for so long is not needed, milliseconds. */
const PAUSE = 100;

/** Answers calls that come from the page, one after another. */
export function answer(scope: MessageEndpoint, handlers: Handlers): void {
  let last: Promise<void> = Promise.resolve();
  scope.onmessage = ({ data }: MessageEvent<Call>) => {
    last = last.then(() => reply(scope, handlers, data));
  };
}

async function reply(scope: MessageEndpoint, handlers: Handlers, { id, name, given }: Call) {
  try {
    const made = await handlers[name](...(given as never[]));
    if (made instanceof Handed) scope.postMessage({ id, value: made.value }, made.buffers);
    else scope.postMessage({ id, value: made }, []);
  } catch (error) {
    scope.postMessage({ id, failure: failureOf(error) }, []);
  }
}

/** The interface that a Worker and a worker's own scope share. */
export interface MessageEndpoint {
  onmessage: ((event: MessageEvent) => void) | null;
  postMessage(message: unknown, buffers: Transferable[]): void;
}

/** The page's end: calls a worker's functions. */
export class Link {
  /** Receives the worker's reports while it works on a call. */
  onNote: (note: never) => void = () => {};
  #next = 0;
  #waiting = new Map<number, { resolve: (value: never) => void; reject: (error: Error) => void }>();
  #worker: Worker | null;
  /** Why nothing is answered any more. */
  #failure: Failure | null = null;

  /**
   * @param worker null: the browser makes none
   * @param notStarted says so
   */
  constructor(worker: Worker | null, notStarted: string) {
    this.#worker = worker;
    if (!worker) {
      this.#fail(notStarted);
      return;
    }
    worker.onmessage = ({ data }: MessageEvent<Answer | Note>) =>
      "note" in data ? this.onNote(data.note as never) : this.#take(data);
    worker.onmessageerror = () => this.#fail(notStarted);
    worker.onerror = (event) => this.#fail(event.message || notStarted);
  }

  /** Whether a call is being answered. */
  get isBusy(): boolean {
    return this.#waiting.size > 0;
  }

  call<Value>(name: string, ...given: unknown[]): Promise<Value> {
    const id = this.#next++;
    return new Promise<Value>((resolve, reject) => {
      if (this.#failure) return reject(new EngineError(this.#failure));
      this.#waiting.set(id, { resolve, reject });
      this.#worker?.postMessage({ id, name, given });
    });
  }

  /** Ends the worker; what was not answered fails. */
  end(): void {
    this.#worker?.terminate();
    this.#fail("The worker was ended.");
  }

  /** Ends the worker once no call waits for it or is about to start. */
  async endWhenIdle(): Promise<void> {
    do await new Promise((resolve) => setTimeout(resolve, PAUSE));
    while (this.isBusy);
    this.end();
  }

  #take({ id, value, failure }: Answer) {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (failure) waiting?.reject(new EngineError(failure));
    else waiting?.resolve(value as never);
  }

  #fail(message: string) {
    const failure = (this.#failure = failureOf(new Error(message)));
    for (const { reject } of this.#waiting.values()) reject(new EngineError(failure));
    this.#waiting.clear();
  }
}
