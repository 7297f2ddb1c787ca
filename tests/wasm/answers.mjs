// The module computes the same as the native library, bit for bit.
import { existsSync, readFileSync } from "node:fs";
import { basename } from "node:path";
import { Table } from "../../web/wasm/sfumato.mjs";
import { bytesOf, difference, nativeAnswer, pathOf, tablesOf } from "./harness.mjs";

const EVENING = "examples/evening.xml";
const CONTROLS = "tests/wasm/controls.svg";
const scene = (name) => `../shared/scenes/${name}.xml`;

/** The pixels of given.svg. */
const GIVEN = [250, 200, 0, 255, 0, 90, 200, 255, 255, 255, 255, 0, 20, 20, 20, 128];

/** question, document, options */
const CASES = [
  ["tables", EVENING, "max-error=off"],
  ["tables", EVENING, "max-error=1"],
  ["tables", CONTROLS, "max-error=off"],
  ["tables", CONTROLS, "max-error=1"],
  ["tables", scene("lady_bug"), "max-error=off"],
  ["tables", scene("endcap"), "max-error=off"],
  ["tables", scene("lady_bug"), "max-error=1"],
  ["dragged", EVENING, ""],
  ["dragged", CONTROLS, ""],
  ["dragged", scene("lady_bug"), ""],
  ["dragged", scene("lady_bug"), "drags"],
  ["rough", EVENING, ""],
  ["rough", scene("lady_bug"), ""],
  ["colors", EVENING, ""],
  ["colors", scene("lady_bug"), ""],
  ["pixels", CONTROLS, "width=64"],
  ["pixels", "tests/wasm/given.svg", ""],
  ["traced", EVENING, ""],
  ["traced", CONTROLS, "points=300 blur=off stops=many"],
  ["svg", EVENING, ""],
  ["svg", CONTROLS, ""],
  ["payload", EVENING, ""],
  ["payload", CONTROLS, ""],
  ["stack", EVENING, ""],
  ["stack", CONTROLS, ""],
  ["exact", EVENING, ""],
  ["exact", scene("lady_bug"), "width=700"],
  ["file", EVENING, ""],
  ["file", CONTROLS, "max-error=off"],
  ["pdf", EVENING, "detail=2"],
  ["pdf", CONTROLS, "detail=2"],
  ["image", CONTROLS, "detail=2"],
  ["vector", CONTROLS, ""],
  ["lint", CONTROLS, "verbose"],
  ["lint", "examples/fish.svg", "verbose"],
];

/** Returns the tables of the quick picture after the first curves have moved. */
function tablesOfMoved(context, document, options, curves) {
  const picture = context.solve(document, options);
  for (let curve = 0; curve < curves; ++curve) {
    const moved = document.points(0, curve).map((x, i) => x + (i % 2 === 0 ? 2 : 1));
    document.setPoints(0, curve, moved);
  }
  context.solveAgain(document, picture, { quick: true });
  return tablesOf(picture, Table);
}

/** The arguments of native_answers for the same. */
const ANSWERS = {
  tables: (context, document, options) =>
    tablesOf(context.solve(document, options), Table),
  dragged: (context, document, options) => tablesOfMoved(context, document, options, 1),
  rough: (context, document, options) => tablesOfMoved(context, document, options, 2),
  colors(context, document, options) {
    const [x, y, width, height] = document.artboard;
    const xy = [];
    for (let i = 0; i < 256; ++i) {
      xy.push(x + (((i % 16) + 0.5) / 16) * width, y + ((Math.floor(i / 16) + 0.5) / 16) * height);
    }
    return bytesOf(context.field(document, 0, options).colors(xy));
  },
  pixels: (context, document, options) =>
    context.raster(context.solve(document, options), { width: 64, height: 64 }),
  traced(context, document, options) {
    const size = { width: 64, height: 64 };
    const data = context.raster(context.solve(document), size);
    return new TextEncoder().encode(context.trace({ ...size, data }, options).write());
  },
  lint: (context, document, options) =>
    new TextEncoder().encode(`${JSON.stringify(context.lint(document, options))}\n`),
  svg: (context, document) => new TextEncoder().encode(document.write()),
  payload: (context, document, options) =>
    context.viewerPayload(context.solve(document, options)),
  file(context, document, options) {
    const bytes = context.writePicture(context.solve(document, options));
    return context.writePicture(context.readPicture(bytes));
  },
  stack: (context, document, options) => context.pictureStack(context.solve(document, options)),
  pdf: (context, document, options) =>
    context.export(context.solve(document, options), "pdf", { title: "A" }),
  image: (context, document, options) => context.export(context.solve(document, options), "svg"),
  vector: (context, document, options) =>
    context.export(context.solve(document, options), "svg", { svg: "vector" }),
  exact: (context, document, options) => context.exactLayer(context.solve(document, options), 0),
};

export async function testAnswers(tap, sfumato, program) {
  for (const [question, relative, options] of CASES) {
    const path = pathOf(relative);
    const name = `${basename(path)} has the native ${question}, bit for bit (${options || "defaults"})`;
    if (!existsSync(path)) {
      tap.skip(name, "the public scenes are not here");
      continue;
    }
    await tap.test(name, () => {
      const context = sfumato.context();
      const given = { width: 2, height: 2, data: Uint8Array.from(GIVEN) };
      context.addImage(new TextEncoder().encode("image"), given);
      const document = context.read(readFileSync(path), { name: path });
      const actual = ANSWERS[question](context, document, options);
      document.free();
      context.free();
      return difference(actual, nativeAnswer(program, question, path, options));
    });
  }
}
