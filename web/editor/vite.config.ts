import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

export default defineConfig({
  root: path("."),
  base: "./",
  server: { fs: { allow: [path("../..")] } },
  build: { outDir: path("../../build/editor"), emptyOutDir: true, target: "es2022" },
  worker: { format: "es" },
  esbuild: false,
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
  test: {
    include: [path("../../tests/editor/unit/**/*.test.ts")],
    environment: "node",
    // Property tests on a machine that does other things besides.
    testTimeout: 60000,
  },
});
