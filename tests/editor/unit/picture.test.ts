// Commands that must not change the picture, compared by pixels; and transforms, compared with the moved picture.
import { expect, test } from "vitest";
import {
  deleteItems,
  group,
  makeUnique,
  moveInto,
  rename,
  restack,
  reverseCurves,
  splitPiece,
  transform,
  ungroup,
} from "../../../web/editor/src/model/commands/index.js";
import { openDrawing } from "../../../web/editor/src/model/drawing.js";
import type { CurveItem, Drawing, Item, Outcome } from "../../../web/editor/src/model/types.js";
import { applied, inverse } from "../../../web/editor/src/source/patch.js";
import { examples, modulePath, SAMPLES } from "./drawings.js";
import type { Sample } from "./drawings.js";
import { difference, painter } from "./picture.js";
import type { Painter, Pixels } from "./picture.js";
import { Random } from "./random.js";

/**
 * Code values. Rewritten numbers lie up to half a step, 1e-7 of the artboard, from their former values, so the mesh
 * may have other triangles. Each picture is within max-error = 1 of the exact one, except single pixels beside
 * curves; the mean difference is far smaller.
 */
const MOST_MEAN = 0.05;
const MOST = 5;

/** Returns a text after some commands, or null if they do nothing. */
type Trial = (d: Drawing, random: Random) => string | null;

function done(d: Drawing, outcome: Outcome | null): string | null {
  return outcome && applied(d.text, outcome.patch);
}

function pick(d: Drawing, random: Random, fits: (item: Item) => boolean = () => true): Item | null {
  const all = [...d.all()].filter(fits);
  return all.length > 0 ? random.pick(all) : null;
}

/** Returns consecutive siblings. */
function row(d: Drawing, random: Random): Item[] {
  const item = pick(d, random);
  if (!item) return [];
  const siblings = item.parent?.children ?? d.items;
  const from = siblings.indexOf(item);
  return siblings.slice(from, from + 1 + random.below(3));
}

const isCurve = ({ kind }: Item) => kind === "curve" || kind === "stroke";
const handles = (items: readonly Item[]) => items.map(({ handle }) => handle);

const TRIALS: Readonly<Record<string, Trial>> = {
  group: (d, random) => done(d, group(d, handles(row(d, random)))),
  ungroup: (d, random) => {
    const item = pick(d, random, ({ kind }) => kind === "group");
    return item && done(d, ungroup(d, [item.handle]));
  },
  "group, then ungroup": (d, random) => {
    const outcome = group(d, handles(row(d, random)));
    if (!outcome) return null;
    d.apply(outcome.patch);
    const made = d.itemAt(outcome.select?.[0].at ?? -1);
    return made ? done(d, ungroup(d, [made.handle])) : null;
  },
  makeUnique: (d, random) => {
    const item = pick(d, random, ({ kind }) => kind === "use");
    return item && done(d, makeUnique(d, item.handle));
  },
  "restack up and down": (d, random) => {
    const item = pick(d, random);
    const outcome = item && restack(d, [item.handle], 1);
    if (!outcome) return null;
    d.apply(outcome.patch);
    const moved = d.itemAt(outcome.select?.[0].at ?? -1);
    return moved ? done(d, restack(d, [moved.handle], -1)) : null;
  },
  "moveInto, next to itself": (d, random) => {
    // Moves an item out of a plain group or into one, between the same neighbours.
    const item = pick(d, random, ({ parent }) => parent?.kind === "group");
    const around = item?.parent;
    if (!item || !around || around.opacity < 1 || around.blend !== "normal") return null;
    // An item that leaves a group also leaves the group's instances.
    if ([...d.all()].some((use) => use.kind === "use" && use.target === around)) return null;
    const siblings = around.parent?.children ?? d.items;
    const index = siblings.indexOf(around);
    if (index < 0) return null;
    if (item === around.children.at(-1)) return done(d, moveInto(d, [item.handle], around.parent?.handle ?? null, index + 1));
    if (item !== around.children[0]) return null;
    return done(d, moveInto(d, [item.handle], around.parent?.handle ?? null, index));
  },
  reverse: (d, random) => {
    const item = pick(d, random, isCurve);
    return item && done(d, reverseCurves(d, [item.handle], 1e-6));
  },
  splitPiece: (d, random) => {
    const item = pick(d, random, isCurve) as CurveItem | null;
    if (!item || item.paths.length === 0) return null;
    const path = random.below(item.paths.length);
    const pieces = (item.paths[path].points.length - 1) / 3;
    return done(d, splitPiece(d, item.handle, path, random.below(pieces), random.between(0.1, 0.9), 1e-6));
  },
  rename: (d, random) => {
    const item = pick(d, random);
    return item && done(d, rename(d, item.handle, random.pick(["far", "a b", "x&y", "Ünder"])));
  },
  "delete, undone": (d, random) => {
    const item = pick(d, random);
    const outcome = item && deleteItems(d, [item.handle]);
    return outcome && applied(applied(d.text, outcome.patch), inverse(outcome.patch));
  },
};

const texts = [...SAMPLES, ...examples().filter(({ text }) => text.length < 60000)];
const pictures = new Map<string, Pixels>();

function pictureOf({ paint }: Painter, text: string): Pixels {
  const known = pictures.get(text) ?? paint(text);
  pictures.set(text, known);
  return known;
}

