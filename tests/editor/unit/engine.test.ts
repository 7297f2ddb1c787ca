// The engine and its workers: after any edits the page has the library's solution of the text, and late answers do
// not replace newer ones.
import { afterEach, describe, expect, it } from "vitest";
import { loadSfumato, Status, Table } from "../../../web/wasm/sfumato.mjs";
import { SIDE, type ExactLayer } from "../../../web/viewer/exact_fields.js";
import { WorkerEngine } from "../../../web/editor/src/engine/engine.js";
import { LayerMirror, type MirroredLayer } from "../../../web/editor/src/engine/mirror.js";
import type { Host } from "../../../web/editor/src/engine/seat.js";
import type { EngineStatus, LayerCurves, PictureUpdate, QuickChange } from "../../../web/editor/src/engine/types.js";
import { hasModule, localHost, module, textOf } from "./wasm.js";

const artboard = [0, 0, 200, 150] as const;
const look = (engine: WorkerEngine) => engine.look(2, artboard, artboard);

/** Returns two layers of two curves; the first layer's first curve is bent. */
const drawing = (bend: number, color = "#c21") => `<svg xmlns="http://www.w3.org/2000/svg"
  xmlns:sf="urn:sfumato:1" viewBox="0 0 200 150" sf:version="1">
  <g sf:diffuse="true">
    <path d="M0 100 C60 ${bend} 140 130 200 90" sf:left="#9cf, #fed" sf:right="${color}"/>
    <path d="M80 30 C90 10 110 10 120 30" sf:left="gold" sf:right="#fff" sf:blur="4"/>
  </g>
  <g sf:diffuse="true"><path d="M20 20 L60 40" sf:left="red" sf:right="blue" sf:opacity=".5"/></g>
</svg>`;

const pointsFor = (bend: number): QuickChange => ({
  kind: "points",
  layer: 0,
  curve: 0,
  xy: Float64Array.of(0, 100, 60, bend, 140, 130, 200, 90),
});

/** The page's state: mirrors of the layers, and the reports that it received. */
class Page {
  readonly mirrors: LayerMirror[] = [];
  readonly layers: MirroredLayer[] = [];
  readonly statuses: EngineStatus[] = [];
  updates = 0;
  stacks = 0;
  rows = 0;
  isExact = false;

  constructor(readonly engine: WorkerEngine) {
    engine.onPicture = (update) => this.take(update);
    engine.onStatus = (status) => this.statuses.push(status);
  }

  take({ layers, layerCount, stack, isExact }: PictureUpdate) {
    this.updates += 1;
    this.stacks += stack ? 1 : 0;
    this.isExact = isExact;
    for (const update of layers) {
      const mirror = (this.mirrors[update.layer] ??= new LayerMirror());
      mirror.change(update);
      this.layers[update.layer] = mirror.tables(update);
      this.rows += update.color.values.length;
    }
    this.layers.length = layerCount;
  }

  async until(condition: () => boolean): Promise<void> {
    for (let i = 0; i < 6000 && !condition(); ++i) await new Promise((resolve) => setTimeout(resolve, 5));
    expect(condition()).toBe(true);
  }

  exact = () => this.until(() => this.isExact && this.statuses.at(-1)?.kind === "exact");

  show(text: string, moving: boolean, quick?: readonly QuickChange[]) {
    this.isExact = false;
    this.engine.show(text, moving, quick);
  }
}

/** Returns the starts of curve sides, artboard units of a layer without a transform. */
function endsOfSides({ fields: [{ edge }], positions, origin, triangleVertex }: ExactLayer) {
  const ends = [...edge.keys()].filter((h) => edge[h] === SIDE).map((h) => triangleVertex[h]);
  const along = (axis: 0 | 1) => ends.map((vertex) => positions[2 * vertex + axis] + origin[axis]);
  return { x: along(0), y: along(1) };
}

/** Returns the approximate distance of a point from a cubic curve. */
function distanceTo([x0, y0, x1, y1, x2, y2, x3, y3]: number[], x: number, y: number): number {
  const at = (t: number, a: number, b: number, c: number, d: number) =>
    a * (1 - t) ** 3 + 3 * b * t * (1 - t) ** 2 + 3 * c * t * t * (1 - t) + d * t ** 3;
  const steps = Array.from({ length: 20_001 }, (_, i) => i / 20_000);
  return Math.min(...steps.map((t) => Math.hypot(at(t, x0, x1, x2, x3) - x, at(t, y0, y1, y2, y3) - y)));
}

