import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import type { KeptWhere } from "../../../../web/editor/src/files/autosave.js";
import { Autosave, forgetDrawings, keepPicture, keptDrawings, mostKept, mostSafe, pauseBeforeKeeping, recoverDrawing, safeTime } from "../../../../web/editor/src/files/autosave.js";
import { claim } from "../../../../web/editor/src/files/tabs.js";


/** A database in memory, which fails on demand. */
const base = vi.hoisted(() => {
  const rows = new Map<string, unknown>();
  const state = { error: null as Error | null, writes: 0 };
  const look = <Value>(value: () => Value) => (state.error ? Promise.reject(state.error) : Promise.resolve(value()));
  return { rows, state, look };
});

vi.mock("idb-keyval", () => ({
  createStore: () => "store",
  get: (key: string) => base.look(() => base.rows.get(key)),
  getMany: (keys: string[]) => base.look(() => keys.map((key) => base.rows.get(key))),
  keys: () => base.look(() => [...base.rows.keys()]),
  setMany: (entries: [string, unknown][]) =>
    base.look(() => {
      base.state.writes += 1;
      for (const [key, value] of entries) base.rows.set(key, structuredClone(value));
    }),
  delMany: (keys: string[]) => base.look(() => keys.forEach((key) => base.rows.delete(key))),
}));

const state = (text: string) => () => ({ name: "a.svg", curves: 3, text, undo: [text], place: null });

beforeEach(() => {
  vi.useFakeTimers();
  base.rows.clear();
  base.state.error = null;
  base.state.writes = 0;
});
afterEach(() => vi.useRealTimers());

function autosave() {
  const told: KeptWhere[] = [];
  return { told, save: new Autosave((where) => told.push(where)) };
}

describe("a drawing", () => {
  test("is kept once, a second after the last edit", async () => {
    const { told, save } = autosave();
    for (let i = 0; i < 5; ++i) {
      save.edited(state(`text ${i}`));
      await vi.advanceTimersByTimeAsync(pauseBeforeKeeping - 1);
    }
    expect(base.state.writes).toBe(0);
    await vi.advanceTimersByTimeAsync(1);
    expect(base.state.writes).toBe(1);
    expect(told).toEqual([{ kept: "browser" }]);
    expect(await recoverDrawing(save.id)).toMatchObject({ id: save.id, name: "a.svg", curves: 3, text: "text 4", undo: ["text 4"] });
  });

  test("is kept at once where the page is hidden, and only where something waits", async () => {
    const { save } = autosave();
    await save.flush();
    expect(base.state.writes).toBe(0);
    save.edited(state("x"));
    await save.flush();
    await vi.advanceTimersByTimeAsync(5000);
    expect(base.state.writes).toBe(1);
  });

  test("is forgotten once a file has it, with what still waits", async () => {
    const { save } = autosave();
    save.edited(state("x"));
    await save.flush();
    save.edited(state("y"));
    await save.forget();
    await vi.advanceTimersByTimeAsync(5000);
    expect(base.rows.size).toBe(0);
  });

  test("that another follows is kept under its own id", async () => {
    const { save } = autosave();
    const first = save.id;
    save.edited(state("first"));
    save.begin();
    save.edited(state("second"));
    await save.flush();
    expect((await recoverDrawing(first))?.text).toBe("first");
    expect((await recoverDrawing(save.id))?.text).toBe("second");
  });

  test("that is recovered goes on under its id", async () => {
    const { save } = autosave();
    save.begin("old");
    save.edited(state("x"));
    await save.flush();
    expect((await keptDrawings()).map(({ id }) => id)).toEqual(["old"]);
  });
});

