// Colours as hexadecimal text.
import type { Rgb } from "./color.js";

const byteOf = (channel: number) => Math.round(Math.min(Math.max(channel, 0), 1) * 255);

/** "#rrggbb", each channel rounded to a byte. */
export function hexOf({ r, g, b }: Rgb): string {
  return "#" + [r, g, b].map((channel) => byteOf(channel).toString(16).padStart(2, "0")).join("");
}

/** Returns the colour of "#rrggbb"; null for other texts. */
export function rgbFromHex(text: string): Rgb | null {
  if (!/^#[0-9a-f]{6}$/i.test(text)) return null;
  const channel = (at: number) => parseInt(text.slice(at, at + 2), 16) / 255;
  return { r: channel(1), g: channel(3), b: channel(5) };
}
