// Traces of photos: workers that trace and draw, the dialog that uses them, and the resulting drawing.
import { describe, expect, it, test, vi } from "vitest";
import { Status } from "../../../../web/wasm/sfumato.mjs";
import { TracePreviews, tracePhoto, type PreviewWish } from "../../../../web/editor/src/engine/photo-trace.js";
import type { PhotoPixels, TraceOptions, TraceRound } from "../../../../web/editor/src/engine/types.js";
import { sizeRead } from "../../../../web/editor/src/files/photo.js";
import { fitted, insertTraced, replaceByTraced } from "../../../../web/editor/src/model/commands/index.js";
import { blankText, openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { applied } from "../../../../web/editor/src/source/patch.js";
import { optionsOf, pointsOf, shownSize, TraceRun, type TraceChoice } from "../../../../web/editor/src/panels/dialogs/tracing.js";
import type { Tracing } from "../../../../web/editor/src/panels/services.js";
import { hasModule, localHost } from "../wasm.js";

const SIDE = 32;

/** Returns a red square on blue. */
function square(side = SIDE): PhotoPixels {
  const data = new Uint8ClampedArray(4 * side * side);
  for (let y = 0; y < side; ++y) {
    for (let x = 0; x < side; ++x) {
      const isInside = [x, y].every((k) => k > side / 4 && k < (3 * side) / 4);
      data.set(isInside ? [220, 40, 30, 255] : [20, 60, 200, 255], 4 * (y * side + x));
    }
  }
  return { width: side, height: side, data };
}

const options: TraceOptions = { points: 300, smooth: 0, stops: "normal", blur: "on" };
const never = () => new AbortController().signal;

describe.skipIf(!hasModule)("a photo in a worker", () => {
  it("becomes SVG, told round by round, and the worker is gone", async () => {
    const host = localHost();
    const rounds: TraceRound[] = [];
    const text = await tracePhoto(host, { photo: square(), options }, (round) => rounds.push(round), never());
    expect(text).toContain(`viewBox="0 0 ${SIDE} ${SIDE}"`);
    expect(rounds.length).toBeGreaterThan(1);
    expect(rounds[0]).toMatchObject({ round: 0, psnr: 0 });
    expect(rounds[0].text).toContain("<path");
    expect(rounds.at(-1)!.psnr).toBeGreaterThan(25);
    expect(rounds.at(-1)!.controlPoints).toBeLessThanOrEqual(300);
    expect(host.living).toBe(0);
  });

  it("is ended by its signal, before and while it works", async () => {
    const host = localHost();
    const over = AbortSignal.abort(new Error("over"));
    await expect(tracePhoto(host, { photo: square(), options }, () => {}, over)).rejects.toThrow("over");
    expect(host.workers).toBe(0);
    const stop = new AbortController();
    const heard = () => stop.abort(new Error("enough"));
    await expect(tracePhoto(host, { photo: square(), options }, heard, stop.signal)).rejects.toThrow("enough");
    expect(host.living).toBe(0);
  });

  it("that is none is refused in the library's words", async () => {
    const host = localHost();
    const wrong = { ...square(), width: 7 };
    await expect(tracePhoto(host, { photo: wrong, options }, () => {}, never())).rejects.toThrow(/4 bytes/);
    const many = { ...options, points: -1 };
    await expect(tracePhoto(host, { photo: square(), options: many }, () => {}, never())).rejects.toThrow(/points/);
    expect(host.living).toBe(0);
  });

  it("is drawn as it is asked for last", async () => {
    const host = localHost();
    const previews = new TracePreviews(host);
    const of = (color: string) =>
      `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 8 8" sf:version="1"><g sf:diffuse="true"><path d="M-9 4 L20 4" sf:left="${color}" sf:right="${color}"/></g></svg>`;
    const shown: number[] = [];
    await new Promise<void>((resolve) => {
      const take = ({ data }: PhotoPixels) => shown.push(data[0]);
      const wish = { width: 4, height: 4, isDraft: true };
      previews.draw({ ...wish, text: of("#100") }, take);
      previews.draw({ ...wish, text: "no drawing" }, take);
      previews.draw({ ...wish, text: of("#f00") }, (pixels) => resolve(void take(pixels)));
    });
    expect(shown).toEqual([17, 255]);
    previews.end();
    await vi.waitFor(() => expect(host.living).toBe(0));
  });
});

test("where memory is out, it is said for people", async () => {
  const failure = { message: "the module has ended", reason: "the module has ended", code: Status.outOfMemory, line: 0, column: 0 };
  const worker = {
    onmessage: null as ((event: MessageEvent) => void) | null,
    postMessage({ id, name }: { id: number; name: string }) {
      const data = name === "start" ? { id, value: "0" } : { id, failure };
      queueMicrotask(() => this.onmessage?.({ data } as MessageEvent));
    },
    terminate() {},
  };
  const host = { module: () => Promise.resolve({} as WebAssembly.Module), worker: () => worker as unknown as Worker };
  await expect(tracePhoto(host, { photo: square(), options }, () => {}, never())).rejects.toThrow(/not enough memory/);
});

const choice: TraceChoice = { detail: 0.5, smooth: 0, stops: "normal", isSharp: false };
const photo = { blob: new Blob(), name: "a.png", artboardFromPhoto: null };
const round: TraceRound = { text: "<svg/>", round: 0, roundCount: 4, curves: 3, controlPoints: 30, stops: 9, psnr: 0 };

/** Traces under the test's control. */
class FakeTracing implements Tracing {
  readonly runs: { options: TraceOptions; signal: AbortSignal; heard: (r: TraceRound) => void; end: (text: string) => void; fail: (e: Error) => void }[] = [];
  isOver = false;
  choose = () => Promise.resolve(null);
  pixels = () => Promise.resolve(square());
  run(_: PhotoPixels, given: TraceOptions, heard: (r: TraceRound) => void, signal: AbortSignal) {
    return new Promise<string>((end, fail) => {
      signal.addEventListener("abort", () => fail(signal.reason as Error));
      this.runs.push({ options: given, signal, heard, end, fail });
    });
  }
  draw({ width, height }: PreviewWish, show: (pixels: PhotoPixels) => void) {
    show({ ...square(), width, height });
  }
  openAsNew = () => Promise.resolve();
  insert = () => Promise.resolve();
  end() {
    this.isOver = true;
  }
}

async function begun() {
  const tracing = new FakeTracing();
  const run = new TraceRun(tracing);
  void run.take(photo, choice);
  await vi.waitFor(() => expect(tracing.runs.length).toBe(1));
  return { tracing, run };
}

describe("a run of the dialog", () => {
  it("goes from the photo to its drawing", async () => {
    const { tracing, run } = await begun();
    expect(run.stage.value).toBe("running");
    tracing.runs[0].heard(round);
    expect(run.preview.value?.width).toBe(SIDE);
    tracing.runs[0].end("<svg>all</svg>");
    await vi.waitFor(() => expect(run.stage.value).toBe("done"));
    expect(run.round.value?.text).toBe("<svg>all</svg>");
  });

  it("keeps what was reached when it is stopped, and hears nothing more", async () => {
    const { tracing, run } = await begun();
    tracing.runs[0].heard(round);
    run.stop();
    expect(tracing.runs[0].signal.aborted).toBe(true);
    tracing.runs[0].heard({ ...round, curves: 99 });
    await Promise.resolve();
    expect(run.stage.value).toBe("stopped");
    expect(run.round.value?.curves).toBe(3);
    expect(run.reason.value).toBeNull();
  });

  it("begins anew when the hand rests after changes", async () => {
    const { tracing, run } = await begun();
    for (const detail of [0, 0.2, 1]) run.change({ ...choice, detail, isSharp: true });
    await vi.waitFor(() => expect(tracing.runs.length).toBe(2));
    expect(tracing.runs[0].signal.aborted).toBe(true);
    expect(tracing.runs[1].options).toEqual({ points: 16000, smooth: 0, stops: "normal", blur: "off" });
    run.end();
    expect(tracing.runs[1].signal.aborted).toBe(true);
    expect(tracing.isOver).toBe(true);
  });

  it("says why it failed", async () => {
    const { tracing, run } = await begun();
    tracing.runs[0].fail(new Error("no memory"));
    await vi.waitFor(() => expect(run.stage.value).toBe("failed"));
    expect(run.reason.value).toBe("no memory");
  });
});

test("detail stands for as many control points as the command says", () => {
  expect([0, 0.5, 1].map(pointsOf)).toEqual([250, 2000, 16000]);
  expect(optionsOf(choice)).toEqual({ points: 2000, smooth: 0, stops: "normal", blur: "on" });
});

test("sizes keep their proportions", () => {
  expect(shownSize(4000, 3000)).toEqual({ width: 640, height: 480 });
  expect(shownSize(20, 10)).toEqual({ width: 20, height: 10 });
  expect(shownSize(5000, 1)).toEqual({ width: 640, height: 1 });
  expect(sizeRead(2000, 1500)).toEqual({ width: 2000, height: 1500 });
  const { width, height } = sizeRead(12000, 8000);
  expect(width * height).toBeLessThanOrEqual(4e6);
  expect(width / height).toBeCloseTo(1.5, 2);
});

const traced = {
  text: `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 40 20" sf:version="1">
  <g sf:diffuse="true">
    <path d="M0 10 L40 10" sf:left="#f00" sf:right="#00f"/>
  </g>
</svg>
`,
  name: "my cat",
  photo: null,
};
const kept = { href: "data:image/png;base64,AAAA", width: 40, height: 20 };

test("a traced photo is a layer as large as it fits, and one step back is the text before", () => {
  const text = blankText(100, 100, null);
  const d = openDrawing(text);
  const outcome = insertTraced(d, traced, fitted(d, 40, 20))!;
  const after = openDrawing(applied(text, outcome.patch));
  const layer = after.items.at(-1)!;
  expect(layer.kind).toBe("layer");
  expect(layer.name).toBe("my-cat");
  expect(layer.artboardFromItem).toEqual([2.5, 0, 0, 2.5, 0, 25]);
  expect(layer.children.length).toBe(1);
  d.apply(outcome.patch);
  d.apply(outcome.patch.map(({ at, removed, inserted }) => ({ at, removed: inserted, inserted: removed })));
  expect(d.text).toBe(text);
});

test("the photo goes with it, above it and in its place", () => {
  const text = blankText(100, 100, null);
  const d = openDrawing(text);
  const after = openDrawing(applied(text, insertTraced(d, { ...traced, photo: kept }, fitted(d, 40, 20))!.patch));
  const photoItem = after.items.at(-1)!;
  expect(photoItem.kind).toBe("reference");
  if (photoItem.kind !== "reference") return;
  const [a, , , , e, f] = photoItem.artboardFromItem;
  const [x0, y0, x1] = photoItem.box;
  expect([a * x0 + e, a * x1 + e, a * y0 + f]).toEqual([0, 100, 25]);
});

test("as a new drawing it is all that there is", () => {
  const d = openDrawing(blankText(40, 20, null));
  d.apply(replaceByTraced(d, { ...traced, photo: kept }).patch);
  expect(d.items.map(({ kind }) => kind)).toEqual(["layer", "reference"]);
  expect(d.artboard).toEqual([0, 0, 40, 20]);
});
