// Random documents with all notations of the format. The engine can read each of them.
import { pick } from "./corpus.js";

type Random = () => number;

function maybe(random: Random, chance: number, text: () => string): string {
  return random() < chance ? text() : "";
}

function times(random: Random, most: number, text: () => string): string[] {
  return Array.from({ length: 1 + Math.floor(random() * most) }, text);
}

function number(random: Random, from = -90, to = 90): string {
  const value = from + random() * (to - from);
  return pick([value.toFixed(2), value.toFixed(0), String(value), value.toExponential(3)], random);
}

const COLORS = [
  "red",
  "CornflowerBlue",
  "#c21",
  "#C2115F",
  "rgb(1, 2, 3)",
  "rgb(10% 20% 30%)",
  "rgb(1 2 3 / 1)",
  "oklch(0.7 0.15 250)",
  "lab(50% 40 -60)",
  "color(display-p3 0 1 0)",
  "rgba(10, 20, 30, 1)",
  "hsl(120, 50%, 25%)",
  "hsl(-40deg 50 25)",
  "hsl(.5turn none 25%)",
  "hsl(200grad 90% 60%)",
  "hwb(90 20% 30%)",
  "hwb(2rad 80% 70%)",
  "rgb( 12.5%, 50% , 7.25% )",
  "r\\65 d",
  "/* two */ blue",
  "rgb(1/**/2 3)",
  "#f00f",
  "RGB(300 -5 .5)",
];
const RADII = ["0", "4", "2.5px", ".5mm", "1pt", "1e1", "0.1in", "1pc", ".2cm"];
const OPACITIES = ["0", "1", ".5", "0.25", "1e-1", "+.75"];

function offset(random: Random): string {
  const percent = `${(random() * 100).toFixed(Math.floor(random() * 3))}%`;
  return pick(["", "", ` ${percent}`, ` @${(random() * 4).toFixed(1)}`, `/**/${percent}`], random);
}

function list(random: Random, values: readonly string[]): string {
  const stops = times(random, 4, () => pick(values, random) + offset(random));
  return stops.join(pick([",", ", ", " , "], random));
}

function sides(random: Random): string {
  const side = (name: string, values: readonly string[]) =>
    maybe(random, 0.5, () => ` sf:${name}="${random() < 0.1 ? "none" : list(random, values)}"`);
  const radii = (name: string) => maybe(random, 0.4, () => ` sf:${name}="${list(random, RADII)}"`);
  return [
    side("left", COLORS),
    side("right", COLORS),
    side("opacity", OPACITIES),
    side("left-opacity", OPACITIES),
    radii("blur"),
    radii("right-blur"),
  ].join("");
}

function transform(random: Random): string {
  const one = () =>
    pick(
      [
        () => `translate(${number(random)})`,
        () => `translate(${number(random)}, ${number(random)})`,
        () => `scale(${number(random, 0.2, 2)})`,
        () => `scale(-1 ${number(random, 0.2, 2)})`,
        () => `rotate(${number(random)})`,
        () => `rotate(90 ${number(random)},${number(random)})`,
        () => `skewX(${number(random, -40, 40)})`,
        () => `skewY( ${number(random, -40, 40)} )`,
        () => `matrix(1 .5 -.25 1 ${number(random)} 4)`,
      ],
      random,
    )();
  return maybe(
    random,
    0.5,
    () => ` transform="${times(random, 3, one).join(pick([" ", ",", ""], random))}"`,
  );
}

function pathData(random: Random): string {
  const n = () => number(random);
  const command = () =>
    pick(
      [
        () => `L${n()} ${n()}`,
        () => `l${n()},${n()}`,
        () => `h${n()}`,
        () => `V${n()}`,
        () => `C${n()} ${n()} ${n()} ${n()} ${n()} ${n()}`,
        () => `s${n()} ${n()} ${n()} ${n()}`,
        () => `Q${n()} ${n()} ${n()} ${n()}`,
        () => `t${n()} ${n()}`,
        () => `A${number(random, 5, 50)} 20 ${n()} 0 1 ${n()} ${n()}`,
        () => `a30 30 0 10${n()} ${n()}`,
      ],
      random,
    )();
  const subpath = () =>
    `M${n()} ${n()}${times(random, 4, command).join("")}${maybe(random, 0.3, () => "Z")}`;
  return times(random, 2, subpath).join(" ");
}

