import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";
import { licencesPlugin } from "./tools/licences.mjs";

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

/** The module that `make wasm` builds; SFUMATO_WASM names another. */
const module = process.env.SFUMATO_WASM ?? path("../../build-wasm/sfumato.wasm");

/** Tests lie outside of this folder, and name its packages all the same. */
const packagesForTests: Plugin = {
  name: "packages-for-tests",
  enforce: "pre",
  async resolveId(id, importer) {
    if (!/^[@a-z]/.test(id) || !importer?.startsWith(path("../../tests/editor/"))) return null;
    return this.resolve(id, path("src/main.tsx"), { skipSelf: true });
  },
};

export default defineConfig({
  root: path("."),
  base: "./",
  plugins: [licencesPlugin(module), packagesForTests],
  resolve: {
    alias: [{ find: /^sfumato-module(?=\?)/, replacement: module }],
  },
  server: { fs: { allow: [path("../..")] } },
  build: {
    outDir: path("../../build/editor"),
    emptyOutDir: true,
    target: "es2022",
    // Files that one of them needs are fetched beside it, not after it.
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
  },
  worker: { format: "es", plugins: () => [licencesPlugin(module)] },
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  test: {
    include: [path("../../tests/editor/unit/**/*.test.ts")],
    environment: "node",
    // Property tests on a machine that runs other programs too.
    testTimeout: 60000,
  },
});
