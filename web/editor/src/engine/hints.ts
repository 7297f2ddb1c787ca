// Lint's report, by places of the text in the place of numbers of layers and curves.
import type { LintReport } from "./session.js";
import type { EngineCurve, Hint } from "./types.js";

function numberOf(value: unknown): number | null {
  return typeof value === "number" ? value : null;
}

export function hintsOf({ hints }: LintReport, curves: readonly EngineCurve[]): Hint[] {
  return hints.map((hint) => {
    const layer = numberOf(hint.layer);
    const curve = numberOf(hint.curve);
    const found = curves.find((known) => known.layer === layer && known.curve === curve);
    return {
      severity: hint.severity === "note" ? "note" : "warning",
      rule: String(hint.kind),
      message: String(hint.message),
      layer,
      curve,
      side: hint.side === "left" || hint.side === "right" ? hint.side : null,
      offset: found?.offset ?? null,
      subpath: found?.subpath ?? null,
      stackItem: numberOf(hint.stack_item),
      at: Array.isArray(hint.at) ? [Number(hint.at[0]), Number(hint.at[1])] : null,
    };
  });
}
