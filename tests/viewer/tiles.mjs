// `sfumato tiles` in OpenSeadragon: at 1:1 it shows the pixels of the picture there.
import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { check, difference, documentPath, pathOf } from "./harness.mjs";

const SIZE = [320, 200]; // of the page
const WIDTH = 3000; // of the largest level

const PAGE = `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,">
<style>html, body, #deep { margin: 0; width: 100%; height: 100% }</style><div id="deep"></div>
<script src="openseadragon.js"></script><script>
window.viewer = OpenSeadragon({ id: "deep", tileSources: "sunset.dzi", drawer: "canvas",
  showNavigationControl: false, immediateRender: true, animationTime: 0, imageSmoothingEnabled: false });
</script>`;

/** Serves a folder, the page and the library on an address of this machine. */
async function serve(folder) {
  const library = pathOf("tests/viewer/node_modules/openseadragon/build/openseadragon/openseadragon.js");
  const server = createServer((request, response) => {
    const name = new URL(request.url, "http://localhost").pathname;
    try {
      if (name === "/") {
        response.setHeader("Content-Type", "text/html").end(PAGE);
      } else if (name === "/openseadragon.js") {
        response.setHeader("Content-Type", "text/javascript").end(readFileSync(library));
      } else {
        response.end(readFileSync(folder + name));
      }
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return server;
}

/** Shows the largest level with this pixel in the middle, and waits until all of it is loaded. */
const show = (page, x, y) =>
  page.evaluate(
    async ([centerX, centerY]) => {
      const { viewer } = window;
      if (!viewer.world.getItemCount()) await new Promise((done) => viewer.addOnceHandler("open", done));
      const item = viewer.world.getItemAt(0);
      viewer.viewport.maxZoomPixelRatio = 4;
      viewer.viewport.zoomTo(item.imageToViewportZoom(1), undefined, true);
      viewer.viewport.panTo(item.imageToViewportCoordinates(centerX, centerY), true);
      viewer.forceRedraw();
      // The item counts as loaded until the viewer's next frame chooses other tiles, so three frames must agree.
      const settled = () => item.getFullyLoaded() && !viewer.world.needsDraw();
      for (let frames = 0; frames < 3; frames = settled() ? frames + 1 : 0) {
        await new Promise((done) => requestAnimationFrame(done));
      }
    },
    [x, y],
  );

export async function testTiles(tap, { PNG, command, pages }) {
  await tap.test("OpenSeadragon shows tiles as the picture is", async () => {
    const folder = command.file("deep");
    const picture = command.file("sunset.sfp");
    command.run("solve", documentPath("examples/sunset.svg"), "-o", picture, "--width", WIDTH);
    command.run("tiles", picture, "-o", folder, "--overlap", 1);
    const server = await serve(folder);
    try {
      const address = `http://127.0.0.1:${server.address().port}/`;
      await pages.visit(address, { size: SIZE }, async (page) => {
        for (const [x, y] of [
          [1024, 1000],
          [2048, 768],
        ]) {
          await show(page, x, y);
          const shown = await page.screenshot();
          const part = [x - SIZE[0] / 2, y - SIZE[1] / 2, ...SIZE];
          const path = command.file("part.png");
          command.run("render", picture, "-o", path, "--width", WIDTH, "--window", part.join(","));
          const { largest } = difference(PNG, shown, readFileSync(path));
          check(largest <= 1, `at ${x}, ${y}: pixels differ by ${largest}`);
        }
      });
    } finally {
      server.close();
    }
  });
}
