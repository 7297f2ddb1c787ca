// Holds the folders of src/ to their order: a file imports from its own folder and those listed.
import { readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("src", import.meta.url));
const below = {
  strings: [],
  geometry: [],
  source: ["geometry"],
  model: ["source", "geometry"],
  engine: ["geometry", "strings"],
  app: ["model", "source", "engine", "geometry", "strings"],
  files: ["app", "model", "source", "engine", "geometry", "strings"],
  canvas: ["app", "model", "engine", "geometry", "strings"],
  panels: ["app", "model", "source", "files", "engine", "geometry", "strings"],
};
/** Types alone may also come from here. */
const types = { engine: ["model"], app: ["canvas"] };

function* filesOf(folder) {
  for (const name of readdirSync(folder)) {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) yield* filesOf(path);
    else if (/\.tsx?$/.test(name)) yield path;
  }
}

let wrong = 0;
for (const path of filesOf(root)) {
  const folder = relative(root, path).split("/")[0];
  if (!(folder in below)) continue;
  for (const [, kind, target] of readFileSync(path, "utf8").matchAll(
    /^(?:import|export)( type)?[^"']*?["'](\.[^"']+)["']/gm,
  )) {
    const to = relative(root, resolve(dirname(path), target)).split("/")[0];
    if (to === folder || to === ".." || !(to in below)) continue;
    if (below[folder].includes(to) || (kind && types[folder]?.includes(to))) continue;
    console.error(`${relative(root, path)} imports ${target}: ${folder} stands below ${to}`);
    wrong += 1;
  }
}
process.exit(wrong > 0 ? 1 : 0);
