// Drawings for testing commands, and helpers.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { openDrawing } from "../../../web/editor/src/model/drawing.js";
import type { Drawing, Handle, Item, Outcome } from "../../../web/editor/src/model/types.js";
import { applied } from "../../../web/editor/src/source/patch.js";

const INDENTED = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 200 150" sf:version="1">
  <title>Hills</title>
  <rect width="200" height="150" fill="#abc"/>
  <!-- Far away. -->
  <g id="far" sf:diffuse="true">
    <path id="a" d="M-9 90 C50 60 120 110 209 80" sf:left="#dfe9f2" sf:right="#6b8f42, #8aa55a 50%, #5a7a35" sf:blur="6"/>
    <!-- the sun -->
    <circle id="b" cx="140" cy="40" r="14" sf:left="#dfe9f2" sf:right="#fc6"/>
    <g id="inner" transform="rotate(8 50 30)" stroke="#123">
      <path id="c" d="m20 30 c10 -20 30 -20 40 0 z" sf:left="#dfe9f2" sf:right="#fff" sf:blur="0, 4 50%, 0"/>

      <path id="c2" d="M30 50 h30 v9 H30 z" sf:left="#dfe9f2" sf:right="#eee"/>
    </g>
  </g>
  <g id="near" transform="translate(30 60) scale(.5)" opacity=".8">
    <g id="tree" sf:diffuse="true" transform="translate(4 2)">
      <path id="d" d="M20 20 C60 0 70 60 40 90 S-10 40 20 20 Z" sf:left-opacity="0" sf:right-opacity="1" sf:left="#353" sf:right="#374, #8c6, #374"/>
    </g>
    <path id="e" d="M10 10 Q40 30 80 12" sf:left="#fff" sf:right="#ffd" sf:radius="3, 9 50%, 3" sf:alpha=".8"/>
  </g>
  <use id="again" href="#tree" transform="translate(120 50) scale(.6)"/>
  <g id="plain">
    <g id="stone" sf:diffuse="true">
      <ellipse id="f" cx="60" cy="120" rx="30" ry="12" sf:left-opacity="0" sf:right-opacity="1" sf:left="#555" sf:right="#777"/>
    </g>
  </g>
</svg>
`;

const INKSCAPE = `<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!-- Created with Inkscape (http://www.inkscape.org/) -->

<svg
   width="200"
   height="150"
   viewBox="0 0 200 150"
   version="1.1"
   id="svg5"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns:xlink="http://www.w3.org/1999/xlink"
   xmlns="http://www.w3.org/2000/svg"
   xmlns:svg="http://www.w3.org/2000/svg"
   xmlns:d="urn:sfumato:1"
   d:version="1">
  <sodipodi:namedview
     id="namedview7"
     pagecolor="#ffffff" />
  <defs
     id="defs2">
    <linearGradient
       id="shade"
       gradientUnits="userSpaceOnUse"
       x1="0" y1="0" x2="0" y2="150">
      <stop offset="0" stop-color="#9fd4f5" />
      <stop offset="1" stop-color="#fdf3d8" />
    </linearGradient>
  </defs>
  <g
     inkscape:label="Sky"
     inkscape:groupmode="layer"
     id="layer1"
     d:diffuse="true">
    <path
       style="fill:none;stroke:#000000"
       d="m -5,70 c 40,-30 140,30 215,5"
       id="path111"
       d:left="url(#shade)"
       d:right="#385" />
    <path
       style="fill:none"
       d="M 20,100 C 40,90 60,120 90,100"
       id="path112"
       d:left="#496"
       d:right="#274"
       d:blur="5 @0, 2px @1" />
  </g>
  <g
     inkscape:label="Sun"
     inkscape:groupmode="layer"
     id="layer2"
     style="mix-blend-mode:screen;opacity:0.9"
     d:diffuse="true">
    <ellipse
       id="path113"
       cx="150"
       cy="30"
       rx="20"
       ry="18"
       d:left="#000"
       d:right="#fe8"
       d:left-opacity="0"
       d:right-opacity="1" />
  </g>
  <use
     x="0"
     y="0"
     xlink:href="#layer2"
     id="use9"
     transform="translate(-60,10)" />
</svg>
`;

const ONE_LINE =
  "<svg xmlns='http://www.w3.org/2000/svg' xmlns:sf='urn:sfumato:1' viewBox='0 0 100 100' sf:version='1'>" +
  "<g sf:diffuse='true'><path d='M0 40L100 60' sf:left='#fff' sf:right='#048'/>" +
  "<path d='M20 20L60 20L50 35Z' sf:left='#fff' sf:right='#c40' sf:blur='9, 3' sf:left-blur='4'/></g>" +
  "<g sf:diffuse='true'><circle cx='70' cy='70' r='9' sf:left='red' sf:right='red' sf:left-opacity='0' sf:right-opacity='1'/></g></svg>";

const PREFIXED = `<s:svg xmlns:s="http://www.w3.org/2000/svg" xmlns:f="urn:sfumato:1" viewBox="0 0 80 60" f:version="1">
\t<s:g f:diffuse="true">
\t\t<s:line x1="-5" y1="30" x2="90" y2="34" f:left="#eef" f:right="#446"/> <!-- the sea -->
\t\t<s:polygon points="20,32 50,32 44,40 26,40" f:left="#eef" f:right="#822"/>
\t</s:g>
\t<s:g><s:g f:diffuse="true"/></s:g>
</s:svg>`;

export interface Sample {
  readonly name: string;
  readonly text: string;
}

export const SAMPLES: readonly Sample[] = [
  { name: "indented", text: INDENTED },
  { name: "indented, CRLF", text: INDENTED.replaceAll("\n", "\r\n") },
  { name: "Inkscape's", text: INKSCAPE },
  { name: "one line", text: ONE_LINE },
  { name: "prefixed, tabs", text: PREFIXED },
];

export function file(relative: string): string {
  return fileURLToPath(new URL(relative, import.meta.url));
}

/** Returns the SVG drawings of examples/. */
export function examples(): Sample[] {
  const folder = file("../../../examples/");
  return readdirSync(folder)
    .filter((name) => name.endsWith(".svg"))
    .map((name) => ({ name, text: readFileSync(folder + name, "utf8") }));
}

/** Returns the item with an id. */
export function named(d: Drawing, id: string): Item {
  for (const item of d.all()) {
    if (item.element.attributes.some((a) => a.name === "id" && a.value === id)) return item;
  }
  throw new Error(`there is no #${id}`);
}

export function handle(d: Drawing, id: string): Handle {
  return named(d, id).handle;
}

/** Returns the text after a command; the same text if the command does nothing. */
export function after(text: string, command: (d: Drawing) => Outcome | null): string {
  const outcome = command(openDrawing(text));
  return outcome ? applied(text, outcome.patch) : text;
}

/** Returns the path of the module, or null. */
export function modulePath(): string | null {
  const places = [process.env.SFUMATO_WASM, file("../../../build-wasm/sfumato.wasm")];
  return places.find((place) => place !== undefined && existsSync(place)) ?? null;
}
