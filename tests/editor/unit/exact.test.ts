// Exact pixels of the stage: the requests to the engine, and the reported state.
import { signal } from "@preact/signals";
import { describe, expect, test } from "vitest";
import type { Editor, ExactState } from "../../../web/editor/src/app/types.js";
import { ExactStage, type Shown } from "../../../web/editor/src/canvas/exact.js";
import type { EngineStatus } from "../../../web/editor/src/engine/types.js";
import type { ExactLayer } from "../../../web/viewer/exact_fields.js";
import type { Frame, Renderer } from "../../../web/viewer/renderer.js";

const layerOf = (number: number) => ({ tolerance: number }) as unknown as ExactLayer;

/**
 * Returns a settled picture of two layers, an engine with fixed answers, and a renderer that gathers in two steps.
 */
function stage(driver = "a card") {
  const asked: number[] = [];
  const versions = [1, 1];
  const shown: Shown & { changedAt: number } = {
    layerCount: 2,
    version: (layer) => versions[layer],
    changedAt: -Infinity,
  };
  let answer: (layer: number) => ExactLayer | null | "busy" = layerOf;
  const exactState = signal<ExactState>({ kind: "off" });
  const exactPixels = signal<"auto" | "on" | "off">("auto");
  const status = signal<EngineStatus>({ kind: "exact", milliseconds: 1 });
  const engine = {
    exactLayer: async (layer: number) => {
      asked.push(layer);
      return answer(layer);
    },
  };
  const editor = { exactState, status, engine, settings: { exactPixels } } as unknown as Editor;
  let wakes = 0;
  const exact = new ExactStage(editor, shown, () => (wakes += 1));
  const renderer = {
    gl: { getExtension: () => null, getParameter: () => driver, RENDERER: 1 },
    exact: null as { reason: string; isTooLarge: boolean; progress: number } | null,
    isGathering: false,
    canGather: true,
    hasUnshown: false,
    canRefine: false,
    setExact(make: unknown) {
      this.exact = make ? { reason: "", isTooLarge: false, progress: 0 } : null;
      this.isGathering = this.hasUnshown = false;
      this.canGather = true;
    },
    gatherMore() {
      this.isGathering = this.hasUnshown = true;
      this.exact!.progress += 0.5;
      this.canGather = this.exact!.progress < 1;
    },
    showGathered() {
      this.hasUnshown = false;
    },
  };
  const step = () => exact.step(renderer as unknown as Renderer, () => ({}) as Frame);
  const wake = async () => {
    const before = wakes;
    for (let i = 0; i < 400 && wakes === before; ++i) await new Promise((resolve) => setTimeout(resolve, 5));
    expect(wakes).toBe(before + 1);
  };
  const answers = (by: typeof answer) => (answer = by);
  return { asked, versions, shown, exactState, exactPixels, status, renderer, step, wake, answers };
}

describe("exact pixels", () => {
  test("are gathered from the curves of all layers, step by step", async () => {
    const { asked, exactState, renderer, step, wake } = stage();
    expect(step()).toBe(false);
    expect(exactState.value).toEqual({ kind: "gathering", share: 0 });
    await wake();
    expect(asked).toEqual([0, 1]);
    expect(step()).toBe(true);
    expect(renderer.exact).not.toBeNull();
    expect(exactState.value).toEqual({ kind: "gathering", share: 0.5 });
    expect(step()).toBe(false);
    expect(exactState.value).toEqual({ kind: "exact" });
  });

  test("ask again for what has changed alone", async () => {
    const { asked, versions, renderer, step, wake } = stage();
    step();
    await wake();
    versions[1] = 2;
    renderer.setExact(null);
    step();
    await wake();
    expect(asked).toEqual([0, 1, 1]);
    step();
    expect(renderer.exact).not.toBeNull();
  });

  test("wait for an engine that is busy, a picture that is not exact, and one that has just changed", async () => {
    const { asked, shown, status, step, wake, answers } = stage();
    answers(() => "busy");
    step();
    await wake();
    expect(asked).toEqual([0]);
    answers(layerOf);
    status.value = { kind: "refining", milliseconds: 1 };
    expect(step()).toBe(false);
    expect(asked).toEqual([0]);
    status.value = { kind: "exact", milliseconds: 1 };
    shown.changedAt = performance.now();
    expect(step()).toBe(true);
    expect(asked).toEqual([0]);
    shown.changedAt = -Infinity;
    step();
    await wake();
    expect(asked).toEqual([0, 0, 1]);
  });

  test("are none where the engine fails, until the layer changes", async () => {
    const { asked, exactState, versions, renderer, step, wake, answers } = stage();
    answers((layer) => {
      if (layer === 0) throw new Error("memory is out");
      return layerOf(layer);
    });
    step();
    await wake();
    expect(step()).toBe(false);
    expect(exactState.value).toEqual({ kind: "none", reason: "memory is out" });
    expect(step()).toBe(false);
    expect(asked).toEqual([0, 1]);
    expect(renderer.exact).toBeNull();
    answers(layerOf);
    versions[0] = 2;
    step();
    await wake();
    expect(step()).toBe(true);
    expect(exactState.value.kind).toBe("gathering");
  });

  test("are off where software draws, and where they are not wanted", async () => {
    const { asked, exactState, exactPixels, renderer, step, wake } = stage("llvmpipe (LLVM 15)");
    expect(step()).toBe(false);
    expect(exactState.value).toEqual({ kind: "off" });
    exactPixels.value = "on";
    step();
    await wake();
    expect(step()).toBe(true);
    exactPixels.value = "off";
    expect(step()).toBe(false);
    expect([exactState.value, renderer.exact, asked]).toEqual([{ kind: "off" }, null, [0, 1]]);
  });
});
