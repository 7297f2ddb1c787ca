// Exact pixels: compares the stage after gathering with the command's drawing of the same part.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { check, checkEqual, EditorPage, PATIENCE, Skip } from "./harness.mjs";
import { largestDifference } from "./pixels.mjs";

/** The four points, x and y, of each of the layers' curves. */
const curves = [
  [-10, 60, 30, 20, 80, 95, 130, 50],
  [40, 25, 50, 8, 72, 8, 82, 27],
  [20, 70, 45, 78, 70, 74, 96, 66],
];
const path = ([x, y, ...rest], style) => `<path d="M${x} ${y} C${rest.join(" ")}" ${style}/>`;
const drawing = (paint = "#124") => `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" sf:version="1"
  viewBox="0 0 120 90"><defs><linearGradient id="g" gradientUnits="userSpaceOnUse" x2="120"><stop stop-color="red"/>
  <stop offset="1" stop-color="blue"/></linearGradient></defs>
  <g sf:diffuse="true">${path(curves[0], `sf:left="#9cf, #fed" sf:right="${paint}, #c21"`)}
    ${path(curves[1], 'sf:left="gold" sf:right="#fff" sf:blur="6, 1"')}</g>
  <g sf:diffuse="true" opacity=".8">${path(curves[2], 'sf:left="red" sf:right="#0a5" sf:left-opacity="1, .2" sf:right-opacity="0, .7"')}</g>
</svg>`;

/** Few pixels, because software takes a second for a few thousand. */
const RATIO = 0.25;
const opened = { size: [800, 480], ratio: RATIO, isDrawn: true };

const state = (editor) => editor.page.evaluate(() => window.sfumatoEditor.exactPixels);

/** A busy machine gathers few pixels at a time, which takes longer than other states. */
const becomes = (editor, kind) =>
  editor.page.waitForFunction((wanted) => window.sfumatoEditor.exactPixels.kind === wanted, kind, {
    timeout: 4 * PATIENCE,
  });

async function gathered(editor) {
  await editor.settled();
  await becomes(editor, "exact");
}

/** Returns the part of the artboard on the canvas: x, y, pixels per unit, and its size in pixels. */
async function seen(editor) {
  const box = await editor.page.locator(".canvas-stage > canvas").boundingBox();
  const [x, y] = await editor.at(0, 0);
  const zoom = ((await editor.at(100, 0))[0] - x) / 100;
  const [width, height] = [box.width, box.height].map((length) => Math.round(RATIO * length));
  return { x: (box.x - x) / zoom, y: (box.y - y) / zoom, zoom: RATIO * zoom, width, height };
}

/** Returns a PNG that the command draws exactly. */
function drawn(text, { x, y, zoom, width, height }) {
  const command = process.env.SFUMATO;
  if (!command) throw new Skip("SFUMATO names no command");
  const folder = mkdtempSync(join(tmpdir(), "sfumato-exact-"));
  try {
    const [drawing, picture] = ["drawing.svg", "picture.png"].map((name) => join(folder, name));
    writeFileSync(drawing, text);
    const part = [x, y, width / zoom, height / zoom].join(",");
    const size = ["--no-antialias", "--width", String(width), "--height", String(height), "--viewport", part];
    execFileSync(command, ["render", drawing, "-o", picture, "--method", "pixels", "--no-dither", "--quiet", ...size]);
    return readFileSync(picture);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Returns a test for pixels on the page that have no curve within two pixels. */
function awayFromCurves({ x, y, zoom }) {
  const near = new Set();
  for (const [x0, y0, x1, y1, x2, y2, x3, y3] of curves) {
    for (let i = 0; i <= 40_000; ++i) {
      const t = i / 40_000;
      const [a, b, c, d] = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
      const px = (a * x0 + b * x1 + c * x2 + d * x3 - x) * zoom;
      const py = (a * y0 + b * y1 + c * y2 + d * y3 - y) * zoom;
      for (let j = -2; j <= 2; ++j) for (let k = -2; k <= 2; ++k) near.add(`${Math.floor(px) + j},${Math.floor(py) + k}`);
    }
  }
  const isOnPage = (px, py) => {
    const [u, v] = [(px + 0.5) / zoom + x, (py + 0.5) / zoom + y];
    return u > 1 / zoom && v > 1 / zoom && u < 120 - 1 / zoom && v < 90 - 1 / zoom;
  };
  return (px, py) => isOnPage(px, py) && !near.has(`${px},${py}`);
}

async function checkExact(editor, what) {
  await gathered(editor);
  const part = await seen(editor);
  const text = await editor.text;
  const difference = largestDifference(await editor.picture(), drawn(text, part), awayFromCurves(part));
  check(difference <= 1, `${what}: ${difference} code values from the command's exact pixels`);
}

export async function testExact(tap, { browser, address }) {
  await tap.test("exact pixels: at any zoom, where nothing moves", async () => {
    const editor = await EditorPage.open(browser, address, opened);
    await editor.load(drawing());
    checkEqual(await state(editor), { kind: "off" }, "where software draws");
    await editor.key("e");
    await checkExact(editor, "the whole picture");
    await editor.shot("exact");
    const middle = await editor.at(60, 45);
    await editor.page.mouse.move(...middle);
    for (let i = 0; i < 8; ++i) await editor.key("+");
    await becomes(editor, "gathering");
    await checkExact(editor, "a part, enlarged");
    await editor.shot("exact-zoom");
    await editor.key("e");
    await becomes(editor, "off");
    editor.checkQuiet();
    await editor.close();
  });

  await tap.test("exact pixels: of what has changed, and why there are none", async () => {
    const editor = await EditorPage.open(browser, address, opened);
    await editor.load(drawing());
    await editor.key("e");
    await gathered(editor);
    await editor.load(drawing("#e08"));
    await checkExact(editor, "another colour");
    await editor.load(drawing("url(#g)").replace("url(#g), #c21", "url(#g)"));
    await becomes(editor, "none");
    checkEqual((await state(editor)).reason, "a layer has image-domain shaders", "the reason");
    await editor.load(drawing());
    await checkExact(editor, "without the gradient again");
    editor.checkQuiet();
    await editor.close();
  });
}