/** Returns all tables of a text, solved by the library with options. */
async function solved(text: string, width: number) {
  const context = (await loadSfumato(await module())).context();
  const picture = context.solve(context.read(text), { width });
  return Array.from({ length: picture.layerCount }, (_, layer) => ({
    positions: picture.table(layer, Table.vertices).data as Float64Array,
    triangles: picture.table(layer, Table.triangles).data,
    edges: picture.table(layer, Table.curveEdges).data,
    nodes: picture.table(layer, Table.colorNodes).data,
    values: picture.table(layer, Table.colorValues).data,
    opacities: picture.table(layer, Table.opacityValues).data,
  }));
}

async function expectSolved(page: Page, text: string, width: number) {
  const expected = await solved(text, width);
  expect(page.layers.length).toBe(expected.length);
  expected.forEach((layer, i) => {
    const have = page.layers[i];
    const middle = [0, 1].map((axis) => {
      const along = layer.positions.filter((_, at) => at % 2 === axis);
      return along.length > 0 ? (Math.min(...along) + Math.max(...along)) / 2 : 0;
    });
    expect(have.origin).toEqual(middle);
    const positions = layer.positions.map((value, at) => Math.fround(value - have.origin[at % 2]));
    expect(have.positions).toEqual(Float32Array.from(positions));
    expect(have.triangleVertex).toEqual(layer.triangles);
    expect(have.edgeIsCurve).toEqual(layer.edges);
    expect(have.color.triangleNode).toEqual(layer.nodes);
    expect(have.color.value).toEqual(layer.values);
    expect(have.opacity?.value ?? new Float32Array()).toEqual(layer.opacities);
  });
}

/** Returns a host that records which worker, from 1, makes each exact and each quick picture. */
function watchedHost() {
  const host = localHost();
  const exact: number[] = [];
  const quick: number[] = [];
  /** Layer and curve of drags that are prepared. */
  const expected: string[] = [];
  const worker = () => {
    const made = host.worker();
    const number = host.workers;
    const post = made.postMessage.bind(made);
    interface Given extends Partial<LayerCurves> {
      readonly way?: { readonly kind: string };
    }
    made.postMessage = (message: { name: string; given: Given[] }) => {
      if (message.name === "expect") expected.push(`${message.given[0].layer} ${message.given[0].curves}`);
      if (message.given[0]?.way?.kind === "exact") exact.push(number);
      if (message.given[0]?.way?.kind === "quick") quick.push(number);
      post(message);
    };
    return made;
  };
  return { host: { ...host, worker }, exact, quick, expected };
}

const ways = [
  { way: "with one worker for what is small", mostInFront: undefined },
  { way: "with two workers", mostInFront: 0 },
];

