import { signal } from "@preact/signals";
import { describe, expect, test } from "vitest";
import {
  composed,
  mapped,
  translation,
  type Affine,
  type Point,
} from "../../../../web/editor/src/geometry/affine.js";
import { pieceCount, type CubicPath } from "../../../../web/editor/src/geometry/cubic.js";
import { pathPointAt } from "../../../../web/editor/src/geometry/length.js";
import { CurveGrid, layerAt, markAt } from "../../../../web/editor/src/canvas/hit.js";
import type { Mark } from "../../../../web/editor/src/canvas/marks.js";
import { editedAt, isOutOfReach, type Place } from "../../../../web/editor/src/canvas/places.js";
import { curve, FakeDrawing, layer, line, use } from "../support/drawing.js";
import { placesIn } from "../support/editor.js";
import { randomFrom } from "../random.js";

const STAGE = { width: 800, height: 600 };

function randomPath(next: () => number, pieces: number, spread: number): CubicPath {
  const from: Point = [next() * 900 - 50, next() * 700 - 50];
  const points: Point[] = [from];
  for (let k = 0; k < 3 * pieces; k += 1) {
    const [x, y] = points[points.length - 1];
    points.push([x + (next() - 0.5) * spread, y + (next() - 0.5) * spread]);
  }
  return { points, closed: false };
}

/** Returns points of a path, so dense that each is at most a tenth of a pixel from the next. */
function pointsOf(path: CubicPath, map: Affine, count: number): Point[] {
  const pieces = pieceCount(path);
  return Array.from({ length: count + 1 }, (_, k) =>
    mapped(map, pathPointAt(path, (k / count) * pieces)),
  );
}

function distanceTo(points: readonly Point[], [x, y]: Point): number {
  return Math.sqrt(
    points.reduce((least, [px, py]) => Math.min(least, (px - x) ** 2 + (py - y) ** 2), Infinity),
  );
}

function gridOf(places: readonly Place[], map: Affine): CurveGrid {
  return new CurveGrid(places, map, STAGE.width, STAGE.height);
}

