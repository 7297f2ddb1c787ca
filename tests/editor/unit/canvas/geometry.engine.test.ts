// Pieces equal the engine's pieces, on all drawings of examples/.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";
import { shapePaths } from "../../../../web/editor/src/geometry/path.js";

const file = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));
const wasm = process.env.SFUMATO_WASM ?? file("../../../../build-wasm/sfumato.wasm");
const SHAPE = /^<(path|line|polyline|polygon|circle|ellipse|rect)\b/;

/** Returns the artboard, as far as percentages in examples need it. */
function viewBoxOf(text: string): readonly [number, number, number, number] {
  const [x, y, width, height] = (/viewBox="([^"]*)"/.exec(text)?.[1] ?? "0 0 0 0")
    .split(/[ ,]+/)
    .map(Number);
  return [x, y, x + width, y + height];
}

/** Returns the largest difference between both, in coordinates. */
function distanceOf(ours: readonly (readonly number[])[], theirs: ArrayLike<number>): number {
  const flat = ours.flat();
  if (flat.length !== theirs.length) return Infinity;
  return flat.reduce((most, value, i) => Math.max(most, Math.abs(value - theirs[i])), 0);
}

/** A document with shapes that use all path commands and unusual numbers. */
const HARD = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 300 200" sf:version="1">
<g sf:diffuse="true">${[
  '<path d="M10-20.5.5 1e1zm5,5h3v4H1V2zL3 3" sf:left="red"/>',
  '<path d="m 10,10 c 1,2 3,4 5,6 s 3 4 9-2 q 1 1 4 4 t 5 5 t -1 3 S 1 1 2 2 T 9 9 a 5 4 30 1 0 7 9 A 50 20 -40.5 01 90 3 z" sf:left="red"/>',
  '<path d="M0 0A10 10 0 0 1 20 0A10 10 0 1 1 20 .0001A1 1 0 1 0 90 90a5 0 0 1 1 4 4a7 7 0 0180 0" sf:left="red"/>',
  '<circle cx="40" cy="30" r="9.3" sf:left="red"/><ellipse cx="10%" cy="5mm" rx="auto" ry="7" sf:left="red"/>',
  '<rect x="3" y="4" width="50%" height="20%" rx="7" sf:left="red"/><rect width="8" height="6" rx="100" ry="1" sf:left="red"/>',
  '<rect x=".1" y=".2" width=".7" height="6.3" sf:left="red"/><rect x=".1" y=".2" width="6" height="6" rx="3" sf:left="red"/>',
  '<polyline points="1,2 3-4,5e0 6" sf:left="red"/><polygon points=" 0 0 10 0 10 10, 0 0 " sf:left="red"/>',
  '<line x1="1in" y2="10%" sf:left="red"/><path d="M5 5ZM1 1 2 2Z" sf:left="red"/><circle r="10%" sf:left="red"/>',
].join("\n")}</g></svg>`;

test.skipIf(!existsSync(wasm))(
  "pieces are the engine's",
  async () => {
    const { loadSfumato } = await import(file("../../../../web/wasm/sfumato.mjs"));
    const library = await loadSfumato(readFileSync(wasm));
    const folder = file("../../../../examples/");
    const names = (readdirSync(folder, { recursive: true }) as string[]).filter((n) =>
      n.endsWith(".svg"),
    );
    const texts = [HARD, ...names.map((name) => readFileSync(folder + name, "utf8"))];
    let compared = 0;
    for (const text of texts) {
      const context = library.context();
      let document;
      try {
        document = context.read(text);
      } catch {
        context.free(); // a drawing with files beside it, or not one of ours
        continue;
      }
      const bytes = Buffer.from(text);
      const viewBox = viewBoxOf(text);
      for (let layer = 0; document.layerId(layer) !== null; ++layer) {
        for (let curve = 0; curve < document.curveCount(layer); ++curve) {
          const source = document.curveSource(layer, curve);
          const element =
            source && bytes.subarray(source.byteOffset, source.byteOffset + 100000).toString();
          const shape = element && SHAPE.exec(element);
          if (!shape) continue;
          const tag = element.slice(0, element.indexOf(">"));
          const attribute = (name: string) => new RegExp(`\\s${name}="([^"]*)"`).exec(tag)?.[1];
          const paths = shapePaths(shape[1], attribute, viewBox);
          const points = document.points(layer, curve);
          // Transforms of shapes within layers are compared only by the number of pieces.
          const isPlain = text === HARD || !/transform/.test(text);
          const found = Math.min(...paths.map((p) => distanceOf(p.points, points)));
          if (isPlain) expect(found, tag).toBeLessThan(1e-7);
          else
            expect(
              paths.map((p) => 2 * p.points.length),
              tag,
            ).toContain(points.length);
          ++compared;
        }
      }
      document.free();
      context.free();
    }
    expect(compared).toBeGreaterThan(300);
  },
  60000,
);
