// The sixteen blend modes of CSS, by their groups.
import * as en from "../strings/en.js";

export const blendModes = [
  "normal",
  "darken",
  "multiply",
  "color-burn",
  "lighten",
  "screen",
  "color-dodge",
  "overlay",
  "soft-light",
  "hard-light",
  "difference",
  "exclusion",
  "hue",
  "saturation",
  "color",
  "luminosity",
] as const;

export const blendName = (mode: string): string =>
  (en.layers.blend as Readonly<Record<string, string>>)[mode] ?? mode;
