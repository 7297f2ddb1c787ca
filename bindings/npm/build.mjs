// Builds the package: node build.mjs MODULES OUT, where MODULES is the output folder of scripts/build-wasm. Needs
// the packages of tests/package.json. Run it through scripts/build-npm.
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { libraries, licenceOfLibrary } from "../../web/wasm/licences.mjs";

const { build } = createRequire(new URL("tests/package.json", import.meta.url))("esbuild");
const path = (relative) => fileURLToPath(new URL(relative, import.meta.url));
const [modules, out] = process.argv.slice(2);

/** Leaves a file out that is in the package once, and that the others import. */
const apart = (filter, path) => ({
  name: "apart",
  setup: (building) => building.onResolve({ filter }, () => ({ path, external: true })),
});

const library = apart(/^\.\/library\.js$/, "./library.js");
const drawing = apart(/^\.\/drawing\.js$/, "./drawing.js");
/** All parts throw the same class, so that `instanceof` holds. The worker has its own: its errors are copied. */
const errors = apart(/\/error\.mjs$/, "./error.js");

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

/** Returns the licence texts of the code that the modules contain besides the library. */
function licences() {
  const parts = libraries.map((name) => `=== ${name} ===\n\n${licenceOfLibrary(modules, name)}\n`);
  return `The modules of this package hold parts of these libraries.\n\n${parts.join("\n")}`;
}

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
await bundle("../../web/wasm/error.mjs", { outdir: undefined, outfile: join(out, "error.js") });
await bundle("src/library.js", { plugins: [errors] });
await bundle("src/node.js", { platform: "node", plugins: [library, errors] });
await bundle("src/index.js", { plugins: [library, errors], minify: true });
await bundle("src/worker.js", { minify: true });
await bundle("src/element/element.js", { minify: true, plugins: [drawing, errors] });
await bundle("src/element/drawing.js", { minify: true, plugins: [errors] });
for (const name of ["package.json", "README.md", "src/index.d.ts", "src/element.d.ts", "../../LICENSE"]) {
  copyFileSync(path(name), join(out, name.split("/").at(-1)));
}
writeFileSync(join(out, "licences.txt"), licences());
copyFileSync(join(modules, "sfumato-files.wasm"), join(out, "sfumato.wasm"));
copyFileSync(join(modules, "sfumato-solver.wasm"), join(out, "sfumato-solver.wasm"));
