import { signal } from "@preact/signals";
import { describe, expect, test } from "vitest";
import { mapped, type Box, type Point } from "../../../../web/editor/src/geometry/affine.js";
import {
  artboardFromStage,
  stageFromArtboard,
  turnWheel,
} from "../../../../web/editor/src/app/view.js";
import { navigationOf } from "../support/editor.js";
import { randomFrom } from "../random.js";

const ARTBOARD: Box = [0, 0, 640, 480];

function ownerOf(artboard: Box = ARTBOARD, width = 800, height = 600) {
  return {
    view: signal({ x: 320, y: 240, zoom: 1 }),
    stage: signal({ width, height }),
    drawing: { artboard },
  };
}

const artboardAt = (owner: ReturnType<typeof ownerOf>, at: Point) =>
  mapped(
    artboardFromStage(owner.view.value, owner.stage.value.width, owner.stage.value.height),
    at,
  );

test("the_maps_of_stage_and_artboard_undo_each_other", () => {
  const next = randomFrom(1);
  for (let k = 0; k < 200; k += 1) {
    const view = { x: next() * 1e4, y: next() * 1e4, zoom: 10 ** (next() * 6 - 3) };
    const at: Point = [next() * 2000, next() * 1000];
    const back = mapped(
      stageFromArtboard(view, 900, 700),
      mapped(artboardFromStage(view, 900, 700), at),
    );
    expect(back[0]).toBeCloseTo(at[0], 5);
    expect(back[1]).toBeCloseTo(at[1], 5);
  }
});

test("zooming_leaves_what_is_under_the_pointer_in_its_place", () => {
  const owner = ownerOf();
  const navigation = navigationOf(owner);
  const at: Point = [250, 130];
  const before = artboardAt(owner, at);
  for (const factor of [1.5, 1.5, 0.4, 3]) navigation.zoomBy(factor, at);
  const after = artboardAt(owner, at);
  expect(owner.view.value.zoom).toBeCloseTo(1.5 * 1.5 * 0.4 * 3, 9);
  expect(after[0]).toBeCloseTo(before[0], 9);
  expect(after[1]).toBeCloseTo(before[1], 9);
});

test("moving_by_pixels_moves_the_picture_by_as_many", () => {
  const owner = ownerOf();
  owner.view.value = { x: 320, y: 240, zoom: 2 };
  const before = artboardAt(owner, [400, 300]);
  navigationOf(owner).moveBy(30, -20);
  const after = artboardAt(owner, [430, 280]);
  expect(after).toEqual(before);
});

describe("fit", () => {
  test("shows_all_of_the_artboard_in_the_middle", () => {
    const owner = ownerOf();
    owner.view.value = { x: 10, y: 470, zoom: 40 };
    navigationOf(owner).fit();
    const [x0, y0] = mapped(stageFromArtboard(owner.view.value, 800, 600), [0, 0]);
    const [x1, y1] = mapped(stageFromArtboard(owner.view.value, 800, 600), [640, 480]);
    expect(Math.min(x0, y0)).toBeGreaterThanOrEqual(24 - 1e-9);
    expect(x1).toBeLessThanOrEqual(776 + 1e-9);
    expect(y1).toBeLessThanOrEqual(576 + 1e-9);
    expect(x0 + x1).toBeCloseTo(800, 9);
  });

  test("shows_a_point_without_leaving_the_numbers", () => {
    const owner = ownerOf();
    navigationOf(owner).fit([100, 100, 100, 100]);
    const { x, y, zoom } = owner.view.value;
    expect([x, y].every(Number.isFinite)).toBe(true);
    expect(zoom).toBeGreaterThan(1);
    expect(Number.isFinite(zoom)).toBe(true);
  });
});

test("whatever_is_asked_for_a_tenth_of_the_stage_shows_the_artboard", () => {
  const next = randomFrom(2);
  for (let k = 0; k < 300; k += 1) {
    const owner = ownerOf();
    const navigation = navigationOf(owner);
    for (let step = 0; step < 8; step += 1) {
      navigation.moveBy((next() - 0.5) * 4000, (next() - 0.5) * 4000);
      navigation.zoomBy(10 ** (next() * 6 - 3), [next() * 800, next() * 600]);
    }
    const map = stageFromArtboard(owner.view.value, 800, 600);
    const [[x0, y0], [x1, y1]] = [mapped(map, [0, 0]), mapped(map, [640, 480])];
    expect(x0).toBeLessThanOrEqual(720 + 1e-6);
    expect(x1).toBeGreaterThanOrEqual(80 - 1e-6);
    expect(y0).toBeLessThanOrEqual(540 + 1e-6);
    expect(y1).toBeGreaterThanOrEqual(60 - 1e-6);
    expect(owner.view.value.zoom).toBeGreaterThan(0);
  }
});

test("a_zoom_that_is_no_number_changes_nothing", () => {
  const owner = ownerOf();
  const before = owner.view.value;
  navigationOf(owner).zoomBy(NaN, [10, 10]);
  expect(owner.view.value.zoom).toBe(before.zoom);
});

describe("the wheel", () => {
  const event = { deltaX: 0, deltaY: 0, deltaMode: 0, ctrlKey: false, shiftKey: false };

  test("away_from_the_hand_zooms_in_and_back_again", () => {
    const owner = ownerOf();
    const navigation = navigationOf(owner);
    turnWheel(navigation, { ...event, deltaY: -120 }, [100, 100]);
    expect(owner.view.value.zoom).toBeGreaterThan(1);
    turnWheel(navigation, { ...event, deltaY: 120 }, [100, 100]);
    expect(owner.view.value.zoom).toBeCloseTo(1, 9);
  });

  test("of_lines_and_pages_counts_as_pixels", () => {
    const zoomOf = (delta: number, mode: number) => {
      const owner = ownerOf();
      turnWheel(navigationOf(owner), { ...event, deltaY: delta, deltaMode: mode }, [0, 0]);
      return owner.view.value.zoom;
    };
    expect(zoomOf(3, 1)).toBeCloseTo(zoomOf(54, 0), 12);
  });

  test("with_shift_moves_sideways", () => {
    const owner = ownerOf();
    const before = artboardAt(owner, [400, 300]);
    turnWheel(navigationOf(owner), { ...event, deltaY: 50, shiftKey: true }, [0, 0]);
    expect(owner.view.value.zoom).toBe(1);
    expect(artboardAt(owner, [350, 300])).toEqual(before);
  });
});
