// One drawing in two tabs of this browser: the second tab gets a warning.

/** A drawing that this tab alone works on, until it gives it up or another tab takes it. */
export interface Claim {
  /** Resolves when others, and this tab again, may claim it. */
  release(): Promise<void>;
}

const unguarded: Claim = { release: () => Promise.resolve() };

/**
 * Claims a drawing: the id of its autosave, or its address under `sfumato edit`. null: another tab has it. A
 * browser without locks grants everything.
 * @param lost called when another tab has taken it
 * @param take takes it from the other tab
 */
export function claim(key: string, lost: () => void, take = false): Promise<Claim | null> {
  const locks = globalThis.navigator?.locks;
  if (!locks) return Promise.resolve(unguarded);
  return new Promise((resolve) => {
    let isHeld = false;
    let letGo = (): void => undefined;
    const held = new Promise<void>((done) => (letGo = done));
    const options: LockOptions = take ? { steal: true } : { ifAvailable: true };
    const over = locks
      .request(`sfumato:${key}`, options, (lock) => {
        if (!lock) return resolve(null);
        isHeld = true;
        resolve({ release: () => (letGo(), over) });
        return held;
      })
      // Another tab ends a lock that is held; an earlier error means that the browser refuses locks.
      .catch(() => (isHeld ? lost() : resolve(unguarded)));
  });
}

type Word =
  | { readonly kind: "who"; readonly ask: string; readonly tab: string; readonly handle: FileSystemFileHandle }
  | { readonly kind: "I"; readonly ask: string };

const answerWithin = 200;
/** A tab receives its own messages too. */
const thisTab = crypto.randomUUID();

/** Whether another tab has this file open. */
export async function isOpenElsewhere(handle: FileSystemFileHandle): Promise<boolean> {
  if (!("BroadcastChannel" in globalThis)) return false;
  const channel = new BroadcastChannel("sfumato-files");
  const ask = crypto.randomUUID();
  try {
    return await new Promise<boolean>((resolve) => {
      channel.onmessage = ({ data }: MessageEvent<Word>) => {
        if (data.kind === "I" && data.ask === ask) resolve(true);
      };
      const who: Word = { kind: "who", ask, tab: thisTab, handle };
      channel.postMessage(who);
      setTimeout(() => resolve(false), answerWithin);
    });
  } catch {
    return false;
  } finally {
    channel.close();
  }
}

/** Answers other tabs as long as this one is open. @param current the file that this tab has open */
export function answerOtherTabs(current: () => FileSystemFileHandle | null): () => void {
  if (!("BroadcastChannel" in globalThis)) return () => undefined;
  const channel = new BroadcastChannel("sfumato-files");
  channel.onmessage = async ({ data }: MessageEvent<Word>) => {
    if (data.kind !== "who" || data.tab === thisTab) return;
    const own = current();
    if (!own || !(await own.isSameEntry(data.handle).catch(() => false))) return;
    const answer: Word = { kind: "I", ask: data.ask };
    channel.postMessage(answer);
  };
  return () => channel.close();
}
