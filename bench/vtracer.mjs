#!/usr/bin/env node
// Compares traces with vtracer's for the same pictures, at equal bytes and at equal PSNR, as Markdown.
//
//   npm install --prefix build/vtracer @neplex/vectorizer@0.1.0
//   node bench/vtracer.mjs [--packages build/vtracer] [--sfumato build/sfumato]
//        [--points N,N...] [--theirs-alone] [PICTURE]...
//
// Without pictures: the pictures of examples/photos and of ../shared/photos, if present. @neplex/vectorizer is
// vtracer as an npm package; without it nothing is measured, stderr reports that, and the exit code is 0. It has
// ten settings, from coarse to fine. rsvg-convert draws its drawings and `sfumato render` ours, with 16 bits;
// netpbm reads all pictures (`scripts/setup viewers gallery`). Bytes count the SVG; PSNR is computed on sRGB code
// values.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";

const ROOT = fileURLToPath(new URL("..", import.meta.url));
const FOLDERS = [join(ROOT, "examples/photos"), join(ROOT, "../shared/photos")];

/**
 * From few large shapes to many small ones. Leaving out small shapes costs photos least: at equal bytes it is up to
 * 8 dB better than fewer colours or coarser layers. Decimals in paths of large shapes only add bytes.
 */
const SETTINGS = [256, 128, 64, 32, 16, 11, 8, 6, 4, 2].map((filterSpeckle) => ({ filterSpeckle,
  colorPrecision: 8, layerDifference: filterSpeckle > 2 ? 8 : 3,
  pathPrecision: filterSpeckle > 4 ? 0 : 1 }));
const SHAPES = { colorMode: 0, hierarchical: 0, mode: 2, cornerThreshold: 60, lengthThreshold: 4,
  maxIterations: 10, spliceThreshold: 45 };

const run = (command, args, input) => execFileSync(command, args,
  { input, maxBuffer: 1e9, stdio: ["pipe", "pipe", "ignore"] });

function isThere(command) {
  try {
    run(command, ["--version"]);
    return true;
  } catch (error) {
    return error.code !== "ENOENT";
  }
}

/** Returns the samples of a PPM of 8 or 16 bits, from 0 to 1. */
function samplesOf(ppm) {
  const [head, width, height, most] = /^P6\s+(\d+)\s+(\d+)\s+(\d+)\s/.exec(
    ppm.toString("latin1", 0, 100));
  const count = 3 * width * height;
  const bytes = ppm.subarray(head.length);
  const samples = new Float64Array(count);
  for (let i = 0; i < count; ++i) {
    samples[i] = (most > 255 ? bytes.readUInt16BE(2 * i) : bytes[i]) / most;
  }
  return samples;
}

/** Returns the samples of a PNG on white. pngtopnm writes a grey picture as PGM. */
function samplesOfPng(png) {
  const pixels = run("pngtopnm", ["-mix", "-background=white"], png);
  return samplesOf(pixels[1] === 0x35 ? run("pgmtoppm", ["white"], pixels) : pixels);
}

function psnr(a, b) {
  if (a.length !== b.length) throw new Error("pictures of two sizes");
  const sum = a.reduce((all, v, i) => all + (v - b[i]) ** 2, 0);
  return 10 * Math.log10(a.length / sum);
}

/** Converts a picture of any kind to PNG. */
function pngOf(path) {
  const bytes = readFileSync(path);
  return /\.jpe?g$/i.test(path) ? run("pnmtopng", [], run("jpegtopnm", [], bytes)) : bytes;
}

function theirs(vectorizer, png, picture) {
  return SETTINGS.map((setting) => {
    const begin = process.hrtime.bigint();
    const svg = vectorizer.vectorizeSync(png, { ...SHAPES, ...setting });
    const seconds = Number(process.hrtime.bigint() - begin) / 1e9;
    const drawn = run("rsvg-convert", ["--unlimited"], svg);
    return { bytes: Buffer.byteLength(svg), db: psnr(samplesOfPng(drawn), picture), seconds };
  });
}

function ours(sfumato, png, picture, points, folder) {
  const [input, drawing, drawn] = ["in.png", "out.svg", "out.png"]
    .map((name) => join(folder, name));
  writeFileSync(input, png);
  const begin = process.hrtime.bigint();
  run(sfumato, ["trace", input, "-o", drawing, "--points", String(points), "--quiet"]);
  const seconds = Number(process.hrtime.bigint() - begin) / 1e9;
  run(sfumato, ["render", drawing, "-o", drawn, "--depth", "16", "--quiet"]);
  const db = psnr(samplesOfPng(readFileSync(drawn)), picture);
  return { points, bytes: readFileSync(drawing).length, db, seconds };
}

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
  const results = theirs(vectorizer, png, picture);
  console.log(`\n### ${basename(path)}\n`);
  console.log("| vtracer, filterSpeckle | kB | dB | s |\n|---|---|---|---|");
  results.forEach((one, i) => row(SETTINGS[i].filterSpeckle, kilobytes(one), decibels(one),
    one.seconds.toFixed(2)));
  if (options["theirs-alone"]) return;
  console.log("\n| points | ours, kB | ours, dB | s | vtracer at these kB, dB | " +
    "vtracer at these dB, kB |\n|---|---|---|---|---|---|");
  for (const points of options.points.split(",")) {
    const one = ours(options.sfumato, png, picture, points, folder);
    row(points, kilobytes(one), decibels(one), one.seconds.toFixed(2), atBytes(results, one.bytes),
      atDecibels(results, one.db));
  }
}

function picturesOf(folder) {
  if (existsSync(folder)) {
    const names = readdirSync(folder).filter((name) => /\.(png|jpe?g)$/i.test(name)).sort();
    if (names.length) return names.map((name) => join(folder, name));
  }
  console.error(`vtracer: no pictures in ${folder}`);
  return [];
}

/** Returns the package; without it prints the reason on stderr and returns nothing. */
function loadVectorizer(packages) {
  const tools = ["rsvg-convert", "pngtopnm", "pnmtopng", "jpegtopnm"];
  const absent = tools.filter((tool) => !isThere(tool));
  if (absent.length) {
    console.error(`vtracer: skipped, ${absent.join(", ")} not here: scripts/setup viewers gallery`);
    return null;
  }
  try {
    return createRequire(join(resolve(packages), "from-here.js"))("@neplex/vectorizer");
  } catch (error) {
    if (error.code !== "MODULE_NOT_FOUND") throw error;
    console.error("vtracer: skipped, @neplex/vectorizer is not here: npm install --prefix " +
      `${packages} @neplex/vectorizer@0.1.0`);
    return null;
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
