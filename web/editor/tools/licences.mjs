// The work by others in the editor, packages and libraries of the module, with their licences.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { libraries, licenceOfLibrary } from "../../wasm/licences.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const packages = here("../node_modules");
const said = (folder) => JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));

/** Code of the bundler that it puts into what it makes. */
const helpers = { "vite/": "vite", "rolldown/": "rolldown" };

/** Returns the packages that the editor depends on, directly or through others. */
function dependencies() {
  const found = new Set();
  const add = (folder) => {
    for (const name of Object.keys(said(folder).dependencies ?? {})) {
      if (found.has(name)) continue;
      found.add(name);
      add(join(packages, name));
    }
  };
  add(here(".."));
  return [...found];
}

/** Returns the licence text of a package; for Vite, the text for its own code without its build tools. */
function textOf(name) {
  const folder = join(packages, name);
  const file = readdirSync(folder).find((one) => /^licen[cs]e(\.|$)/i.test(one));
  if (!file) throw new Error(`${name} has no file with its licence`);
  const [own] = readFileSync(join(folder, file), "utf8").split(/^# Licenses of bundled dependencies/m);
  return own.trim();
}

/** {name, licence, text} of each. @param module path of sfumato.wasm */
function licencesOf(module) {
  const names = [...dependencies(), ...Object.values(helpers)].sort();
  const ofPackages = names.map((name) => ({ name, licence: said(join(packages, name)).license, text: textOf(name) }));
  const folder = dirname(module);
  const ofLibraries = libraries.map((name) => ({ name, licence: null, text: licenceOfLibrary(folder, name).trim() }));
  const own = { name: "Sfumato", licence: "MIT", text: readFileSync(here("../../../LICENSE"), "utf8").trim() };
  return [own, ...ofPackages, ...ofLibraries];
}

/** The package that a module of the bundle is of; null: it is the editor's own. */
function packageOf(id) {
  const [, inside] = /[\\/]node_modules[\\/]((?:@[^\\/]+[\\/])?[^\\/]+)/.exec(id.replace(/^.*node_modules(?=[\\/])/, "/node_modules")) ?? [];
  if (inside) return inside.replaceAll("\\", "/");
  const helper = Object.keys(helpers).find((prefix) => id.startsWith(`\0${prefix}`));
  return helper ? helpers[helper] : null;
}

/**
 * Gives them to `import licences from "virtual:licences"`. A bundle with a package that is not among
 * them is an error.
 */
export function licencesPlugin(module) {
  const name = "virtual:licences";
  return {
    name: "licences",
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load(id) {
      if (id !== `\0${name}`) return null;
      if (!existsSync(module)) throw new Error(`${module} is not there: run scripts/build-wasm first`);
      return `export default ${JSON.stringify(licencesOf(module))};`;
    },
    generateBundle(_, bundle) {
      const known = new Set([...dependencies(), ...Object.values(helpers)]);
      const ids = Object.values(bundle).flatMap((chunk) => Object.keys(chunk.modules ?? {}));
      const foreign = ids.map(packageOf).filter((found) => found !== null && !known.has(found));
      if (foreign.length > 0) throw new Error(`without a licence: ${[...new Set(foreign)].join(", ")}`);
    },
  };
}