describe("curves near a point", () => {
  test.each([0.2, 1, 7, 300])("are_those_that_a_search_without_a_grid_finds_at_zoom_%d", (zoom) => {
    const next = randomFrom(3 + zoom);
    const map: Affine = [zoom, 0, 0, zoom, 0, 0];
    const curves = Array.from({ length: 60 }, (_, k) => {
      const path = randomPath(next, 1 + Math.floor(next() * 4), 220);
      return curve(`c${k}`, [
        { ...path, points: path.points.map(([x, y]): Point => [x / zoom, y / zoom]) },
      ]);
    });
    const places = placesIn(new FakeDrawing([layer("l", curves)]));
    const grid = gridOf(places, map);
    const points = places.map(({ item }) => pointsOf(item.paths[0], map, 2000));
    let found = 0;
    for (let k = 0; k < 80; k += 1) {
      const at: Point = [next() * STAGE.width, next() * STAGE.height];
      const exact = places
        .map((place, i) => ({ place, distance: distanceTo(points[i], at) }))
        .filter(({ distance }) => distance <= 10);
      const hits = grid.near(at, 10);
      found += hits.length;
      // Chords may be a quarter of a pixel from their curves.
      for (const { place, distance } of exact.filter((one) => one.distance < 9.7)) {
        const hit = hits.find((one) => one.place === place);
        expect(hit, `${place.item.name} at ${at}`).toBeDefined();
        expect(Math.abs((hit?.distance ?? 0) - distance)).toBeLessThan(0.3);
      }
      for (const hit of hits) {
        const there = mapped(map, pathPointAt(hit.place.item.paths[0], hit.at));
        expect(Math.hypot(there[0] - hit.point[0], there[1] - hit.point[1])).toBeLessThan(0.6);
      }
      expect(hits.map(({ distance }) => distance)).toEqual(
        [...hits.map(({ distance }) => distance)].sort((a, b) => a - b),
      );
    }
    expect(found).toBeGreaterThan(20);
  });

  test("long_straight_lines_are_found_everywhere_along_them", () => {
    const next = randomFrom(9);
    for (let k = 0; k < 100; k += 1) {
      const path = line(
        [next() * 3000 - 1000, next() * 3000 - 1000],
        [next() * 3000 - 1000, next() * 3000 - 1000],
      );
      const grid = gridOf(placesIn(new FakeDrawing([curve("c", [path])])), [1, 0, 0, 1, 0, 0]);
      for (let share = 0; share <= 1; share += 0.01) {
        const [x, y] = pathPointAt(path, share);
        if (x < 0 || y < 0 || x > STAGE.width || y > STAGE.height) continue;
        expect(grid.near([x, y], 1)).toHaveLength(1);
      }
    }
  });

  test("the_one_on_top_comes_first_of_two_in_one_place", () => {
    const [low, high] = [
      curve("low", [line([0, 50], [100, 50])]),
      curve("high", [line([0, 50], [100, 50])]),
    ];
    const grid = gridOf(placesIn(new FakeDrawing([low, high])), [1, 0, 0, 1, 0, 0]);
    expect(grid.near([50, 52], 6).map(({ place }) => place.item.name)).toEqual(["high", "low"]);
  });

  test("hidden_and_locked_things_and_what_is_in_them_are_not_hit", () => {
    const path = [line([0, 50], [100, 50])];
    const drawing = new FakeDrawing([
      layer("hidden", [curve("a", path)], { hidden: true }),
      layer("locked", [curve("b", path)], { locked: true }),
      layer("seen", [
        curve("c", path, { locked: true }),
        curve("d", path, { hidden: true }),
        curve("e", path),
      ]),
    ]);
    expect(
      gridOf(placesIn(drawing), [1, 0, 0, 1, 0, 0])
        .near([50, 50], 6)
        .map(({ place }) => place.item.name),
    ).toEqual(["e"]);
  });

  test("a_curve_that_cannot_be_turned_back_is_not_hit", () => {
    const flat = curve("flat", [line([0, 50], [100, 50])], {
      artboardFromItem: [1, 0, 0, 0, 0, 0],
    });
    expect(placesIn(new FakeDrawing([flat]))).toEqual([]);
  });

  test("numbers_that_are_none_hit_nothing_and_stop_nothing", () => {
    const bad = curve("bad", [
      {
        points: [
          [NaN, 0],
          [1, 1],
          [2, Infinity],
          [3, 3],
        ],
        closed: false,
      },
    ]);
    const grid = gridOf(
      placesIn(new FakeDrawing([bad, curve("good", [line([0, 50], [100, 50])])])),
      [1, 0, 0, 1, 0, 0],
    );
    expect(grid.near([50, 50], 6)).toHaveLength(1);
  });
});

describe("copies by <use>", () => {
  test("are_hit_where_they_are_shown_and_mean_the_use", () => {
    const original = layer("fish", [curve("fin", [line([10, 10], [60, 10])])], {
      artboardFromItem: translation(5, 0),
    });
    (original.children[0] as { artboardFromItem: Affine }).artboardFromItem = translation(5, 0);
    const group = { ...layer("group", [original]), kind: "group" as const };
    (original as { parent: unknown }).parent = group;
    const copy = use("copy", original, composed(translation(100, 200), [2, 0, 0, 2, 0, 0]), {
      x: "10",
      y: "20",
    });
    const grid = gridOf(placesIn(new FakeDrawing([group, copy])), [1, 0, 0, 1, 0, 0]);
    expect(grid.near([40, 10], 2).map(({ place }) => place.owner.name)).toEqual(["fin"]);
    // (30, 10) of the curve is (35, 10) of the artboard, and through the use 2 (35 + 10, 10 + 20) + (100, 200).
    const hits = grid.near([190, 260], 2);
    expect(hits.map(({ place }) => place.owner.name)).toEqual(["copy"]);
    expect(hits[0].place.item.name).toBe("fin");
  });

  test("are_edited_where_their_curve_stands_and_elsewhere_as_a_whole", () => {
    const fin = curve("fin", [line([10, 10], [60, 10])], { artboardFromItem: translation(7, 0) });
    const group = { ...layer("fish", [fin]), artboardFromItem: translation(7, 0) };
    (fin as { parent: unknown }).parent = group;
    const [here, there] = [
      use("here", group, translation(7, 0)),
      use("there", group, translation(0, 90)),
    ];
    const places = placesIn(new FakeDrawing([here, there]));
    expect(places.map(({ owner }) => owner.name)).toEqual(["here", "there"]);
    expect(places.map((place) => editedAt(place).name)).toEqual(["fin", "there"]);
  });

  test("outside_an_isolated_layer_are_out_of_reach", () => {
    const [low, high] = ["low", "high"].map((name) => layer(name, [curve(`${name}-curve`, [line([0, 0], [9, 9])])]));
    const copy = use("copy", low, translation(20, 0));
    const drawing = new FakeDrawing([low, high, copy]);
    const owners = (isolated: number | null) => placesIn(drawing, isolated).map(({ owner }) => owner.name);
    expect(owners(null)).toEqual(["low-curve", "high-curve", "copy"]);
    expect(owners(low.handle)).toEqual(["low-curve"]);
    expect(owners(high.handle)).toEqual(["high-curve"]);
    expect(owners(copy.handle)).toEqual(["copy"]);
    const isReached = (item: typeof low, isolated: number) => !isOutOfReach({ isolated: signal(isolated) }, item);
    expect(isReached(low.children[0] as typeof low, low.handle)).toBe(true);
    expect(isReached(low, high.handle)).toBe(false);
  });

  test("of_copies_of_themselves_end", () => {
    const round = use("round", curve("c", []), [1, 0, 0, 1, 0, 0]);
    (round as { target: unknown }).target = round;
    expect(placesIn(new FakeDrawing([round]))).toEqual([]);
  });
});

