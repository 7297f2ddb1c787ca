// Sums in fields: "30*2", "(4+1)/2", "-3.5", "1/3". Its own small reader; nothing is evaluated as
// code.

const ops: Readonly<Record<string, (a: number, b: number) => number>> = {
  "+": (a, b) => a + b,
  "-": (a, b) => a - b,
  "*": (a, b) => a * b,
  "/": (a, b) => a / b,
};

/** Deeper nesting than this is no plausible sum. */
const DEPTH = 32;

class Reader {
  private at = 0;
  constructor(private readonly tokens: readonly string[]) {}

  private get next() {
    return this.tokens[this.at];
  }

  sum(depth: number): number {
    let value = this.product(depth);
    while (this.next === "+" || this.next === "-")
      value = ops[this.tokens[this.at++]](value, this.product(depth));
    return value;
  }

  private product(depth: number): number {
    let value = this.factor(depth);
    while (this.next === "*" || this.next === "/")
      value = ops[this.tokens[this.at++]](value, this.factor(depth));
    return value;
  }

  private factor(depth: number): number {
    if (depth > DEPTH) return NaN;
    const token = this.tokens[this.at++];
    if (token === "-") return -this.factor(depth + 1);
    if (token === "+") return this.factor(depth + 1);
    if (token !== "(") return token === undefined ? NaN : Number(token);
    const value = this.sum(depth + 1);
    return this.tokens[this.at++] === ")" ? value : NaN;
  }

  get isDone() {
    return this.at === this.tokens.length;
  }
}

/**
 * The value of a sum, or null where it is none or not finite. A comma is taken for a decimal point.
 */
export function evaluate(text: string): number | null {
  const plain = text
    .replaceAll(",", ".")
    .replaceAll("×", "*")
    .replaceAll("−", "-")
    .replaceAll("÷", "/");
  const tokens = plain.match(/\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?|[-+*/()]/gi) ?? [];
  if (tokens.length === 0 || tokens.join("") !== plain.replace(/\s+/g, "")) return null;
  const reader = new Reader(tokens);
  const value = reader.sum(0);
  return reader.isDone && Number.isFinite(value) ? value : null;
}
