// The model reads the same as the engine: the same curves at the same places with the same stops.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test, vi } from "vitest";
import { determinant, lengthScale, mapped } from "../../../../web/editor/src/geometry/affine.js";
import { parameterAtSegment } from "../../../../web/editor/src/geometry/length.js";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import type { CurveItem, Drawing, Item, SideValue } from "../../../../web/editor/src/model/types.js";
import { sf, valueOf } from "../../../../web/editor/src/source/attributes.js";
import { COLORS, RADII, readSide, SHARES } from "../../../../web/editor/src/source/stops.js";
import type { Notation } from "../../../../web/editor/src/source/stops.js";
import { SourceError } from "../../../../web/editor/src/source/tree.js";
import { examples, fuzzed, randomNumbers, repository, scenes, scenesFolder } from "../corpus.js";
import type { Source } from "../corpus.js";
import { randomDocument } from "../documents.js";

// These tests generate much input, and machines may be busy.
vi.setConfig({ testTimeout: 120_000 });

const modulePath = process.env.SFUMATO_WASM ?? join(repository, "build-wasm/sfumato.wasm");
const isBuilt = existsSync(modulePath);

interface Stops {
  readonly kind: number;
  readonly space: number;
  readonly rows: readonly (readonly number[])[];
}

/** The part of the module's documents that the tests use. */
interface EngineDocument {
  readonly artboard: readonly number[];
  readonly layerCount: number;
  curveCount(layer: number): number;
  curveSource(layer: number, curve: number): { byteOffset: number; subpath: number } | null;
  points(layer: number, curve: number): Float64Array;
  stops(layer: number, curve: number, side: number, attribute: number): Stops;
  write(): string;
  free(): void;
}

interface EngineContext {
  read(
    text: string | Uint8Array,
    from?: { load?: (href: string) => Uint8Array | null },
  ): EngineDocument;
  addImage(file: Uint8Array, image: { width: number; height: number; data: Uint8Array }): void;
}

const KINDS = ["open", "barrier", "stops", "paint"];
const ATTRIBUTES = ["color", "opacity", "blur"] as const;

async function engine(): Promise<EngineContext> {
  const library = (await import(join(repository, "web/wasm/sfumato.mjs"))) as {
    loadSfumato(bytes: Uint8Array): Promise<{ context(): EngineContext }>;
  };
  return (await library.loadSfumato(readFileSync(modulePath))).context();
}

/** Pictures have one pixel here, because only their presence matters. */
function imageLoader(context: EngineContext) {
  return (href: string): Uint8Array | null => {
    const path = join(repository, "examples", href);
    if (!existsSync(path)) return null;
    const file = readFileSync(path);
    context.addImage(file, { width: 1, height: 1, data: new Uint8Array(4) });
    return file;
  };
}

/** Converts offsets in UTF-8 to offsets in UTF-16. */
function utf16Offsets({ bytes }: Source): (offset: number) => number {
  const known = new Map<number, number>();
  return (offset) => {
    const found = known.get(offset) ?? bytes.toString("utf8", 0, offset).length;
    known.set(offset, found);
    return found;
  };
}

function differs(a: number, b: number): boolean {
  return !(Math.abs(a - b) <= 1e-6 * Math.max(1, Math.abs(a), Math.abs(b)));
}

/** Returns the side of one subpath, because a list with "@" and percentages depends on its segments. */
function sideOf(item: CurveItem, side: "left" | "right", attribute: number, path: number) {
  const name = ATTRIBUTES[attribute];
  if (path === 0) return item[side][name] as SideValue<unknown>;
  const cubic = item.paths[path];
  const segments = cubic.segments ? cubic.segments.length - 1 : (cubic.points.length - 1) / 3;
  const own = name === "color" ? side : `${side}-${name}`;
  const text = valueOf(item.element, sf(own)) ?? valueOf(item.element, sf(name));
  const notation = [COLORS, SHARES, RADII][attribute] as Notation<unknown>;
  return readSide(name === "color" ? valueOf(item.element, sf(side)) : text, notation, segments);
}

/** Returns the stops that the engine should have for a side. */
function expectedStops(
  item: CurveItem,
  side: "left" | "right",
  attribute: number,
  path: number,
): Stops {
  const value = sideOf(item, side, attribute, path);
  const kind = KINDS.indexOf(value.kind);
  if (value.kind !== "stops") return { kind, space: 0, rows: [] };
  const scale = attribute === 2 ? lengthScale(item.layerFromItem) : 1;
  const rows = value.stops.map((stop) => {
    const isParameter = value.space === "parameter";
    const offset = isParameter ? parameterAtSegment(item.paths[path], stop.offset) : stop.offset;
    if (typeof stop.value === "number") return [offset, Math.min(stop.value * scale, 1e7)];
    const { r, g, b } = stop.value as { r: number; g: number; b: number };
    return [offset, r, g, b];
  });
  // Radii that are 0 everywhere count as no blur.
  const isSharp = attribute === 2 && rows.every(([, radius]) => radius === 0);
  if (isSharp) return { kind: 0, space: 0, rows: [] };
  return { kind, space: value.space === "parameter" ? 1 : 0, rows };
}

function stopsDifference(actual: Stops, expected: Stops): string {
  // A list without stops is equal to no list, as for blur.
  const isNothing = ({ kind, rows }: Stops) => rows.length === 0 && (kind === 0 || kind === 2);
  if (isNothing(actual) && isNothing(expected)) return "";
  if (actual.kind !== expected.kind) return `kind ${actual.kind}, not ${expected.kind}`;
  if (actual.rows.length !== expected.rows.length) return `${actual.rows.length} stops`;
  if (actual.rows.length > 0 && actual.space !== expected.space) return `space ${actual.space}`;
  for (const [i, row] of actual.rows.entries()) {
    const wrong = row.findIndex((value, k) => differs(value, expected.rows[i][k]));
    if (wrong >= 0) return `stop ${i}: ${row} is not ${expected.rows[i]}`;
  }
  return "";
}

