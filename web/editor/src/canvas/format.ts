// Numbers as a person reads them.
const number = new Intl.NumberFormat("en-GB", { maximumFractionDigits: 1, useGrouping: false });

export function shown(value: number): string {
  return number.format(Math.abs(value) < 0.05 ? 0 : value);
}

export function percent(share: number): string {
  return number.format(Math.round(share * 1000) / 10);
}