const isThere = modulePath() !== null;

test.skipIf(!isThere).each(Object.keys(TRIALS))("%s leaves the picture as it is", async (name) => {
  const easel = (await painter()) as Painter;
  const random = new Random(name.length * 31 + 3);
  let compared = 0;
  for (let i = 0; i < 60 && compared < 14; i += 1) {
    const sample = random.pick(texts);
    const text = TRIALS[name](openDrawing(sample.text), random);
    if (text === null) continue;
    compared += 1;
    const { most, mean } = difference(pictureOf(easel, sample.text), easel.paint(text));
    const context = `${name} ${i} of ${sample.name}: ${most}, mean ${mean}`;
    expect(mean, context).toBeLessThan(MOST_MEAN);
    expect(most, context).toBeLessThan(MOST);
  }
  expect(compared).toBeGreaterThan(3);
}, 240_000);

/** A map of the artboard, and its effect on the picture. */
interface Mirror {
  readonly map: (box: Drawing["artboard"]) => readonly number[];
  /** Returns the former picture's pixel that moves to x, y. */
  readonly from: (x: number, y: number, width: number, height: number) => readonly [number, number];
}

const MIRRORS: Readonly<Record<string, Mirror>> = {
  "left to right": {
    map: ([x0, , x1]) => [-1, 0, 0, 1, x0 + x1, 0],
    from: (x, y, width) => [width - 1 - x, y],
  },
  "upside down": {
    map: ([, y0, , y1]) => [1, 0, 0, -1, 0, y0 + y1],
    from: (x, y, _, height) => [x, height - 1 - y],
  },
  "half a turn": {
    map: ([x0, y0, x1, y1]) => [-1, 0, 0, -1, x0 + x1, y0 + y1],
    from: (x, y, width, height) => [width - 1 - x, height - 1 - y],
  },
};

function mirrored(pixels: Pixels, from: Mirror["from"], width: number): Pixels {
  const height = pixels.length / 4 / width;
  return pixels.map((_, i) => {
    const [x, y] = [(i >> 2) % width, Math.floor((i >> 2) / width)];
    const [u, v] = from(x, y, width, height);
    return pixels[4 * (v * width + u) + (i & 3)];
  });
}

/** Returns all movable items: whole layers, groups and uses, or every single curve. */
function movable(d: Drawing, isEachCurve: boolean): readonly Item[] {
  if (!isEachCurve) return d.items;
  return [...d.all()].filter(({ kind }) => kind === "curve" || kind === "stroke");
}

/** The mesh of a mirrored drawing has other triangles: the limit above, for all pixels at once. */
const MOST_MEAN_MIRRORED = 0.4;
/** Share of pixels that may differ by more than 6 code values: pixels on sharp curves. */
const ODD_SHARE = 0.01;

/** Excluded: textures repeat beyond the artboard and stay, and curves copied by uses would move twice. */
function samplesFor(isEachCurve: boolean): readonly Sample[] {
  return texts.filter(({ text }) => !/<pattern/.test(text) && !(isEachCurve && /<(s:)?use/.test(text)));
}

test.skipIf(!isThere).each(Object.keys(MIRRORS))("transform, %s: the picture is the mirrored one", async (name) => {
  const easel = (await painter()) as Painter;
  const { map, from } = MIRRORS[name];
  for (const isEachCurve of [false, true]) {
    for (const sample of samplesFor(isEachCurve)) {
      const d = openDrawing(sample.text);
      const text = done(d, transform(d, handles(movable(d, isEachCurve)), map(d.artboard), 1e-4)) ?? sample.text;
      const before = mirrored(pictureOf(easel, sample.text), from, 128);
      const after = easel.paint(text);
      const context = `${sample.name}, ${isEachCurve ? "curves" : "layers"}`;
      expectAlike(before, after, context);
    }
  }
}, 240_000);

function expectAlike(before: Pixels, after: Pixels, context: string): void {
  const { mean } = difference(before, after);
  const odd = before.filter((value, i) => Math.abs(value - after[i]) > 6).length / before.length;
  expect(mean, context).toBeLessThan(MOST_MEAN_MIRRORED);
  expect(odd, context).toBeLessThan(ODD_SHARE);
}

test.skipIf(!isThere)("transform by similarities: seen in the moved artboard, the picture is the same", async () => {
  const easel = (await painter()) as Painter;
  const random = new Random(11);
  for (const isEachCurve of [false, true]) {
    // A background is not an item, and it keeps covering the artboard.
    const bare = samplesFor(isEachCurve).filter(({ text }) => !/<rect width="(100%|200)"/.test(text));
    expect(bare.length).toBeGreaterThan(1);
    for (const sample of bare) {
      const d = openDrawing(sample.text);
      const [x0, y0, x1, y1] = d.artboard;
      const k = random.between(0.4, 2.5);
      const [x, y] = random.point(50);
      const text = done(d, transform(d, handles(movable(d, isEachCurve)), [k, 0, 0, k, x, y], 1e-4)) as string;
      const box = [k * x0 + x, k * y0 + y, k * (x1 - x0), k * (y1 - y0)].join(" ");
      const seen = text.replace(/viewBox=(["'])[^"']*/, `viewBox=$1${box}`);
      expectAlike(pictureOf(easel, sample.text), easel.paint(seen), `${sample.name}, ${isEachCurve}`);
    }
  }
}, 240_000);