/** Returns the difference between a curve of the engine and of the model. */
function curveDifference(
  document: EngineDocument,
  layer: number,
  curve: number,
  item: CurveItem,
  path: number,
): string {
  const points = document.points(layer, curve);
  const own = item.paths[path];
  if (!own) return `there is no subpath ${path}`;
  if (points.length !== 2 * own.points.length) {
    return `${points.length / 2} points, not ${own.points.length}`;
  }
  // Copies of <use> are at other places.
  if (item.copies > 1 || !item.parent) return "";
  const wrong = own.points.findIndex((point, i) => {
    const [x, y] = mapped(item.layerFromItem, point);
    return differs(x, points[2 * i]) || differs(y, points[2 * i + 1]);
  });
  if (wrong >= 0) return `point ${wrong} is ${points.slice(2 * wrong, 2 * wrong + 2)}`;
  const isMirrored = determinant(item.layerFromItem) < 0;
  for (const [s, side] of (["left", "right"] as const).entries()) {
    for (const attribute of ATTRIBUTES.keys()) {
      const from = isMirrored ? (side === "left" ? "right" : "left") : side;
      const actual = document.stops(layer, curve, s, attribute);
      const what = stopsDifference(actual, expectedStops(item, from, attribute, path));
      if (what !== "") return `${side} ${ATTRIBUTES[attribute]}: ${what}`;
    }
  }
  return "";
}

/** Returns whether the picture shows an item that no <use> copies, and does not flatten it to nothing. */
function isShown(item: Item): boolean {
  if (item.hidden || determinant(item.artboardFromItem) === 0) return false;
  for (let outer = item.parent; outer; outer = outer.parent) if (outer.hidden) return false;
  return true;
}

/** Returns the number of visible curves, counting each subpath; null if <use> makes copies. */
function countOfCurves(d: Drawing): number | null {
  let count = 0;
  for (const item of d.all()) {
    if (item.kind === "use") return null;
    if (item.kind === "curve" && isShown(item)) count += item.paths.length;
  }
  return count;
}

/** Returns the differences between the engine's and the model's reading of a text. */
function difference(source: Source, document: EngineDocument): string {
  const d = openDrawing(source.text);
  const [x0, y0, x1, y1] = d.artboard;
  const box = [x0, y0, x1 - x0, y1 - y0];
  if (document.artboard.some((value, i) => differs(value, box[i]))) return `artboard ${box}`;
  const offsetOf = utf16Offsets(source);
  let count = 0;
  for (let layer = 0; layer < document.layerCount; layer += 1) {
    for (let curve = 0; curve < document.curveCount(layer); curve += 1) {
      const place = document.curveSource(layer, curve);
      if (!place) return `curve ${layer}.${curve} has no source`;
      const item = d.itemAt(offsetOf(place.byteOffset));
      if (item?.kind !== "curve") return `no curve at byte ${place.byteOffset}`;
      const what = curveDifference(document, layer, curve, item, place.subpath);
      if (what !== "") return `${layer}.${curve} ${item.name}: ${what}`;
      count += 1;
    }
  }
  const expected = countOfCurves(d);
  return expected === null || count === expected
    ? ""
    : `the engine has ${count} curves, the model ${expected}`;
}

function readOrNull(context: EngineContext, { bytes }: Source): EngineDocument | null {
  try {
    return context.read(bytes);
  } catch {
    return null;
  }
}

/** Returns null if the text is not XML; the engine's parser is more tolerant. */
function differenceOrNull(source: Source, document: EngineDocument): string | null {
  try {
    return difference(source, document);
  } catch (error) {
    if (error instanceof SourceError) return null;
    throw error;
  }
}

describe.skipIf(!isBuilt)(`the model agrees with the engine (SFUMATO_WASM: ${modulePath})`, () => {
  test("on every example", async () => {
    const context = await engine();
    for (const source of examples()) {
      const document = context.read(source.bytes, { load: imageLoader(context) });
      expect(difference(source, document), source.name).toBe("");
      document.free();
    }
  });

  test.skipIf(scenesFolder === null)(
    "on every scene of the paper (SFUMATO_SCENES)",
    async () => {
      const context = await engine();
      for (const scene of scenes()) {
        const original = context.read(scene.bytes);
        const text = original.write();
        const source = { name: scene.name, bytes: Buffer.from(text), text };
        const document = context.read(text);
        expect(difference(source, document), scene.name).toBe("");
        document.free();
        original.free();
      }
    },
    120_000,
  );

  test("on every find of the fuzzers that the engine reads", async () => {
    const context = await engine();
    let count = 0;
    const wrong: string[] = [];
    for (const source of fuzzed()) {
      const document = readOrNull(context, source);
      if (!document) continue;
      const what = differenceOrNull(source, document);
      if (what !== null) count += 1;
      if (what) wrong.push(`${source.name}: ${what}`);
      document.free();
    }
    expect(wrong).toEqual([]);
    expect(count).toBeGreaterThan(300);
  });

  test("on documents of all notations, transforms and styles", async () => {
    const context = await engine();
    for (let seed = 1; seed <= 400; seed += 1) {
      const text = randomDocument(randomNumbers(seed));
      const document = context.read(text);
      const what = difference({ name: "", bytes: Buffer.from(text), text }, document);
      expect(what && `${what}\n${text}`, `seed ${seed}`).toBe("");
      document.free();
    }
  });
});
