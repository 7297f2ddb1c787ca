// Random documents whose styles use all CSS of docs/format.md. The engine can read each of them.
import { pick } from "../corpus.js";

type Random = () => number;
type Make = (random: Random) => string;

const maybe = (random: Random, chance: number, make: Make) =>
  random() < chance ? make(random) : "";

function times(random: Random, most: number, make: Make): string[] {
  return Array.from({ length: 1 + Math.floor(random() * most) }, () => make(random));
}

const oneOf =
  (...values: readonly (string | Make)[]): Make =>
  (random) => {
    const value = pick(values, random);
    return typeof value === "string" ? value : value(random);
  };

const VARIABLES = ["--c", "--d", "--e", "--E", "--wört"];

const color: Make = oneOf(
  "red",
  "#123456",
  "rgb(10 20 30)",
  "currentColor",
  "LIME",
  "bl\\75 e",
  "hsl(120 50% 25%)",
  "/**/gold",
);

function variable(random: Random, value: Make): string {
  const name = pick(VARIABLES, random);
  const fallback = oneOf(
    value,
    "",
    "nothing of the kind",
    (r) => variable(r, value),
    (r) => `${variable(r, value)} `,
  );
  return oneOf(
    `var(${name})`,
    `VAR( ${name} )`,
    (r) => `var(${name},${fallback(r)})`,
    (r) => `var(${name} , ${fallback(r)})`,
    `v\\61r(/**/${name}`,
  )(random);
}

const withVariable = (value: Make): Make =>
  oneOf(value, value, (random) => variable(random, value));

const display = withVariable(oneOf("none", "inline", "block flow", "NONE", "banana"));
const visibility = withVariable(oneOf("hidden", "visible", "collapse"));
const share = withVariable(oneOf("0.25", "50%", ".75", "1", "2"));
const blend = withVariable(oneOf("multiply", "screen", "normal", "color-dodge"));
const tint = withVariable(color);
const wide = oneOf("inherit", "initial", "unset", "revert", "revert-layer", "INHERIT");

/** Custom properties: values of any kind, other properties, and cycles of them. */
const anything = oneOf(
  color,
  "none",
  "hidden",
  ".5",
  "multiply",
  wide,
  "",
  "{a:b}",
  "rgb(1 2",
  (r) => variable(r, oneOf(color, "none", "inherit")),
);

function declaration(random: Random): string {
  const valued =
    (property: string, value: Make): Make =>
    (r) =>
      `${property}${oneOf(":", " : ", ":/**/")(r)}${random() < 0.15 ? wide(r) : value(r)}`;
  const plain = oneOf(
    valued("display", display),
    valued("visibility", visibility),
    valued("opacity", share),
    valued("mix-blend-mode", blend),
    valued("stop-color", tint),
    valued("stop-color", tint),
    valued("STOP-OPACITY", share),
    valued("color", tint),
    valued("fill", oneOf(tint, "url(#g) red", "url(#g", "none")),
    (r) => `${pick(VARIABLES, r)}:${anything(r)}`,
    (r) => `${pick(VARIABLES, r)}:${anything(r)}`,
    (r) => `${pick(VARIABLES, r)}:${anything(r)}`,
  )(random);
  return plain + maybe(random, 0.15, oneOf("!important", " ! IMPORTANT "));
}

/** A declaration, or text that CSS drops, with its continuation. */
const said = oneOf(
  ...Array.from({ length: 12 }, () => declaration),
  "all:unset",
  "all : revert-layer",
  "stop-color:red blue",
  "color:red!",
  "fill:url(a b)",
  "stop-color",
  ":red",
  "g{display:none}",
  "display:none}",
  "stop-color:'a\nb'",
);

const block = (random: Random) => times(random, 3, said).join(oneOf(";", " ; ", ";;")(random));

const NAMES = [
  "svg",
  "g",
  "g",
  "g",
  "polyline",
  "stop",
  "stop",
  "linearGradient",
  "*",
  "*",
  "defs",
];
const ATTRIBUTES = ["data-k", "data-k", "class", "id", "opacity", "sf\\:left", "points", "offset"];
const KEYS = ["x", "x-y", "xx y", "", "Xy", "y"];

function attribute(random: Random): string {
  const name = pick(ATTRIBUTES, random);
  const value = oneOf("x", "y", '"xx"', "'x-y'", "a", "e1", '""', "X");
  const flag = oneOf("", "", " i", " s", "I");
  return oneOf(
    `[${name}]`,
    `[ ${name} ]`,
    (r) => `[${name}${pick(["=", "~=", "|=", "^=", "$=", "*=", " = "], r)}${value(r)}${flag(r)}]`,
  )(random);
}

const simple = oneOf(
  ".a",
  ".b",
  ".c",
  ".\\61",
  "#e1",
  "#e2",
  "#e3",
  attribute,
  attribute,
  ":first-child",
  ":FIRST-child",
  ":last-child",
  ":only-child",
  ":root",
  ":hover",
);

const negated: Make = (random) => `:not(${oneOf("g", "*", " .a ", simple)(random)})`;
const unread = oneOf("::before", ":nth-child(2)", ":is(g, stop)", ":not(.a .b)", "&", "svg|g");
const wrong = oneOf("!", ".", "..a", "#1", "g,,", "> g", "[", ":", "1");

