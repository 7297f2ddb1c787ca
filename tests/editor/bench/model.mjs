// Times of the editor's model: node tests/editor/bench/model.mjs DRAWING.svg...
// Prints one line of JSON for each drawing, milliseconds of CPU: opening it, an edit of one curve's points (median
// and 95th percentile of 300), and an edit that is read again.
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { fileURLToPath } from "node:url";
import { createServer } from "../../../web/editor/node_modules/vite/dist/node/index.js";

const server = await createServer({
  root: fileURLToPath(new URL("../../../web/editor", import.meta.url)),
  configFile: false,
  logLevel: "error",
  optimizeDeps: { noDiscovery: true },
  server: { middlewareMode: true, ws: false },
});
const { openDrawing } = await server.ssrLoadModule("/src/model/drawing.ts");
const { patchOf, setAttribute } = await server.ssrLoadModule("/src/source/attributes.ts");

function milliseconds(body) {
  const before = process.cpuUsage();
  body();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}

/** Wall clock, because CPU time is too coarse for such short steps. */
function shortMilliseconds(body) {
  const before = performance.now();
  body();
  return performance.now() - before;
}

function quantile(times, share) {
  const sorted = [...times].sort((a, b) => a - b);
  return sorted[Math.min(Math.floor(share * sorted.length), sorted.length - 1)];
}

function measured(path) {
  const text = readFileSync(path, "utf8");
  const opened = Array.from({ length: 7 }, () => milliseconds(() => openDrawing(text)));
  const drawing = openDrawing(text);
  const paths = [...drawing.all()].filter((item) => item.isPath);
  const edits = Array.from({ length: 300 }, (_, i) => {
    const { element } = drawing.item(paths[(7919 * i) % paths.length].handle);
    const patch = patchOf(setAttribute(drawing.text, element, "d", `M1 2 L3 ${i}`));
    return shortMilliseconds(() => drawing.apply(patch));
  });
  const structural = Array.from({ length: 7 }, () => {
    const at = drawing.root.content.start;
    return milliseconds(() => drawing.apply([{ at, removed: "", inserted: " " }]));
  });
  const rounded = (value) => Number(value.toFixed(3));
  return {
    drawing: basename(path),
    bytes: text.length,
    curves: paths.length,
    open: rounded(Math.min(...opened)),
    edit: rounded(quantile(edits, 0.5)),
    edit95: rounded(quantile(edits, 0.95)),
    structural: rounded(Math.min(...structural)),
  };
}

for (const path of process.argv.slice(2)) console.log(JSON.stringify(measured(path)));
await server.close();
