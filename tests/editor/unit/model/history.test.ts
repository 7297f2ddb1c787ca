// Undo restores steps in reverse order, whatever was merged.
import { describe, expect, it } from "vitest";
import { History, type Step } from "../../../../web/editor/src/app/history.js";
import { applied, type Patch } from "../../../../web/editor/src/source/patch.js";

const step = (label: string, patch: Patch): Omit<Step, "group"> => ({ label, patch, before: [], after: [] });

/** Edits a text through a history, at random places. */
function edited(history: History, seed: number, count: number): string[] {
  let state = seed;
  const random = (below: number) => {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    return (state >>> 8) % below;
  };
  const texts = ["The text to begin with."];
  for (let i = 0; i < count; ++i) {
    const text = texts.at(-1)!;
    const at = random(text.length);
    const removed = text.slice(at, at + random(4));
    const patch = [{ at, removed, inserted: "x".repeat(random(5)) }];
    history.push(step(`step ${i}`, patch));
    texts.push(applied(text, patch));
  }
  return texts;
}

describe("undo", () => {
  it("leads back through every text, and forth again", () => {
    for (let seed = 1; seed <= 50; ++seed) {
      const history = new History();
      const texts = edited(history, seed, 30);
      let text = texts.at(-1)!;
      for (const expected of texts.slice(0, -1).reverse()) {
        for (const { patch } of history.undo()) text = applied(text, patch);
        expect(text).toBe(expected);
      }
      expect(history.undo()).toEqual([]);
      for (const expected of texts.slice(1)) {
        for (const { patch } of history.redo()) text = applied(text, patch);
        expect(text).toBe(expected);
      }
    }
  });

  it("takes steps of one kind, soon one after the other, as one", () => {
    const history = new History();
    const add = (text: string, merge: string, now: number) =>
      history.push(step(text, [{ at: 0, removed: "", inserted: text }]), merge, now);
    add("a", "nudge", 0);
    add("b", "nudge", 500);
    add("c", "nudge", 1400);
    add("d", "", 1401);
    add("e", "", 1402);
    const taken = [history.undo(), history.undo(), history.undo(), history.undo()];
    expect(taken.map((steps) => steps.length)).toEqual([1, 1, 1, 2]);
    let text = "edcba";
    for (const { patch } of taken.flat()) text = applied(text, patch);
    expect(text).toBe("");
  });

  it("names what it would undo and redo", () => {
    const history = new History();
    expect(history.undoLabel.value).toBeNull();
    history.push(step("draw", []));
    history.push(step("colour", []));
    expect(history.undoLabel.value).toBe("colour");
    history.undo();
    expect([history.undoLabel.value, history.redoLabel.value]).toEqual(["draw", "colour"]);
    history.push(step("blur", []));
    expect(history.redoLabel.value).toBeNull();
  });

  it("forgets the oldest steps where they are too many, and goes on after it was restored", () => {
    const history = new History();
    const large = "x".repeat(9e6);
    for (const label of ["a", "b", "c"]) history.push(step(label, [{ at: 0, removed: "", inserted: large }]));
    const restored = new History();
    restored.restore(history.log);
    expect([restored.undo(), restored.undo(), restored.undo()].map((s) => s.length)).toEqual([1, 1, 0]);
    restored.redo();
    restored.push(step("d", []));
    expect(restored.undoLabel.value).toBe("d");
    restored.undo();
    expect(restored.undoLabel.value).toBe("b");
  });

  it("keeps every step, however often a large one is done and undone", () => {
    const history = new History();
    for (const label of ["draw", "colour", "blur"]) history.push(step(label, []));
    const photo = [{ at: 0, removed: "", inserted: "x".repeat(7e6) }];
    for (let i = 0; i < 5; ++i) {
      history.push(step("place", photo));
      history.undo();
      history.redo();
      history.undo();
    }
    history.push(step("place", photo));
    expect(history.log.done.map(({ label }) => label)).toEqual(["draw", "colour", "blur", "place"]);
  });

  it("never holds more than the limit and one step, whatever is done, undone and restored", () => {
    const sizeOf = (steps: readonly Step[]) =>
      steps.reduce((sum, { patch }) => sum + patch[0].removed.length + patch[0].inserted.length, 0);
    let state = 7;
    const random = (below: number) => {
      state = (Math.imul(state, 1103515245) + 12345) >>> 0;
      return (state >>> 8) % below;
    };
    let history = new History();
    for (let i = 0; i < 60; ++i) {
      const act = random(5);
      if (act < 2) history.push(step(`${i}`, [{ at: 0, removed: "", inserted: "x".repeat(random(6e6)) }]));
      else if (act === 2) history.undo();
      else if (act === 3) history.redo();
      else {
        const { log } = history;
        history = new History();
        history.restore(log);
      }
      const { done, undone } = history.log;
      expect(sizeOf(done) + sizeOf(undone)).toBeLessThan(20e6);
    }
  });
});
