// What the page shows is what the rasterizer shows, at two zooms.
import { Skip, check, difference, pictureOf, settled, show } from "./harness.mjs";

/**
 * Documents, their pages' width and height, the width of the window, and where to look from near:
 * artboard point and zoom. Windows are small because the tests' graphics are made in software.
 */
const PICTURES = [
  {
    document: "../shared/scenes/lady_bug.xml",
    page: [512, 512],
    width: 320,
    near: { x: 170, y: 330, zoom: 5 },
  },
  {
    document: "examples/apple.svg",
    page: [640, 480],
    width: 240,
    near: { x: 345, y: 110, zoom: 3 },
  },
  {
    document: "examples/fish.svg",
    page: [840, 560],
    width: 240,
    near: { x: 290, y: 320, zoom: 2 },
  },
  {
    document: "examples/blur.svg",
    page: [984, 500],
    width: 240,
    near: { x: 200, y: 200, zoom: 3 },
  },
  {
    document: "examples/textures.svg",
    page: [800, 500],
    width: 240,
    near: { x: 200, y: 200, zoom: 3 },
  },
  {
    document: "examples/strokes.svg",
    page: [900, 640],
    width: 240,
    near: { x: 225, y: 300, zoom: 4 },
  },
  {
    document: "tests/viewer/compositing.svg",
    page: [200, 120],
    width: 320,
    near: { x: 100, y: 60, zoom: 4 },
  },
];

const LARGEST_MEAN = 0.7;
const LARGEST_PERCENTILE = 10;

async function compare({ PNG, command }, page, document, size, view, name) {
  const shown = await pictureOf(page);
  const extent = size.map((length) => length / view.zoom);
  const part = [view.x - extent[0] / 2, view.y - extent[1] / 2, ...extent];
  const expected = command.raster(document, size, part);
  const { mean, percentile, largest } = difference(PNG, shown, expected);
  const found = `${name}: mean ${mean.toFixed(3)}, 99th percentile ${percentile}, most ${largest}`;
  console.log(`# ${document} ${found}`);
  check(mean <= LARGEST_MEAN && percentile <= LARGEST_PERCENTILE, found);
  return largest;
}

export async function testPictures(tap, tools) {
  for (const { document, page: extent, width, near } of PICTURES) {
    await tap.test(
      `the viewer shows ${document.split("/").at(-1)} as the rasterizer does`,
      async () => {
        const html = tools.command.html(document);
        const zoom = width / extent[0],
          size = [width, Math.floor(extent[1] * zoom)];
        const whole = { x: extent[0] / 2, y: size[1] / zoom / 2, zoom };
        const hash = `#${whole.x},${whole.y},${whole.zoom}`;
        await tools.pages.open(html + hash, { size }, async (page) => {
          await settled(page);
          await compare(tools, page, document, size, whole, "whole");
          await show(page, near);
          await compare(tools, page, document, size, near, "near");
        });
      },
    );
  }
}

/** What compositing.svg differs by at most: its edges do. Lines where there are none differ more. */
const LARGEST_AT_EDGES = 40;

/** On Mesa's software driver, which has other weaknesses than Chromium's own. */
export async function testOnMesa(tap, tools) {
  const { document, page: extent, width } = PICTURES.at(-1);
  await tap.test("Mesa's driver shows compositing.svg as the rasterizer does", async () => {
    const zoom = width / extent[0];
    const size = [width, Math.floor(extent[1] * zoom)];
    const view = { x: extent[0] / 2, y: size[1] / zoom / 2, zoom };
    const path = tools.command.html(document);
    await tools.pages.open(path, { size, broken: true }, async (page) => {
      const isReady = await page.evaluate(() =>
        window.sfumatoViewer.ready.then(
          () => true,
          () => false,
        ),
      );
      if (!isReady) throw new Skip("Chromium has no WebGL 2 by Mesa's driver here");
      await show(page, view);
      const largest = await compare(tools, page, document, size, view, "on Mesa");
      check(largest <= LARGEST_AT_EDGES, `${largest} at most`);
    });
  });
}
