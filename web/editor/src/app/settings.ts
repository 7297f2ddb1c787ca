// The user's preferences, which this browser stores.
import { effect, signal, type Signal } from "@preact/signals";
import type { Rgb } from "../geometry/color.js";
import type { Settings, Surround, Theme } from "./types.js";

/** Sides of polygons. */
export const FEWEST_SIDES = 3;
export const MOST_SIDES = 12;

const KEY = "sfumato-editor";

function stored(): Record<string, unknown> {
  try {
    const value: unknown = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    return typeof value === "object" && value !== null ? (value as Record<string, unknown>) : {};
  } catch {
    // Refused, or damaged: everything is as it was the first time.
    return {};
  }
}

const oneOf =
  <Value extends string>(...values: Value[]) =>
  (value: unknown): value is Value =>
    values.includes(value as Value);
const isBoolean = (value: unknown): value is boolean => typeof value === "boolean";
const between =
  (least: number, most: number) =>
  (value: unknown): value is number =>
    typeof value === "number" && value >= least && value <= most;

const isPolygon = (value: unknown): value is number =>
  between(FEWEST_SIDES, MOST_SIDES)(value) && Number.isInteger(value);

function isColors(value: unknown): value is readonly Rgb[] {
  const isShare = between(0, 1);
  return (
    Array.isArray(value) &&
    value.length <= 8 &&
    value.every((color: Rgb) => isShare(color?.r) && isShare(color.g) && isShare(color.b))
  );
}

/** At first the grey around the artboard is as dark as the page. */
function prefersDark(): boolean {
  return globalThis.matchMedia?.("(prefers-color-scheme: dark)").matches ?? false;
}

/** Settings as they were left; changes are kept where the browser lets them. */
export function openSettings(): Settings {
  const before = stored();
  const all: Record<string, Signal<unknown>> = {};
  function setting<Value>(
    name: string,
    initial: Value,
    fits: (value: unknown) => value is Value,
  ): Signal<Value> {
    const value = before[name];
    const made = signal(fits(value) ? value : initial);
    all[name] = made as Signal<unknown>;
    return made;
  }
  const settings: Settings = {
    theme: setting<Theme>("theme", "system", oneOf("system", "light", "dark")),
    surround: setting<Surround>("surround", prefersDark() ? "dark" : "light", oneOf("dark", "mid", "light")),
    smoothing: setting("smoothing", 2, between(0.5, 8)),
    exactPixels: setting("exactPixels", "auto", oneOf("auto", "on", "off")),
    snap: setting("snap", true, isBoolean),
    ownColor: setting("ownColor", false, isBoolean),
    alignToArtboard: setting("alignToArtboard", false, isBoolean),
    grid: setting("grid", false, isBoolean),
    gridUnit: setting("gridUnit", 0, between(0, 1e6)),
    rulers: setting("rulers", false, isBoolean),
    colorModel: setting("colorModel", "oklch", oneOf("oklch", "hsv", "rgb")),
    recent: setting<readonly Rgb[]>("recent", [], isColors),
    panelWidth: setting("panelWidth", 288, between(240, 480)),
    sampleDistance: setting("sampleDistance", 3, between(1, 12)),
    sampleTolerance: setting("sampleTolerance", 0.02, between(0.002, 0.2)),
    sampleBlur: setting("sampleBlur", true, isBoolean),
    strokeRadius: setting("strokeRadius", 12, between(0.01, 1e6)),
    polygonSides: setting("polygonSides", 6, isPolygon),
    tourDone: setting("tourDone", false, isBoolean),
  };
  effect(() => {
    const values = Object.fromEntries(Object.entries(all).map(([name, of]) => [name, of.value]));
    try {
      localStorage.setItem(KEY, JSON.stringify(values));
    } catch {
      // Nothing is lost but the settings of next time.
    }
  });
  return settings;
}
