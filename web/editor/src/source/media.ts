// Media queries, evaluated for screens only.
import { behindComponent, solid, tokensOf } from "./css.js";
import type { Token } from "./css.js";

/** Words that CSS does not accept as the name of a medium. */
const RESERVED = ["not", "only", "and", "or", "layer"];

/** Evaluates a query in solid tokens. A query for features does not apply. */
function applies(query: readonly Token[]): boolean {
  const word = (at: number) => (query[at]?.kind === "ident" ? query[at].value.toLowerCase() : null);
  const isNegated = word(0) === "not";
  const at = isNegated || word(0) === "only" ? 1 : 0;
  const type = word(at);
  if (type === null || RESERVED.includes(type)) return false;
  const fits = type === "screen" || type === "all";
  const isWhole = query.length === at + 1;
  return isNegated ? !fits && (isWhole || word(at + 1) === "and") : fits && isWhole;
}

/** Whether a media query, or the attribute media, applies to a screen. */
export function isForScreen(text: string): boolean {
  const tokens = solid(tokensOf(text));
  if (tokens.length === 0) return true;
  for (let from = 0; from <= tokens.length;) {
    let end = from;
    while (end < tokens.length && tokens[end].kind !== ",") end = behindComponent(tokens, end);
    if (applies(tokens.slice(from, end))) return true;
    from = end + 1;
  }
  return false;
}
