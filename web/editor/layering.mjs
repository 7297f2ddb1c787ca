// Checks the imports of src/: a file imports from its own folder and the folders listed for it, and no files
// import each other in a circle. Types count too; import() does not, since it runs later.
//
//   node layering.mjs [FOLDER]      default: src
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = resolve(process.argv[2] ?? fileURLToPath(new URL("src", import.meta.url)));
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

const nameOf = (path) => relative(root, path);
const folderOf = (path) => nameOf(path).split("/")[0];

/** Returns the file that an import names; null: none of src/. */
function fileOf(from, target) {
  const path = resolve(dirname(from), target).replace(/\.js$/, "");
  return [`${path}.ts`, `${path}.tsx`].find((file) => existsSync(file)) ?? null;
}

/** Returns the imports of a file: {isType, target, file}. */
function importsOf(path) {
  const pattern = /^(?:import|export)( type)?\b(?:[^"';()]*?\bfrom)?\s*["'](\.[^"']+)["']/gm;
  const found = [...readFileSync(path, "utf8").matchAll(pattern)];
  return found.map(([, type, target]) => ({ isType: Boolean(type), target, file: fileOf(path, target) }));
}

/** Returns a message for each import that breaks the order of folders. */
function climbs(graph) {
  return [...graph].flatMap(([path, imports]) =>
    imports.flatMap(({ isType, target }) => {
      const [from, to] = [folderOf(path), folderOf(resolve(dirname(path), target))];
      if (!(from in below) || !(to in below) || to === from || below[from].includes(to)) return [];
      if (isType && types[from]?.includes(to)) return [];
      return [`${nameOf(path)} imports ${target}: ${from} stands below ${to}`];
    }),
  );
}

/** Returns circles of files, each as its files in order; at least one for each group of files that form circles. */
function circles(graph) {
  const found = [];
  const done = new Set();
  const open = [];
  const visit = (path) => {
    if (open.includes(path)) return void found.push([...open.slice(open.indexOf(path)), path]);
    if (done.has(path)) return;
    open.push(path);
    for (const { file } of graph.get(path) ?? []) if (file) visit(file);
    open.pop();
    done.add(path);
  };
  for (const path of graph.keys()) visit(path);
  return found;
}

const names = readdirSync(root, { recursive: true }).filter((name) => /\.tsx?$/.test(name)).sort();
const graph = new Map(names.map((name) => [join(root, name), importsOf(join(root, name))]));
const complaints = [
  ...climbs(graph),
  ...circles(graph).map((circle) => `files import each other in a circle: ${circle.map(nameOf).join(" → ")}`),
];
for (const complaint of complaints) console.error(complaint);
console.log(`layering: ${graph.size} files, ${complaints.length} complaints`);
process.exitCode = complaints.length > 0 ? 1 : 0;