describe("a drawing without changes", () => {
  test("is stored for a reload, and not listed", async () => {
    const { told, save } = autosave();
    save.safe(state("x"));
    await vi.advanceTimersByTimeAsync(pauseBeforeKeeping);
    expect(await recoverDrawing(save.id)).toMatchObject({ text: "x", isSafe: true });
    expect(await keptDrawings()).toEqual([]);
    expect(told).toEqual([]);
  });

  test("is listed from its first edit on, and no longer once a file has it", async () => {
    const { save } = autosave();
    save.safe(state("x"));
    await save.flush();
    save.edited(state("y"));
    await save.flush();
    expect((await keptDrawings()).map(({ id }) => id)).toEqual([save.id]);
    save.safe(state("y"));
    await save.flush();
    expect(await keptDrawings()).toEqual([]);
    expect((await recoverDrawing(save.id))?.text).toBe("y");
  });

  test("is removed when another is opened, but not with an edit that waits", async () => {
    const { save } = autosave();
    save.safe(state("unchanged"));
    await save.flush();
    save.begin("second");
    save.safe(state("second"));
    await save.flush();
    expect([...base.rows.keys()]).toEqual(["head:second", "body:second"]);
    save.edited(state("edited"));
    save.begin("third");
    await save.flush();
    expect((await recoverDrawing("second"))?.text).toBe("edited");
  });

  test("is not stored where its text is large, and a refusal is not reported", async () => {
    const { told, save } = autosave();
    save.safe(state("x".repeat(5e6)));
    await save.flush();
    expect(base.rows.size).toBe(0);
    base.state.error = new DOMException("", "SecurityError");
    save.safe(state("x"));
    await save.flush();
    expect(told).toEqual([]);
  });

  test("stays for a day, and does not displace changed ones", async () => {
    vi.setSystemTime(1e12);
    for (let i = 0; i < mostSafe + 3; ++i) {
      const { save } = autosave();
      save.begin(`safe${i}`);
      save.safe(state("x"));
      await save.flush();
    }
    const heads = () => [...base.rows.keys()].filter((key) => key.startsWith("head:"));
    expect(heads()).toHaveLength(mostSafe + 1);
    vi.setSystemTime(1e12 + safeTime + 1);
    const { save } = autosave();
    save.begin("changed");
    save.edited(state("y"));
    await save.flush();
    expect(heads()).toEqual(["head:changed"]);
  });
});

describe("a picture", () => {
  const picture = new Blob(["picture"], { type: "image/webp" });

  test("is listed with its drawing, and removed with it", async () => {
    const { save } = autosave();
    save.edited(state("x"));
    await save.flush();
    await keepPicture(save.id, picture);
    expect(await keptDrawings()).toMatchObject([{ id: save.id, picture: { size: picture.size } }]);
    await forgetDrawings([save.id]);
    expect(base.rows.size).toBe(0);
  });

  test("without a drawing is not stored, and a refusal is no error", async () => {
    await keepPicture("gone", picture);
    expect(base.rows.size).toBe(0);
    const { save } = autosave();
    save.edited(state("x"));
    await save.flush();
    base.state.error = new DOMException("", "QuotaExceededError");
    await keepPicture(save.id, picture);
    base.state.error = null;
    expect(await keptDrawings()).toMatchObject([{ picture: null }]);
  });
});

describe("a damaged record", () => {
  test.each([
    ["head", "head:a", { id: "a", name: 3 }],
    ["head that is no object", "head:a", "x"],
    ["text", "body:a", { text: 7 }],
    ["body that is missing", "body:a", undefined],
  ])("with a bad %s is not recovered", async (_, key, value) => {
    const { save } = autosave();
    save.begin("a");
    save.edited(state("x"));
    await save.flush();
    base.rows.set(key, value);
    expect(await recoverDrawing("a")).toBeNull();
    expect((await keptDrawings()).length).toBe(key.startsWith("head") ? 0 : 1);
  });

  test("with a bad picture is listed without one", async () => {
    const { save } = autosave();
    save.begin("a");
    save.edited(state("x"));
    await save.flush();
    base.rows.set("picture:a", "no picture");
    expect(await keptDrawings()).toMatchObject([{ id: "a", picture: null }]);
  });
});

