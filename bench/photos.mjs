#!/usr/bin/env node
// Traces the pictures of examples/photos by Sfumato, vtracer and potrace, and prints a Markdown table.
//
//   node bench/photos.mjs [--packages build/vtracer] [--sfumato build/sfumato]
//
// PSNR is computed on sRGB code values of the drawing, which rsvg-convert draws for vtracer and potrace. Needs
// rsvg-convert, potrace, netpbm and the npm package @neplex/vectorizer: `bench/report --install`. Exit 77 if one is
// missing.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { ROOT, SETTINGS, isThere, loadVectorizer, picturesOf, pngOf, psnr, run, samplesOfPng,
  traceBySfumato, traceByVtracer } from "./pictures.mjs";

const SKIPPED = 77;
const POINTS = [300, 2000];
const SPECKLES = [64, 11, 4];

/** Returns potrace's result for a PNG. Netpbm makes it grey; potrace blackens the dark pixels. */
function traceByPotrace(png, picture) {
  const grey = run("ppmtopgm", [], run("pngtopnm", [], png));
  const [, width, height] = /^P5\s+(\d+)\s+(\d+)\s/.exec(grey.toString("latin1", 0, 100));
  const begin = process.hrtime.bigint();
  const svg = run("potrace", ["--svg", "--output", "-", "-"], grey);
  const seconds = Number(process.hrtime.bigint() - begin) / 1e9;
  const drawn = run("rsvg-convert", ["--width", width, "--height", height], svg);
  return { bytes: svg.length, db: psnr(samplesOfPng(drawn), picture), seconds };
}

const row = (...cells) => console.log(`| ${cells.join(" | ")} |`);

function printTraces(path, vectorizer, options, folder) {
  const png = pngOf(path);
  const picture = samplesOfPng(png);
  const print = (program, { seconds, bytes, db }) => row(basename(path), program,
    seconds.toFixed(2), (bytes / 1000).toFixed(0), db.toFixed(1));
  for (const points of POINTS) {
    print(`\`sfumato trace --points ${points}\``,
      traceBySfumato(options.sfumato, png, picture, points, folder));
  }
  for (const setting of SETTINGS.filter((one) => SPECKLES.includes(one.filterSpeckle))) {
    print(`vtracer, filterSpeckle ${setting.filterSpeckle}`,
      traceByVtracer(vectorizer, png, picture, setting));
  }
  print("potrace, black and white", traceByPotrace(png, picture));
}

const { values: options } = parseArgs({ options: {
  packages: { type: "string", default: join(ROOT, "build/vtracer") },
  sfumato: { type: "string", default: join(ROOT, "build/sfumato") } } });
const vectorizer = loadVectorizer(options.packages);
if (!vectorizer) process.exit(SKIPPED);
if (!isThere("potrace")) {
  console.error("photos: no potrace; bench/report --install installs it");
  process.exit(SKIPPED);
}
const potraceVersion = /\d+\.\d+/.exec(run("potrace", ["--version"]).toString())[0];
console.log(`vtracer is the npm package @neplex/vectorizer 0.1.0; potrace ${potraceVersion}.\n`);
console.log("| picture | program | s | kB | dB |\n|---|---|---|---|---|");
const folder = mkdtempSync(join(tmpdir(), "sfumato-photos-"));
try {
  for (const path of picturesOf(join(ROOT, "examples/photos"))) {
    printTraces(path, vectorizer, options, folder);
  }
} finally {
  rmSync(folder, { recursive: true });
}