describe.skipIf(!hasModule).each(ways)("the engine $way", ({ mostInFront }) => {
  let page: Page;
  const open = (host: Host = localHost()) => {
    page = new Page(new WorkerEngine(host, mostInFront));
    look(page.engine);
  };
  afterEach(() => page.engine.free());

  it("ends with the library's own tables, bit for bit", async () => {
    open();
    page.show(drawing(70), false);
    await page.exact();
    await expectSolved(page, drawing(70), 512);
    expect(page.engine.index.curves.map(({ layer, curve }) => [layer, curve])).toEqual([[0, 0], [0, 1], [1, 0]]);
  });

  it("follows a curve that moves, and then is exact", async () => {
    open();
    page.show(drawing(70), false);
    await page.exact();
    const before = page.rows;
    for (let bend = 70; bend < 90; ++bend) {
      page.show(drawing(bend), true, [pointsFor(bend)]);
      await page.until(() => page.updates > 0);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    expect(page.isExact).toBe(false);
    expect(page.rows).toBeGreaterThan(before);
    page.show(drawing(90), false, [pointsFor(90)]);
    await page.exact();
    await expectSolved(page, drawing(90), 512);
  });

  it("goes on with a drag in the worker where it began, after a pause with an exact picture", async () => {
    const { host, exact, quick } = watchedHost();
    open(host);
    page.show(drawing(70), false);
    await page.exact();
    await page.until(() => new Set(exact).size === (mostInFront === 0 ? 2 : 1));
    quick.length = exact.length = 0;
    page.show(drawing(75), true, [pointsFor(75)]);
    await page.exact();
    await expectSolved(page, drawing(75), 512);
    expect(page.engine.index.serial, "curves are counted as when the hand began").toBe(0);
    page.show(drawing(80), true, [pointsFor(80)]);
    await page.until(() => page.statuses.at(-1)?.kind === "refining" && quick.length > 1);
    page.show(drawing(90), false, [pointsFor(90)]);
    await page.exact();
    await expectSolved(page, drawing(90), 512);
    expect(new Set(quick).size).toBe(1);
    if (mostInFront === 0) expect(exact[0]).not.toBe(quick[0]);
  });

  it("begins the drag that is expected while nothing else is to be done", async () => {
    const { host, expected } = watchedHost();
    open(host);
    page.show(drawing(70), false);
    page.engine.expect({ layer: 0, curves: [1] });
    await page.exact();
    await page.until(() => expected.length === 1);
    // It is busy with that; the latest request follows.
    page.engine.expect({ layer: 1, curves: [0] });
    page.engine.expect({ layer: 0, curves: [0] });
    await page.until(() => expected.length === 2);
    const { updates } = page;
    page.engine.expect({ layer: 9, curves: [9] });
    await page.until(() => expected.length === 3);
    page.engine.expect(null);
    expect(page.updates).toBe(updates);
    expect(expected).toEqual(["0 1", "0 0", "9 9"]);
    page.show(drawing(90), true, [pointsFor(90)]);
    page.engine.expect({ layer: 0, curves: [1] });
    page.show(drawing(90), false, []);
    await page.exact();
    await expectSolved(page, drawing(90), 512);
    await page.until(() => expected.length === 4);
    // In another text the index may belong to another curve, or to none.
    page.show(drawing(60), false);
    await page.exact();
    await expectSolved(page, drawing(60), 512);
    expect(expected.length).toBe(4);
  });

  it("counts curves anew after a pause in which one has no length", async () => {
    open();
    page.show(drawing(70), false);
    await page.exact();
    const points = (x: number, y: number): QuickChange => ({
      kind: "points",
      layer: 0,
      curve: 0,
      xy: Float64Array.of(0, 100, x, y, x, y, x, y),
    });
    const text = (x: number, y: number) =>
      drawing(70).replace("M0 100 C60 70 140 130 200 90", `M0 100 C${x} ${y} ${x} ${y} ${x} ${y}`);
    page.show(text(9, 99), true, [points(9, 99)]);
    page.show(text(0, 100), true, [points(0, 100)]);
    await page.exact();
    // The worker that continues the drag still has it, although another one made the exact picture.
    const { curves } = page.engine.index;
    expect(curves.map(({ layer }) => layer)).toEqual(mostInFront === 0 ? [0, 0, 1] : [0, 1]);
    page.show(text(40, 60), true);
    page.show(text(50, 60), false, [points(50, 60)]);
    await page.exact();
    await expectSolved(page, text(50, 60), 512);
  });

  it("sends nothing of layers that stay, and no stack that is as it was", async () => {
    open();
    page.show(drawing(70), false);
    await page.exact();
    const touched = new Set<number>();
    const take = page.engine.onPicture;
    page.engine.onPicture = (update) => {
      update.layers.forEach(({ layer }) => touched.add(layer));
      take(update);
    };
    const { stacks } = page;
    page.show(drawing(70, "#1c2"), false);
    await page.exact();
    expect([...touched]).toEqual([0]);
    expect(page.stacks).toBe(stacks);
  });

  it("gives layers as rays meet them, of what is exact alone", async () => {
    open();
    page.show(drawing(70), false);
    expect(await page.engine.exactLayer(0)).toBe("busy");
    await page.exact();
    const [opaque, translucent, none] = [await idleLayer(0), await idleLayer(1), await idleLayer(2)];
    expect(none).toBeNull();
    expect(opaque!.fields.map(({ channelCount }) => channelCount)).toEqual([3]);
    expect(translucent!.fields.map(({ channelCount }) => channelCount)).toEqual([3, 1]);
    const { x, y } = endsOfSides(opaque!);
    const cubics = [
      [0, 100, 60, 70, 140, 130, 200, 90],
      [80, 30, 90, 10, 110, 10, 120, 30],
    ];
    const away = x.map((_, i) => Math.min(...cubics.map((cubic) => distanceTo(cubic, x[i], y[i]))));
    expect(x.length).toBeGreaterThan(20);
    expect(Math.max(...away)).toBeLessThan(0.02);
    page.show(drawing(80), true, [pointsFor(80)]);
    expect(await page.engine.exactLayer(0)).toBe("busy");
  });

  async function idleLayer(layer: number): Promise<ExactLayer | null> {
    for (;;) {
      const exact = await page.engine.exactLayer(layer);
      if (exact !== "busy") return exact;
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
  }

  it("solves again where it has all the rest, and shows it once", async () => {
    const { host, exact } = watchedHost();
    open(host);
    page.show(drawing(70), false);
    await page.exact();
    const { updates } = page;
    if (mostInFront === 0) await page.until(() => new Set(exact).size === 2);
    await page.engine.lint();
    expect(page.updates).toBe(updates);
    page.show(drawing(80), false);
    await page.exact();
    await expectSolved(page, drawing(80), 512);
    expect(new Set(exact).size).toBe(mostInFront === 0 ? 2 : 1);
  });

  it("keeps a second worker only where it is going to be needed", async () => {
    const host = localHost();
    open(host);
    page.show(drawing(70), false);
    await page.exact();
    await page.until(() => host.living === (mostInFront === 0 ? 2 : 1));
    await page.engine.lint();
    await page.engine.lint();
    expect(host.workers, "one for both looks").toBeLessThan(4);
    expect(host.living).toBe(2);
    await new Promise((resolve) => setTimeout(resolve, 5000));
    expect(host.living).toBe(mostInFront === 0 ? 2 : 1);
    page.show(drawing(80), false);
    await page.exact();
    await expectSolved(page, drawing(80), 512);
  });

  it("knows the curves of the text that rests, also where nothing moved any more", async () => {
    open();
    page.show(drawing(70), false);
    await page.exact();
    page.show(drawing(80), true, [pointsFor(80)]);
    await page.exact();
    page.isExact = false;
    const serial = page.engine.show(drawing(80), false, []);
    await page.exact();
    expect(page.engine.index.serial).toBe(serial);
    expect(page.engine.index.curves.map(({ offset }) => drawing(80).slice(offset, offset + 5))).toEqual(Array(3).fill("<path"));
  });

  it("leaves alone what has only moved in the stack", async () => {
    const { host, exact } = watchedHost();
    open(host);
    const [head, first, second, tail] = drawing(70).split(/(?=  <g )|(?=<.svg>)/);
    page.show(drawing(70), false);
    await page.exact();
    await page.until(() => new Set(exact).size === (mostInFront === 0 ? 2 : 1));
    const text = [head, second, first, tail].join("");
    page.show(text, false);
    await page.exact();
    await expectSolved(page, text, 512);
  });

  it("is exact in the end whatever comes when", async () => {
    open();
    let state = 7;
    const random = (below: number) => (state = (state * 16807) % 2147483647) % below;
    let bend = 70;
    let color = "#c21";
    for (let i = 0; i < 120; ++i) {
      const kind = random(5);
      if (kind === 0) color = `#${(0x100 + random(0xeff)).toString(16)}`;
      bend = 20 + random(100);
      const quick = kind > 1 ? [pointsFor(bend)] : undefined;
      page.show(drawing(bend, color), kind > 2, kind === 0 ? undefined : quick);
      if (random(4) === 0) page.engine.look(2 ** random(3), artboard, artboard);
      if (random(3) === 0) await new Promise((resolve) => setTimeout(resolve, random(200)));
    }
    // More than twice as near as any picture before: it is made for these pixels.
    page.engine.look(9, artboard, artboard);
    page.show(drawing(bend, color), false, [pointsFor(bend)]);
    await page.exact();
    await page.until(() => page.statuses.at(-1)?.kind === "exact");
    await new Promise((resolve) => setTimeout(resolve, 800));
    await expectSolved(page, drawing(bend, color), 3200);
  }, 60_000);

  it("shows the picture before an edit at once, and solves it once the text rests", async () => {
    const { host, exact } = watchedHost();
    open(host);
    page.show(drawing(70), false);
    await page.exact();
    page.show(drawing(80), true, [pointsFor(80)]);
    page.show(drawing(80), false, [pointsFor(80)]);
    await page.exact();
    for (const bend of [70, 80, 70]) {
      const updates = page.updates;
      const solves = exact.length;
      page.show(drawing(bend), false, [pointsFor(bend)]);
      expect(page.isExact && page.statuses.at(-1)?.kind === "exact").toBe(true);
      await expectSolved(page, drawing(bend), 512);
      expect([page.updates, exact.length]).toEqual([updates + 1, solves]);
    }
    const solves = exact.length;
    await page.until(() => exact.length > solves);
    // Frames go on from there, and leave the kept tables as they are.
    page.show(drawing(90), true, [pointsFor(90)]);
    await page.until(() => page.statuses.at(-1)?.kind === "refining");
    page.show(drawing(70), false, [pointsFor(70)]);
    await page.exact();
    await expectSolved(page, drawing(70), 512);
  });

  it("says where a text is wrong, keeps the picture, and goes on", async () => {
    open();
    page.show(drawing(70), false);
    await page.exact();
    page.show(drawing(70, "re"), false);
    await page.until(() => page.statuses.at(-1)?.kind === "problem");
    const problem = page.statuses.at(-1);
    expect(problem).toMatchObject({ kind: "problem", line: 4 });
    expect(page.layers.length).toBe(2);
    page.show(drawing(80), false);
    await page.exact();
    await expectSolved(page, drawing(80), 512);
  });

  it("gives colours, pixels, payload and hints of the text as it is", async () => {
    open();
    page.show(drawing(70), false);
    const [r, g, b, a] = await page.engine.colors(1, Float64Array.of(20, 40));
    expect([r, g, b, a].map((value) => Math.round(10 * value))).toEqual([0, 0, 10, 5]);
    const wish = { width: 20, height: 15, viewport: null, background: "#fff", depth: 8 } as const;
    const pixels = await page.engine.raster(wish);
    expect(pixels.length).toBe(4 * 20 * 15);
    expect(new Set(pixels).size).toBeGreaterThan(10);
    const payload = await page.engine.payload();
    expect(new TextDecoder().decode(payload.slice(0, 7))).toBe("SFUMATO");
    await page.exact();
    expect((await page.engine.lint())?.map(({ rule }) => rule)).toEqual(["leak"]);
  });

  it("reads every example", async () => {
    open();
    for (const name of ["flower", "strokes", "fish", "portrait"]) {
      page.statuses.length = 0;
      page.show(textOf(`examples/${name}.svg`), false);
      await page.until(() => ["exact", "problem"].includes(page.statuses.at(-1)?.kind ?? ""));
      expect([name, page.statuses.at(-1)!.kind]).toEqual([name, "exact"]);
      expect(page.layers.length).toBeGreaterThan(0);
    }
  }, 120_000);
});

/** A worker whose quick pictures need several more rounds, and whose exact pictures take long. */
class SlowWorker {
  onmessage: ((event: MessageEvent) => void) | null = null;
  #rounds = 0;

  postMessage({ id, name, given }: { id: number; name: string; given: { way?: { kind: string } }[] }) {
    const isExact = given[0]?.way?.kind === "exact";
    if (name === "read") this.#rounds = 40;
    const waiting = isExact ? 0 : this.#rounds--;
    const solved = { stack: null, stackStamp: "", stamps: [], layers: [], waiting, unsettled: 1e6, largest: 1e6, milliseconds: 1 };
    const values: Record<string, unknown> = { start: "1", read: { curves: [], warnings: [] }, solve: solved };
    setTimeout(() => this.onmessage?.({ data: { id, value: values[name] } } as MessageEvent), isExact ? 300 : 2);
  }

  terminate() {}
}

it("goes on with the rough picture while a large one is made exact", async () => {
  const host = { module: async () => ({}) as WebAssembly.Module, worker: () => new SlowWorker() as unknown as Worker };
  const page = new Page(new WorkerEngine(host));
  page.show("a", false);
  await page.exact();
  // After this time an edit settles at once.
  await new Promise((resolve) => setTimeout(resolve, 900));
  const before = page.updates;
  page.show("b", false);
  await page.exact();
  expect(page.updates - before).toBeGreaterThan(20);
  page.engine.free();
});

describe.skipIf(!hasModule)("a module that fails while it prepares a drag", () => {
  /** Returns a host in which the first worker that prepares a drag fails with this code. */
  const failing = (code: number) => {
    const host = localHost();
    let hasFailed = false;
    const worker = () => {
      const made = host.worker();
      const post = made.postMessage.bind(made);
      made.postMessage = (message: { id: number; name: string }) => {
        if (hasFailed || message.name !== "expect") return post(message);
        hasFailed = true;
        const failure = { message: "no", reason: "no", code, line: 0, column: 0 };
        setTimeout(() => made.onmessage?.({ data: { id: message.id, failure } } as MessageEvent));
      };
      return made;
    };
    return { host, page: new Page(new WorkerEngine({ ...host, worker })) };
  };
  const expectAfter = async (code: number) => {
    const { host, page } = failing(code);
    look(page.engine);
    page.show(drawing(70), false);
    await page.exact();
    const { workers } = host;
    page.engine.expect({ layer: 0, curves: [1] });
    await new Promise((resolve) => setTimeout(resolve, 50));
    const started = host.workers - workers;
    page.show(drawing(90), false);
    await page.exact();
    await expectSolved(page, drawing(90), 512);
    page.engine.free();
    return started;
  };

  it("is replaced where it has trapped, and the next text is drawn", async () => {
    expect(await expectAfter(0)).toBe(1);
  });

  it("stays where the text is to blame", async () => {
    expect(await expectAfter(Status.badInput)).toBe(0);
  });
});
