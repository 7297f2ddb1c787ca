#!/usr/bin/env node
// Compares traces with vtracer's for the same pictures, at equal bytes and at equal PSNR, as Markdown.
//
//   bench/report --install
//   node bench/vtracer.mjs [--packages build/vtracer] [--sfumato build/sfumato]
//        [--points N,N...] [--theirs-alone] [PICTURE]...
//
// Without pictures: the pictures of examples/photos and of ../shared/photos, if present. @neplex/vectorizer is
// vtracer as an npm package; without it nothing is measured, stderr reports that, and the exit code is 0. It has
// ten settings, from coarse to fine. rsvg-convert draws its drawings and `sfumato render` ours, with 16 bits;
// netpbm reads all pictures. Bytes count the SVG; PSNR is computed on sRGB code values.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { ROOT, SETTINGS, loadVectorizer, picturesOf, pngOf, samplesOfPng, traceBySfumato,
  traceByVtracer } from "./pictures.mjs";

const FOLDERS = [join(ROOT, "examples/photos"), join(ROOT, "../shared/photos")];

const row = (...cells) => console.log(`| ${cells.join(" | ")} |`);
const kilobytes = ({ bytes }) => (bytes / 1000).toFixed(0);
const decibels = ({ db }) => db.toFixed(1);

/** Returns vtracer's PSNR at a number of bytes: interpolated between the neighbouring settings, by log bytes. */
function atBytes(results, bytes) {
  const sorted = [...results].sort((a, b) => a.bytes - b.bytes);
  if (bytes < sorted[0].bytes) return `none (least ${kilobytes(sorted[0])} kB)`;
  const above = sorted.findIndex((one) => one.bytes >= bytes);
  if (above < 0) return decibels(sorted.at(-1));
  const [a, b] = [sorted[Math.max(0, above - 1)], sorted[above]];
  const t = a === b ? 0 : Math.log(bytes / a.bytes) / Math.log(b.bytes / a.bytes);
  return (a.db + (b.db - a.db) * t).toFixed(1);
}

/** Returns the fewest bytes of vtracer with at least this PSNR. */
function atDecibels(results, db) {
  const enough = results.filter((one) => one.db >= db).sort((a, b) => a.bytes - b.bytes);
  if (enough.length) return kilobytes(enough[0]);
  return `none (best ${decibels(results.reduce((a, b) => (a.db > b.db ? a : b)))} dB)`;
}

function compare(path, vectorizer, options, folder) {
  const png = pngOf(path);
  const picture = samplesOfPng(png);
  const results = SETTINGS.map((setting) =>
    traceByVtracer(vectorizer, png, picture, setting));
  console.log(`\n### ${basename(path)}\n`);
  console.log("| vtracer, filterSpeckle | kB | dB | s |\n|---|---|---|---|");
  results.forEach((one, i) => row(SETTINGS[i].filterSpeckle, kilobytes(one), decibels(one),
    one.seconds.toFixed(2)));
  if (options["theirs-alone"]) return;
  console.log("\n| points | ours, kB | ours, dB | s | vtracer at these kB, dB | " +
    "vtracer at these dB, kB |\n|---|---|---|---|---|---|");
  for (const points of options.points.split(",")) {
    const one = traceBySfumato(options.sfumato, png, picture, points, folder);
    row(points, kilobytes(one), decibels(one), one.seconds.toFixed(2), atBytes(results, one.bytes),
      atDecibels(results, one.db));
  }
}

const { values: options, positionals } = parseArgs({ allowPositionals: true, options: {
  packages: { type: "string", default: join(ROOT, "build/vtracer") },
  sfumato: { type: "string", default: join(ROOT, "build/sfumato") },
  points: { type: "string", default: "500,1000,2000,4000" },
  "theirs-alone": { type: "boolean", default: false } } });
const vectorizer = loadVectorizer(options.packages);
if (vectorizer) {
  const folder = mkdtempSync(join(tmpdir(), "sfumato-vtracer-"));
  try {
    const pictures = positionals.length ? positionals : FOLDERS.flatMap(picturesOf);
    for (const path of pictures) compare(path, vectorizer, options, folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}