describe("the list", () => {
  test(`has the newest ${mostKept}, without their texts`, async () => {
    for (let i = 0; i < mostKept + 5; ++i) {
      vi.setSystemTime(1000 * i + 1);
      const { save } = autosave();
      save.begin(`d${i}`);
      save.edited(state("x"));
      await save.flush();
    }
    const kept = await keptDrawings();
    expect(kept.map(({ id }) => id)).toEqual(Array.from({ length: mostKept }, (_, i) => `d${mostKept + 4 - i}`));
    expect(kept[0]).toEqual({ id: `d${mostKept + 4}`, name: "a.svg", curves: 3, time: 1000 * (mostKept + 4) + 1, picture: null });
    expect(base.rows.size).toBe(2 * mostKept);
  });

  test("keeps the drawing at hand, however wrong the clock goes", async () => {
    for (let i = 0; i < mostKept + 1; ++i) {
      vi.setSystemTime(1e6 - 1000 * i);
      const { save } = autosave();
      save.begin(`d${i}`);
      save.edited(state("x"));
      await save.flush();
      expect(await recoverDrawing(`d${i}`)).not.toBeNull();
    }
  });

  test("loses what is forgotten", async () => {
    const { save } = autosave();
    save.edited(state("x"));
    await save.flush();
    await forgetDrawings([save.id]);
    expect(await keptDrawings()).toEqual([]);
    expect(await recoverDrawing(save.id)).toBeNull();
  });
});

describe("a browser that", () => {
  test.each([
    ["is full", "QuotaExceededError", "full"],
    ["refuses", "SecurityError", "refused"],
  ])("%s is reported, and asked again at the next edit", async (_, name, lost) => {
    const { told, save } = autosave();
    base.state.error = new DOMException("", name);
    save.edited(state("x"));
    await save.flush();
    expect(told).toEqual([{ kept: "nowhere", lost }]);
    expect(await keptDrawings()).toEqual([]);
    expect(await recoverDrawing(save.id)).toBeNull();
    base.state.error = null;
    save.edited(state("y"));
    await save.flush();
    expect(told.at(-1)).toEqual({ kept: "browser" });
  });

  test("has no database at all is reported", async () => {
    const told: KeptWhere[] = [];
    const save = new Autosave((where) => told.push(where), () => {
      throw new ReferenceError("indexedDB is not defined");
    });
    save.edited(state("x"));
    await save.flush();
    await save.forget();
    expect(told).toEqual([{ kept: "nowhere", lost: "refused" }]);
  });
});

describe("a claim on a drawing", () => {
  /** Returns locks of one browser, by the specification, for one name. */
  function locks() {
    let steal: (() => void) | null = null;
    return {
      request: (_: string, options: LockOptions, body: (lock: object | null) => Promise<void> | void) => {
        if (steal && options.ifAvailable) return Promise.resolve(body(null));
        steal?.();
        return new Promise((resolve, reject) => {
          const mine = () => reject(new DOMException("", "AbortError"));
          steal = mine;
          void Promise.resolve(body({})).then(() => {
            if (steal === mine) steal = null;
            resolve(undefined);
          });
        });
      },
    };
  }

  beforeEach(() => void vi.stubGlobal("navigator", { locks: locks() }));
  afterEach(() => vi.unstubAllGlobals());

  test("is granted to the first tab alone, until that gives it up", async () => {
    const lost = vi.fn();
    const first = await claim("d", lost);
    expect(first).not.toBeNull();
    expect(await claim("d", lost)).toBeNull();
    first?.release();
    await vi.advanceTimersByTimeAsync(0);
    expect(await claim("d", lost)).not.toBeNull();
    expect(lost).not.toHaveBeenCalled();
  });

  test("that another tab takes is lost, and said so", async () => {
    const lost = vi.fn();
    await claim("d", lost);
    expect(await claim("d", vi.fn(), true)).not.toBeNull();
    await vi.advanceTimersByTimeAsync(0);
    expect(lost).toHaveBeenCalledOnce();
  });

  test("is granted where a browser has no locks, or refuses them", async () => {
    vi.stubGlobal("navigator", { locks: { request: () => Promise.reject(new DOMException("", "SecurityError")) } });
    expect(await claim("d", vi.fn())).not.toBeNull();
    vi.stubGlobal("navigator", {});
    expect(await claim("d", vi.fn())).not.toBeNull();
  });
});
