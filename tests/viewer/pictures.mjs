// The page shows the rasterizer's picture, at two zooms.
import { Skip, check, difference, pictureOf, settled, show } from "./harness.mjs";

/**
 * Documents, their pages' width and height, the width of the window, and a close view: artboard point and zoom.
 * `most`: the largest allowed difference of a value, if there is a limit. Windows are small because the tests use
 * software rendering.
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
    document: "tests/viewer/cones.svg",
    page: [120, 80],
    width: 240,
    near: { x: 20, y: 44, zoom: 8 },
  },
  {
    document: "tests/viewer/compositing.svg",
    // At edges; lines without edges differ more.
    most: 40,
    page: [200, 120],
    width: 320,
    near: { x: 100, y: 60, zoom: 4 },
  },
];

const LARGEST_MEAN = 0.9;
const LARGEST_PERCENTILE = 10;

async function compare({ PNG, command }, page, tested, size, view, name) {
  const { document, most = 255 } = tested;
  const shown = await pictureOf(page);
  const extent = size.map((length) => length / view.zoom);
  const part = [view.x - extent[0] / 2, view.y - extent[1] / 2, ...extent];
  const expected = command.raster(document, size, part);
  const { mean, percentile, largest } = difference(PNG, shown, expected);
  const found = `${name}: mean ${mean.toFixed(3)}, 99th percentile ${percentile}, most ${largest}`;
  console.log(`# ${document} ${found}`);
  check(mean <= LARGEST_MEAN && percentile <= LARGEST_PERCENTILE && largest <= most, found);
}

export async function testPictures(tap, tools) {
  for (const tested of PICTURES) {
    const { document, page: extent, width, near } = tested;
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
          await compare(tools, page, tested, size, whole, "whole");
          await show(page, near);
          await compare(tools, page, tested, size, near, "near");
        });
      },
    );
  }
}

/** On a driver that the other tests do not use, because each driver has its own weaknesses. */
export async function testOtherDriver(tap, tools) {
  const tested = PICTURES.at(-1);
  const { document, page: extent, width } = tested;
  await tap.test("another driver shows compositing.svg as the rasterizer does", async () => {
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
      if (!isReady) throw new Skip("Chromium has WebGL 2 by one driver only here");
      await show(page, view);
      await compare(tools, page, tested, size, view, "by another driver");
    });
  });
}