function compound(random: Random): string {
  const name = pick(NAMES, random);
  const conditions = oneOf(simple, simple, simple, negated);
  if (random() < 0.02) return unread(random);
  if (random() < 0.01) return wrong(random);
  if (random() < 0.4) return name;
  return (
    (random() < 0.5 ? name : "") + times(random, 2, conditions).join(oneOf("", "/**/")(random))
  );
}

function selector(random: Random): string {
  const combinator = oneOf(" ", " ", ">", " > ", "+", " + ", "~", "\n~ ", "/**/ /**/");
  const [first, ...more] = times(random, pick([1, 2, 2, 4], random), compound);
  return first + more.map((one) => combinator(random) + one).join("");
}

function rule(random: Random): string {
  return `${times(random, 3, selector).join(oneOf(",", " , ")(random))}{${block(random)}}`;
}

const MEDIA = [
  "screen",
  "print",
  "not print",
  "not print and (color)",
  "screen and (color)",
  "only all",
  "a,screen",
];

function sheet(random: Random): string {
  return times(random, 8, (r) => {
    if (r() < 0.1) return `@media ${pick(MEDIA, r)}{${times(r, 2, rule).join("")}}`;
    return r() < 0.05 ? oneOf("@import 'x';", "@font-face{src:url(x)}", "<!-- ")(r) : rule(r);
  }).join(oneOf("", "\n")(random));
}

const escaped = (text: string) =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");

/** Returns ids, classes, other attributes and styles of an element. */
function marks(
  random: Random,
  own: readonly (readonly [string, Make])[],
  mayHaveStyle = true,
): string {
  return [
    maybe(random, 0.3, (r) => ` class="${pick(["a", "b", "c", "a b", " b  c ", "d"], r)}"`),
    maybe(random, 0.3, (r) => ` id="${pick(["e1", "e2", "e3"], r)}"`),
    maybe(random, 0.3, (r) => ` data-k="${pick(KEYS, r)}"`),
    maybe(
      random,
      mayHaveStyle ? 0.25 : 0,
      (r) => ` style="${escaped(times(r, 2, said).join(";"))}"`,
    ),
    ...own.map(([name, value]) => maybe(random, 0.2, (r) => ` ${name}="${escaped(value(r))}"`)),
  ].join("");
}

/** Allowed values of an attribute; a wrong one is an error, except as the result of var(). */
const SHOWN = [
  ["display", withVariable(oneOf("none", "inline"))],
  ["visibility", visibility],
] as const;

const STRANGER = "<x:y/>";

function stop(random: Random): string {
  const offset = pick(["0", ".25", "50%", "1"], random);
  const own = [
    ["stop-color", tint],
    ["stop-opacity", share],
    ["color", withVariable(oneOf("red", "teal"))],
  ] as const;
  return `<stop offset="${offset}"${marks(random, own)}/>${maybe(random, 0.1, () => STRANGER)}`;
}

/** Returns a document of curves that each show a gradient. */
export function styledDocument(random: Random): string {
  const gradients: string[] = [];
  const curve: Make = (r) => {
    const id = `g${gradients.length}`;
    const stops = times(r, 3, stop).join("");
    gradients.push(
      `<linearGradient id="${id}" gradientUnits="userSpaceOnUse" x2="90">${stops}</linearGradient>`,
    );
    // Its geometry is not a CSS property, which "all" would reset.
    return `<polyline points="0 ${gradients.length} 90 9" sf:left="url(#${id})"${marks(r, SHOWN)}/>`;
  };
  const group =
    (depth: number): Make =>
    (r) =>
      depth < 3 && r() < 0.3
        ? `<g${marks(r, SHOWN)}>${times(r, 3, group(depth + 1)).join("")}</g>`
        : curve(r) + maybe(r, 0.1, () => STRANGER) + maybe(r, 0.1, () => "<title>t</title>");
  const composed = [
    ["opacity", share],
    ["mix-blend-mode", oneOf("screen", "multiply")],
  ] as const;
  const layers = times(random, 3, (r) => {
    const content = times(r, 4, group(0)).join("\n  ");
    return `<g sf:diffuse="true"${marks(r, [...SHOWN, ...composed])}>\n  ${content}\n</g>`;
  });
  const sheets = [
    `<style>${escaped(sheet(random))}</style>`,
    maybe(random, 0.2, (r) => `<style media="${pick(MEDIA, r)}">${escaped(sheet(r))}</style>`),
  ].join("\n");
  // Without its size, which "all" would reset, it would not be a background.
  const background = maybe(
    random,
    sheets.includes("all") ? 0 : 0.5,
    (r) => `<rect width="100%" height="100%"${marks(r, [["fill", oneOf("red", "teal")]], false)}/>`,
  );
  return `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" xmlns:x="urn:x" viewBox="0 0 90 90" sf:version="1"${marks(random, [])}>
${sheets}
<defs>${gradients.join("\n")}</defs>
${background}
${layers.join("\n")}
</svg>
`;
}
