// Drawings from other people and programs.
import { readFileSync, readdirSync } from "node:fs";
import { pathOf } from "./harness.mjs";

export const example = (name) => readFileSync(pathOf(`examples/${name}`), "utf8");
export const exampleNames = readdirSync(pathOf("examples")).filter((name) => name.endsWith(".svg")).sort();

/** Quick to draw: one curve with two colours. */
export const small = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 100 80" sf:version="1">
  <!-- a stranger's words -->
  <g sf:diffuse="true">
    <path id="one" d="M20,40 C40,10 60,70 80,40" sf:left="#d04020" sf:right="#2040d0"/>
  </g>
</svg>
`;

export const inkscape = `<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!-- Created with Inkscape (http://www.inkscape.org/) -->

<svg
   width="100mm"
   height="80mm"
   viewBox="0 0 100 80"
   version="1.1"
   id="svg5"
   inkscape:version="1.2.2 (b0a8486541, 2022-12-01)"
   sodipodi:docname="drawing.svg"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
   xmlns="http://www.w3.org/2000/svg"
   xmlns:svg="http://www.w3.org/2000/svg"
   xmlns:sf="urn:sfumato:1">
  <sodipodi:namedview
     id="namedview7"
     pagecolor="#ffffff"
     inkscape:document-units="mm"
     showgrid="false" />
  <defs
     id="defs2" />
  <g
     inkscape:label="Layer 1"
     inkscape:groupmode="layer"
     id="layer1"
     sf:diffuse="true">
    <path
       style="fill:none;stroke:#787878;stroke-width:0.264583px;stroke-linecap:butt"
       d="m 20,40 c 20,-30 40,30 60,0"
       id="path111"
       sf:left="#d04020"
       sf:right="#2040d0"
       inkscape:connector-curvature="0"
       sodipodi:nodetypes="cc" />
  </g>
</svg>
`;

export const illustrator = `<?xml version="1.0" encoding="utf-8"?>
<!-- Generator: Adobe Illustrator 27.0.0, SVG Export Plug-In . SVG Version: 6.00 Build 0)  -->
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">
<svg version="1.1" id="Layer_1" xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" x="0px" y="0px"
\t viewBox="0 0 100 80" style="enable-background:new 0 0 100 80;" xml:space="preserve">
<style type="text/css">
\t.st0{fill:none;stroke:#787878;stroke-miterlimit:10;}
</style>
<g sf:diffuse="true">
\t<path class="st0" d="M20,40c20-30,40,30,60,0" sf:left="#D04020" sf:right="#2040D0"/>
</g>
</svg>
`;

/** As older versions of Illustrator write; the editor shows it without editing it. */
export const entities = illustrator
  .replace("svg11.dtd\"", 'svg11.dtd" [\n\t<!ENTITY ns_ai "http://ns.adobe.com/AdobeIllustrator/10.0/">\n]')
  .replace("x=\"0px\"", 'xmlns:i="&ns_ai;" x="0px"');

const mark = Buffer.from([0xef, 0xbb, 0xbf]);

/** Bytes that saving must preserve. */
export const strangers = {
  "inkscape.svg": Buffer.from(inkscape),
  "illustrator.svg": Buffer.from(illustrator),
  "crlf.svg": Buffer.from(small.replaceAll("\n", "\r\n")),
  "mixed-ends.svg": Buffer.from(small.replace("\n", "\r\n").replace(/\n(?=<\/svg>)/, "\r")),
  "mark.svg": Buffer.concat([mark, Buffer.from(small)]),
  "mark-crlf.svg": Buffer.concat([mark, Buffer.from(small.replaceAll("\n", "\r\n"))]),
  "no-last-end.svg": Buffer.from(small.trimEnd()),
};

export const utf16 = (text, isLittle) => {
  const bytes = Buffer.from(`\ufeff${text}`, "utf16le");
  return isLittle ? bytes : bytes.swap16();
};

/** Returns the files of a tar archive of fuzz/corpus: {name, bytes}. */
export function corpus(archive) {
  const tar = readFileSync(pathOf(`fuzz/corpus/${archive}.tar`));
  const found = [];
  for (let at = 0; at + 512 <= tar.length && tar[at] !== 0; ) {
    const field = (from, length) => tar.toString("latin1", at + from, at + from + length).replace(/\0.*$/s, "").trim();
    const size = parseInt(field(124, 12), 8);
    const isFile = field(156, 1) === "0" || field(156, 1) === "";
    if (isFile) found.push({ name: field(0, 100), bytes: tar.subarray(at + 512, at + 512 + size) });
    at += 512 + 512 * Math.ceil(size / 512);
  }
  return found;
}
