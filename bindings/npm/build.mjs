// Makes the package: node build.mjs MODULES OUT, where MODULES is what scripts/build-wasm has made.
// Needs the packages of tests/package.json. Run it by scripts/build-npm.
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { condensed } from "../../web/editor/tools/viewer-page.mjs";

const { build } = createRequire(new URL("tests/package.json", import.meta.url))("esbuild");
const path = (relative) => fileURLToPath(new URL(relative, import.meta.url));
const [modules, out] = process.argv.slice(2);

/** The viewer's shaders by their names, without comments and indentation, as its page has them. */
const shaders = {
  name: "shaders",
  setup(building) {
    building.onResolve({ filter: /^sfumato-shaders$/ }, () => ({ path: "shaders", namespace: "shaders" }));
    building.onLoad({ filter: /.*/, namespace: "shaders" }, () => {
      const folder = path("../../web/viewer/shaders");
      // Of the editor, and of exact pixels.
      const names = readdirSync(folder).filter((name) => !/^(edges\.|exact)/.test(name));
      const texts = names.map((name) => [name, condensed(readFileSync(join(folder, name), "utf8"))]);
      const table = JSON.stringify(Object.fromEntries(texts));
      return { contents: `const texts = ${table};\nexport const shaderText = (name) => texts[name];` };
    });
  },
};

/** What stands once in the package, beside those that import it. */
const apart = {
  name: "apart",
  setup(building) {
    const filter = /^\.\/(library|drawing)\.js$/;
    building.onResolve({ filter }, ({ path }) => ({ path, external: true }));
  },
};

const bundle = (entry, options = {}) =>
  build({
    entryPoints: [path(entry)],
    outdir: out,
    bundle: true,
    format: "esm",
    target: "es2022",
    logLevel: "warning",
    ...options,
  });

/** What is in the modules besides the library, with the words that its licences want to go with it. */
function licences() {
  const debian = (name) => readFileSync(`/usr/share/doc/${name}/copyright`, "utf8");
  const comment = (name, which) => readFileSync(join(modules, name), "utf8").match(/\/\*[^]*?\*\//g).at(which);
  const texts = {
    pugixml: comment("pugixml/pugixml.hpp", -1),
    zlib: comment("zlib/zlib.h", 0),
    "wasi-libc": debian("wasi-libc"),
    "libc++": debian("libc++-19-dev-wasm32"),
  };
  const parts = Object.entries(texts).map(([name, text]) => `=== ${name} ===\n\n${text}\n`);
  return `The modules of this package hold parts of these libraries.\n\n${parts.join("\n")}`;
}

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
await bundle("src/library.js");
await bundle("src/node.js", { platform: "node", plugins: [apart] });
await bundle("src/index.js", { plugins: [apart], minify: true });
await bundle("src/worker.js", { minify: true });
await bundle("src/element/element.js", { minify: true, plugins: [apart] });
await bundle("src/element/drawing.js", { minify: true, plugins: [shaders] });
for (const name of ["package.json", "README.md", "src/index.d.ts", "src/element.d.ts", "../../LICENSE"]) {
  copyFileSync(path(name), join(out, name.split("/").at(-1)));
}
writeFileSync(join(out, "licences.txt"), licences());
copyFileSync(join(modules, "sfumato-files.wasm"), join(out, "sfumato.wasm"));
copyFileSync(join(modules, "sfumato-solver.wasm"), join(out, "sfumato-solver.wasm"));
