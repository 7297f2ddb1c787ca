// Numbers as people read them here.

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

export const date = (time: number) =>
  new Intl.DateTimeFormat(undefined, { dateStyle: "medium", timeStyle: "short" }).format(time);
