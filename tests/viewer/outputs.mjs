// Outputs other than the viewer, in programs from npm and Chromium: SVG and GLB.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { check, difference, shortName } from "./harness.mjs";

const LADY_BUG = "../shared/scenes/lady_bug.xml";
const APPLE = "examples/apple.svg";
const FISH = "examples/fish.svg";

/** Width and height for the comparison, and limits: a third above the measured values. */
const SHOWN = [
  { document: LADY_BUG, size: [512, 512], mode: "vector", mean: 0.6, percentile: 6 },
  { document: APPLE, size: [640, 480], mode: "vector", mean: 0.6, percentile: 4 },
  { document: FISH, size: [840, 560], mode: "image", mean: 0.15, percentile: 1 },
];

async function shownByChromium(pages, path, size) {
  let shown = null;
  await pages.visit(`file://${path}`, { size }, async (page) => {
    shown = await page.screenshot();
  });
  return shown;
}

/** Some platforms have no resvg. */
function loadResvg() {
  try {
    return createRequire(import.meta.url)("@resvg/resvg-js").Resvg;
  } catch {
    return undefined;
  }
}

function compare(tools, shown, { document, size, mean, percentile }, program) {
  const expected = tools.command.raster(document, size, [0, 0, ...size]);
  const found = difference(tools.PNG, shown, expected);
  const text = `mean ${found.mean.toFixed(3)}, 99th percentile ${found.percentile}`;
  console.log(`# ${shortName(document)} in ${program}: ${text}`);
  check(found.mean <= mean && found.percentile <= percentile, text);
}

/** Needs no browser. */
export async function testGlb(tap, { command }) {
  const validator = createRequire(import.meta.url)("gltf-validator");
  for (const document of [LADY_BUG, APPLE, FISH, "examples/textures.svg"]) {
    await tap.test(`the GLB of ${shortName(document)} is valid`, async () => {
      const bytes = readFileSync(command.made(document, "glb"));
      const { issues } = await validator.validateBytes(new Uint8Array(bytes));
      check(issues.numErrors + issues.numWarnings === 0, JSON.stringify(issues.messages));
    });
  }
}

export async function testSvg(tap, tools) {
  const Resvg = loadResvg();
  for (const shown of SHOWN) {
    const options = ["--svg", shown.mode, "--dpi", 96];
    const name = `SVG (${shown.mode}) of ${shortName(shown.document)}`;
    await tap.test(`Chromium shows the ${name} as the rasterizer does`, async () => {
      const path = tools.command.made(shown.document, "svg", ...options);
      const image = await shownByChromium(tools.pages, path, shown.size);
      compare(tools, image, shown, "Chromium");
    });
    if (!Resvg) continue;
    await tap.test(`resvg shows the ${name} as the rasterizer does`, () => {
      const path = tools.command.made(shown.document, "svg", ...options);
      const image = new Resvg(readFileSync(path, "utf8")).render();
      compare(tools, image.asPng(), shown, "resvg");
    });
  }
}
