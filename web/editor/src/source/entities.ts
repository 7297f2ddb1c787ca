// Text between quotes, and its meaning.

const NAMED: Readonly<Record<string, string>> = {
  lt: "<",
  gt: ">",
  amp: "&",
  quot: '"',
  apos: "'",
};

function referred(whole: string, name: string): string {
  if (!name.startsWith("#")) return Object.hasOwn(NAMED, name) ? NAMED[name] : whole;
  const code = name[1] === "x" ? parseInt(name.slice(2), 16) : parseInt(name.slice(1), 10);
  const isScalar = code > 0 && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
  return isScalar ? String.fromCodePoint(code) : whole;
}

/** The text of an element: entities and line ends decoded. Unknown entities stay as they are. */
export function decodeText(raw: string): string {
  const lines = raw.includes("\r") ? raw.replace(/\r\n?/g, "\n") : raw;
  if (!lines.includes("&")) return lines;
  return lines.replace(/&(#x[0-9a-fA-F]{1,8}|#[0-9]{1,8}|[A-Za-z]+);/g, referred);
}

/** Returns the value of an attribute; line ends and tabs become blanks, as XML requires. */
export function decodeValue(raw: string): string {
  return decodeText(/[\t\r\n]/.test(raw) ? raw.replace(/\r\n|[\t\r\n]/g, " ") : raw);
}

const ESCAPES: Readonly<Record<string, string>> = {
  "&": "&amp;",
  "<": "&lt;",
  '"': "&quot;",
  "'": "&apos;",
  "\t": "&#9;",
  "\n": "&#10;",
  "\r": "&#13;",
};

/** As it may stand between these quotes, so that it reads back the same. */
export function encodeValue(value: string, quote: '"' | "'"): string {
  const pattern = quote === '"' ? /[&<"\t\n\r]/g : /[&<'\t\n\r]/g;
  return value.replace(pattern, (character) => ESCAPES[character]);
}