function shape(random: Random): string {
  const n = () => number(random);
  const side = () => number(random, 1, 90);
  return pick(
    [
      () => `<path d="${pathData(random)}"`,
      () => `<line x1="${n()}" y1="${n()}" x2="1cm" y2="50%"`,
      () => `<polyline points="${n()},${n()} ${n()} ${n()} ${n()} ${n()}"`,
      () => `<polygon points="0 0 ${n()} ${n()} ${n()} 7"`,
      () => `<circle cx="${n()}" r="${side()}"`,
      () => `<ellipse rx="${side()}" ry="12%" cy="1in"`,
      () =>
        `<rect x="${n()}" y="1" width="${side()}" height="${side()}"${maybe(random, 0.5, () => ' rx="3"')}`,
    ],
    random,
  )();
}

function styled(random: Random): string {
  return [
    maybe(random, 0.2, () => ` class="${pick(["off", "on", "off on", "dim"], random)}"`),
    maybe(random, 0.1, () => ` display="${pick(["none", "inline"], random)}"`),
    maybe(
      random,
      0.2,
      () =>
        ` style="${pick(["display:none", "DISPLAY : inline", "display:no\\6e e", "opacity:.5;display:banana", "display:inline!important", "/*display:none*/"], random)}"`,
    ),
  ].join("");
}

const SHEETS = [
  "",
  ".off{display:none}",
  ".off { display : none } .on{display:inline}",
  "path{display:none}",
  "*{display:none} g,svg,circle{display:inline}",
  ".off{display:none!important}",
  "@media print{path{display:none}}",
  "@media screen { .off{display:none} }",
  ".off,g::before{display:none}",
  ".off,g > path{display:none}",
  "g circle + path,svg>g:first-child [class~=off]{display:none} :not(g):last-child{display:inline}",
  "[transform] + path,circle[r^='1']{display:none}",
  "svg{--shown:none} .off{display:var(--shown)} .on{--shown:inline;display:var(--shown)}",
  ".off,!{display:none}",
  "<![CDATA[.off{display:none}]]>",
  ".off{display:none;;color:red} /* .on{display:none} */",
  "rect{display:inline} *{display:none}",
  "@import 'x'; .off{display:none",
  ".off{display:non}",
];

/** Returns the content of a layer. */
function curves(random: Random, depth: number): string {
  return times(random, 4, () => {
    if (random() < 0.25 && depth < 3) {
      return `<g${transform(random)}${styled(random)}>${curves(random, depth + 1)}</g>`;
    }
    return `${shape(random)}${sides(random)} sf:weight="1"${transform(random)}${styled(random)}/>`;
  }).join("\n  ");
}

/** Returns a document that the engine can read. */
export function randomDocument(random: Random): string {
  const layer = () =>
    `<g sf:diffuse="true"${transform(random)}${styled(random)}>\n  ${curves(random, 0)}\n</g>`;
  const content = times(random, 3, () => {
    if (random() < 0.3) return `<g${transform(random)}${styled(random)}>${layer()}</g>`;
    return random() < 0.2
      ? `<svg x="5" y="1%" width="50" height="20" viewBox="0 0 10 10">${layer()}</svg>`
      : layer();
  });
  const size = pick(
    [
      "",
      ' width="200" height="150"',
      ' width="50mm"',
      ' width="300" height="150" preserveAspectRatio="none"',
      ' width="90" height="300" preserveAspectRatio="xMinYMax slice"',
    ],
    random,
  );
  return `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 200 150"${size} sf:version="1">
<style>${pick(SHEETS, random)}</style>
${content.join("\n")}
</svg>
`;
}