describe("marks", () => {
  const mark = (kind: Mark["kind"], at: Point, isChosen = false) =>
    ({
      kind,
      at,
      foot: at,
      handle: 1,
      part: { kind: "whole" },
      isChosen,
      label: kind,
    }) as unknown as Mark;

  test("the_nearest_is_meant_where_they_are_apart", () => {
    const marks = [mark("stop", [0, 0]), mark("node", [11, 0])];
    expect(markAt(marks, [10, 0], 12)?.kind).toBe("node");
    expect(markAt(marks, [1, 0], 12)?.kind).toBe("stop");
  });

  test("where_they_are_alike_the_chosen_one_wins_then_stop_node_handle", () => {
    const at: Point = [5, 5];
    const all = [mark("handle", at), mark("node", at), mark("stop", at)];
    expect(markAt(all, [6, 5], 12)?.kind).toBe("stop");
    expect(markAt(all.slice(0, 2), [6, 5], 12)?.kind).toBe("node");
    expect(markAt([...all, mark("handle", [8, 5], true)], [6, 5], 12)?.isChosen).toBe(true);
  });

  test("none_is_hit_farther_than_the_reach", () => {
    expect(markAt([mark("node", [0, 0])], [12.1, 0], 12)).toBeNull();
    expect(markAt([mark("node", [0, 0])], [12, 0], 12)?.kind).toBe("node");
    expect(markAt([], [0, 0], 12)).toBeNull();
  });
});

test("an_empty_place_means_the_topmost_layer_around_it", () => {
  const ring = (name: string, size: number) =>
    layer(name, [curve(name, [line([0, 0], [size, size])])]);
  const drawing = new FakeDrawing([ring("large", 200), ring("small", 100)]);
  const places = placesIn(drawing);
  expect(layerAt(places, [50, 50])?.name).toBe("small");
  expect(layerAt(places, [150, 20])?.name).toBe("large");
  expect(layerAt(places, [250, 20])).toBeNull();
});

test("a_rectangle_touches_what_crosses_it_and_nothing_else", () => {
  const next = randomFrom(17);
  const curves = Array.from({ length: 80 }, (_, k) =>
    curve(`c${k}`, [line([next() * 800, next() * 600], [next() * 800, next() * 600])]),
  );
  const grid = gridOf(placesIn(new FakeDrawing(curves)), [1, 0, 0, 1, 0, 0]);
  const points = curves.map(({ paths }) => pointsOf(paths[0], [1, 0, 0, 1, 0, 0], 1000));
  for (let k = 0; k < 40; k += 1) {
    const low: Point = [next() * 600, next() * 400];
    const high: Point = [low[0] + next() * 200, low[1] + next() * 200];
    const isIn =
      (slack: number) =>
      ([x, y]: Point) =>
        x >= low[0] - slack && y >= low[1] - slack && x <= high[0] + slack && y <= high[1] + slack;
    const names = new Set([...grid.within(low, high)].map(({ item }) => item.name));
    curves.forEach(({ name }, i) => {
      if (points[i].some(isIn(0))) expect(names.has(name)).toBe(true);
      // A corner may lie between two of the points.
      else if (names.has(name)) expect(points[i].some(isIn(1))).toBe(true);
    });
  }
});
