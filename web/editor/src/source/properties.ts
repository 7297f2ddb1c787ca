// Properties of CSS that the editor reads, and the values that they have.
import table from "../../../../src/formats/css/properties.json";
import { parseColor } from "./colors.js";
import { keywordOf, shareOf, solid, tokensOf, urlAmong } from "./css.js";
import type { Token } from "./css.js";
import { variablesIn } from "./variables.js";
import type { VariableName } from "./variables.js";

/** A row of the table. Without `editor`, only the engine reads the property. */
interface Row {
  readonly value: string;
  readonly words?: string;
  readonly most_words?: number;
  readonly inherited?: boolean;
  readonly editor?: boolean;
}

type Table = typeof table;
export type Property = {
  [Name in keyof Table]: Table[Name] extends { editor: boolean } ? Name : never;
}[keyof Table];

/** With custom properties. */
export type PropertyName = Property | VariableName;

const ROWS = Object.entries<Row>(table).filter(([, row]) => row.editor) as [Property, Row][];
const ROW_OF: ReadonlyMap<string, Row> = new Map(ROWS);
const wordsOf = (row: Row) => row.words?.split(" ") ?? [];

export const PROPERTIES = ROWS.map(([name]) => name);
export const INHERITED = new Set(PROPERTIES.filter((name) => ROW_OF.get(name)?.inherited));
export const BLEND_MODES = wordsOf(table["mix-blend-mode"]);

const isShare = (text: string) => shareOf(text) !== null;
const isColor = (text: string) => keywordOf(text) === "currentcolor" || parseColor(text) !== null;
const PAINT_WORDS = ["none", "context-fill", "context-stroke"];

/** A paint, perhaps behind url(…): what to paint where that leads nowhere. */
function isPaint(text: string): boolean {
  const tokens = solid(tokensOf(text));
  let at = 0;
  for (let url = urlAmong(tokens, at); url; url = urlAmong(tokens, at)) at = url.behind;
  if (at > 0 && at === tokens.length) return true;
  const rest = at === 0 ? text : text.slice(tokens[at].start);
  return isColor(rest) || PAINT_WORDS.includes(keywordOf(rest) ?? "");
}

function isWords(text: string, row: Row): boolean {
  const [words, known] = [solid(tokensOf(text)), wordsOf(row)];
  const isKnown = ({ kind, value }: Token) => kind === "ident" && known.includes(value.toLowerCase());
  return words.length > 0 && words.length <= (row.most_words ?? 1) && words.every(isKnown);
}

/** Whether a text without var() is a value of a property, by the kind of its values. */
const IS_VALUE: Readonly<Record<string, (text: string, row: Row) => boolean>> = {
  color: isColor,
  paint: isPaint,
  share: isShare,
  words: isWords,
};

export function isProperty(name: string): name is Property {
  return ROW_OF.has(name);
}

/** Words that any property takes. */
const WIDE = ["inherit", "initial", "unset", "revert", "revert-layer"] as const;
export type Wide = (typeof WIDE)[number];

/** Returns the CSS-wide keyword that a value is, or null. */
export function wideOf(text: string): Wide | null {
  const word = keywordOf(text);
  return WIDE.find((one) => one === word) ?? null;
}

/** Whether CSS keeps a declaration of a property with this value. */
export function isValue(property: Property, text: string): boolean {
  if (wideOf(text) !== null) return true;
  const variables = variablesIn(text);
  if (variables !== "none") return variables === "valid";
  const row = ROW_OF.get(property);
  return row !== undefined && IS_VALUE[row.value](text, row);
}
