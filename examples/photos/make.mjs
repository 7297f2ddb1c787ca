#!/usr/bin/env node
// Draws the photos of this folder, which no camera took: still_life.jpg and lake.jpg.
//
//   node examples/photos/make.mjs [--samples N] [--width PIXELS] [--threads N] [--out FOLDER]
//        [NAME]...
//
// The same options make the same files. At 160 samples a pixel, the default, the still life takes
// minutes. pnmtojpeg packs the pictures (`scripts/setup gallery` installs it).
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { Worker, isMainThread, parentPort, workerData } from "node:worker_threads";
import { develop } from "./film.mjs";
import { paintLake } from "./lake.mjs";
import { photograph } from "./light.mjs";
import { stillLife } from "./still_life.mjs";

const HERE = fileURLToPath(import.meta.url);
const BYTES = 150_000;

function rowsOfStillLife({ size, samples, first, stride, shared }) {
  const light = new Float32Array(shared);
  photograph(stillLife, size, samples, (x, y, color) => light.set(color, 3 * (y * size[0] + x)),
    first, stride);
}

async function paintStillLife(size, samples, threads) {
  const shared = new SharedArrayBuffer(12 * size[0] * size[1]);
  await Promise.all(Array.from({ length: threads }, (_, first) => new Promise((done, fail) => {
    const work = { size, samples, first, stride: threads, shared };
    new Worker(HERE, { workerData: work }).on("message", done).on("error", fail);
  })));
  return new Float32Array(shared);
}

const PHOTOS = {
  still_life: { ...stillLife, paint: paintStillLife },
  lake: { size: [640, 480], exposure: 1, grain: 1.3, paint: paintLake },
};

/** The best JPEG below BYTES. */
function packed(ppm) {
  for (let quality = 93; ; quality -= 3) {
    const jpeg = execFileSync("pnmtojpeg", [`-quality=${quality}`, "-optimize", "-sample=1x1"],
      { input: ppm, maxBuffer: 1e8 });
    if (jpeg.length <= BYTES) return jpeg;
  }
}

async function main() {
  const { values, positionals } = parseArgs({ allowPositionals: true, options: {
    samples: { type: "string", default: "160" }, width: { type: "string", default: "640" },
    threads: { type: "string", default: String(availableParallelism()) },
    out: { type: "string", default: dirname(HERE) } } });
  for (const name of positionals.length ? positionals : Object.keys(PHOTOS)) {
    const photo = PHOTOS[name];
    const scale = Number(values.width) / photo.size[0];
    const size = photo.size.map((side) => Math.round(side * scale));
    const light = await photo.paint(size, Number(values.samples), Number(values.threads));
    const jpeg = packed(develop(light, size, photo));
    writeFileSync(join(values.out, `${name}.jpg`), jpeg);
    console.log(`${name}.jpg: ${jpeg.length} bytes`);
  }
}

if (isMainThread) {
  await main();
} else {
  rowsOfStillLife(workerData);
  parentPort.postMessage("done");
}
