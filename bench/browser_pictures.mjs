#!/usr/bin/env node
// Draws SVG files in Chromium, for `bench/import --browser`.
//
//   npm ci --prefix tests/viewer
//   node bench/browser_pictures.mjs OUT FOLDER...
//
// For each SVG file of a folder that has a PNG of the same name, draws OUT/FOLDER/…/NAME.png in the PNG's size, on
// white. Folders are searched recursively; existing pictures are kept. The browser opens the file itself, with the
// drawing's own width (its width or its viewBox), at as many pixels per CSS pixel as the PNG needs. The environment
// variable CHROMIUM names another program.
import { mkdirSync, readFileSync, readdirSync, existsSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { SWIFTSHADER, launchWith } from "../tests/chromium.mjs";

const require = createRequire(new URL("../tests/viewer/", import.meta.url));
const { chromium } = require("playwright-core");

const [out, ...folders] = process.argv.slice(2);
if (!out || folders.length === 0) {
  console.error("usage: node bench/browser_pictures.mjs OUT FOLDER...");
  process.exit(2);
}

/** Returns width and height of a PNG file. */
function sizeOf(png) {
  const header = readFileSync(png);
  return [header.readUInt32BE(16), header.readUInt32BE(20)];
}

/** Returns the SVG files of a folder that have a PNG, with the names of their pictures. */
function filesOf(folder) {
  return readdirSync(folder, { recursive: true })
    .filter((name) => name.endsWith(".svg"))
    .map((name) => name.slice(0, -".svg".length))
    .filter((name) => existsSync(join(folder, `${name}.png`)))
    .sort()
    .map((name) => ({
      svg: join(folder, `${name}.svg`),
      png: join(folder, `${name}.png`),
      picture: join(out, basename(resolve(folder)), `${name}.png`),
    }));
}

/** In the page: returns the width of the drawing in px, or null if the drawing does not define it. */
function drawingWidth() {
  const root = document.documentElement;
  if (!(root instanceof SVGSVGElement)) return null;
  const { animVal: width } = root.width;
  const isShare = width.unitType === SVGLength.SVG_LENGTHTYPE_PERCENTAGE;
  const value = isShare ? root.viewBox.animVal?.width : width.value;
  return value > 0 ? value : null;
}

/** Shows the page at a size in CSS px, with `scale` pixels for each CSS px. */
const show = (session, width, height, scale) =>
  session.send("Emulation.setDeviceMetricsOverride", {
    width: Math.max(1, Math.ceil(width - 1e-6)),
    height: Math.max(1, Math.ceil(height - 1e-6)),
    deviceScaleFactor: scale,
    mobile: false,
  });

async function draw(page, session, { svg, png, picture }) {
  const [width, height] = sizeOf(png);
  await show(session, width, height, 1);
  await page.goto(pathToFileURL(resolve(svg)).href);
  const scale = width / ((await page.evaluate(drawingWidth)) ?? width);
  await show(session, width / scale, height / scale, scale);
  const { data } = await session.send("Page.captureScreenshot", { format: "png" });
  mkdirSync(dirname(picture), { recursive: true });
  writeFileSync(picture, Buffer.from(data, "base64"));
}

const browser = await launchWith(chromium, SWIFTSHADER);
const page = await browser.newPage();
const session = await page.context().newCDPSession(page);
for (const file of folders.flatMap(filesOf)) {
  if (!existsSync(file.picture)) await draw(page, session, file);
}
await browser.close();
