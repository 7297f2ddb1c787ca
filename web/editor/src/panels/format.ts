// Numbers and times as people read them here.
import * as en from "../strings/en.js";

/** Returns at most `digits` decimals, without trailing zeros. */
export function decimal(value: number, digits: number): string {
  const text = value.toFixed(digits);
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return short === "-0" ? "0" : short;
}

const units = ["B", "kB", "MB", "GB"];

/** "about" is for the caller to say. */
export function bytes(count: number): string {
  let size = count;
  let unit = 0;
  while (size >= 1000 && unit < units.length - 1) {
    size /= 1000;
    unit += 1;
  }
  return `${decimal(size, unit > 1 ? 1 : 0)} ${units[unit]}`;
}

const steps = [
  ["year", 365 * 86400],
  ["month", 30 * 86400],
  ["week", 7 * 86400],
  ["day", 86400],
  ["hour", 3600],
  ["minute", 60],
] as const;

/** Returns how long ago a time was, as "2 minutes ago"; "just now" within a minute. */
export function ago(time: number, now = Date.now()): string {
  const seconds = Math.max(0, (now - time) / 1000);
  const step = steps.find(([, length]) => seconds >= length);
  if (!step) return en.page.justNow;
  return new Intl.RelativeTimeFormat("en").format(-Math.floor(seconds / step[1]), step[0]);
}

export const date = (time: number) =>
  new Intl.DateTimeFormat(undefined, { dateStyle: "medium", timeStyle: "short" }).format(time);
