// Numbers as a person reads them.
import type { Rgb } from "../geometry/color.js";

const number = new Intl.NumberFormat("en-GB", { maximumFractionDigits: 1, useGrouping: false });

export function shown(value: number): string {
  return number.format(Math.abs(value) < 0.05 ? 0 : value);
}

export function percent(share: number): string {
  return number.format(Math.round(share * 1000) / 10);
}

export function hexOf({ r, g, b }: Rgb): string {
  const byte = (share: number) => Math.round(Math.min(1, Math.max(0, share)) * 255);
  return `#${[r, g, b].map((share) => byte(share).toString(16).padStart(2, "0")).join("")}`;
}
