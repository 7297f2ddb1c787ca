// The drawings for the benchmarks of the editor.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { loadSfumato } from "../../../web/wasm/sfumato.mjs";
import { pathOf } from "../e2e/harness.mjs";

export const modulePath = process.env.SFUMATO_WASM ?? pathOf("build-wasm/sfumato.wasm");

/** Returns the path of a scene: a path, a name of examples/, or one of Orzan's in `folder`; or null. */
export function sceneFile(name, folder) {
  const places = [name, pathOf(`examples/${name}.svg`), join(folder, `${name}.xml`)];
  return places.find(existsSync) ?? null;
}

/** Returns the SVG of a file; Orzan's XML is converted. */
export async function svgOf(path) {
  const text = readFileSync(path, "utf8");
  if (path.endsWith(".svg")) return text;
  const context = (await loadSfumato(new WebAssembly.Module(readFileSync(modulePath)))).context();
  const converted = context.read(text).write();
  context.free();
  return converted;
}

/** Returns a drawing of many curves in squares of 10 units, with a layer for each row. */
export function manyCurves(count, across = 100) {
  const hex = (i) => ((Math.imul(i + 1, 0x9e3779b1) >>> 8) & 0xffffff).toString(16).padStart(6, "0");
  const curve = (i) => {
    const [x, y] = [10 * (i % across), 10 * Math.floor(i / across)];
    const d = `M${x + 2} ${y + 2}C${x + 4} ${y + 1} ${x + 6} ${y + 9} ${x + 8} ${y + 7}`;
    return `<path id="c${i}" d="${d}" sf:left="#${hex(i)}" sf:right="#fff, #${hex(i)}"/>`;
  };
  const strip = (row) => {
    const edge = `<rect y="${10 * row}" width="${10 * across}" height="10" sf:left="#888" sf:right="#888" sf:left-opacity="0" sf:right-opacity="1"/>`;
    const own = Array.from({ length: Math.min(across, count - row * across) }, (_, i) => curve(row * across + i));
    return `  <g id="row${row}" sf:diffuse="true">\n    ${[edge, ...own].join("\n    ")}\n  </g>`;
  };
  const rows = Math.ceil(count / across);
  const head = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 ${10 * across} ${10 * rows}" sf:version="1">`;
  return `${head}\n${Array.from({ length: rows }, (_, row) => strip(row)).join("\n")}\n</svg>\n`;
}
