// Shaders as scripts hold them: without indentation and comments, as the viewer's page has them.
import { readFileSync } from "node:fs";
import { condensed } from "./viewer-page.mjs";

const shader = /^(.*\/(?:viewer\/shaders|src\/gather)\/[^/?]+)\?raw$/;

export function shaderTextPlugin() {
  return {
    name: "shader-text",
    enforce: "pre",
    load(id) {
      const path = shader.exec(id)?.[1];
      return path ? `export default ${JSON.stringify(condensed(readFileSync(path, "utf8")))};` : null;
    },
  };
}
