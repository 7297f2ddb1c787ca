// Pictures and traces, for the benchmark scripts of this folder.
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = fileURLToPath(new URL("..", import.meta.url));

/**
 * From few large shapes to many small ones. Leaving out small shapes costs photos least: at equal bytes it is up to
 * 8 dB better than fewer colours or coarser layers. Decimals in paths of large shapes only add bytes.
 */
export const SETTINGS = [256, 128, 64, 32, 16, 11, 8, 6, 4, 2].map((filterSpeckle) => ({
  filterSpeckle, colorPrecision: 8, layerDifference: filterSpeckle > 2 ? 8 : 3,
  pathPrecision: filterSpeckle > 4 ? 0 : 1 }));
const SHAPES = { colorMode: 0, hierarchical: 0, mode: 2, cornerThreshold: 60, lengthThreshold: 4,
  maxIterations: 10, spliceThreshold: 45 };

export const run = (command, args, input) => execFileSync(command, args,
  { input, maxBuffer: 1e9, stdio: ["pipe", "pipe", "ignore"] });

export function isThere(command) {
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
export function samplesOfPng(png) {
  const pixels = run("pngtopnm", ["-mix", "-background=white"], png);
  return samplesOf(pixels[1] === 0x35 ? run("pgmtoppm", ["white"], pixels) : pixels);
}

export function psnr(a, b) {
  if (a.length !== b.length) throw new Error("pictures of two sizes");
  const sum = a.reduce((all, v, i) => all + (v - b[i]) ** 2, 0);
  return 10 * Math.log10(a.length / sum);
}

/** Converts a picture of any kind to PNG. */
export function pngOf(path) {
  const bytes = readFileSync(path);
  return /\.jpe?g$/i.test(path) ? run("pnmtopng", [], run("jpegtopnm", [], bytes)) : bytes;
}

/** Returns vtracer's SVG, its bytes, its PSNR and its seconds for a PNG and one of SETTINGS. */
export function traceByVtracer(vectorizer, png, picture, setting) {
  const begin = process.hrtime.bigint();
  const svg = vectorizer.vectorizeSync(png, { ...SHAPES, ...setting });
  const seconds = Number(process.hrtime.bigint() - begin) / 1e9;
  const drawn = run("rsvg-convert", ["--unlimited"], svg);
  return { bytes: Buffer.byteLength(svg), db: psnr(samplesOfPng(drawn), picture), seconds };
}

/** Returns bytes, PSNR and seconds of `sfumato trace` for a PNG. Files lie in `folder`. */
export function traceBySfumato(sfumato, png, picture, points, folder) {
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

export function picturesOf(folder) {
  if (existsSync(folder)) {
    const names = readdirSync(folder).filter((name) => /\.(png|jpe?g)$/i.test(name)).sort();
    if (names.length) return names.map((name) => join(folder, name));
  }
  console.error(`no pictures in ${folder}`);
  return [];
}

/** Returns the npm package of vtracer; nothing, and the reason on stderr, if a tool is missing. */
export function loadVectorizer(packages) {
  const tools = ["rsvg-convert", "pngtopnm", "pnmtopng", "jpegtopnm"];
  const absent = tools.filter((tool) => !isThere(tool));
  if (absent.length) {
    console.error(`vtracer: skipped, ${absent.join(", ")} not here: bench/report --install`);
    return null;
  }
  try {
    return createRequire(join(resolve(packages), "from-here.js"))("@neplex/vectorizer");
  } catch (error) {
    if (error.code !== "MODULE_NOT_FOUND") throw error;
    console.error("vtracer: skipped, @neplex/vectorizer is not here: bench/report --install");
    return null;
  }
}
