#!/usr/bin/env node
// Draws SVG files by resvg's npm package, and prints a line of seconds for each: wall clock, then CPU.
//
//   node bench/resvg.mjs PACKAGES WIDTH OUT.png FILE...
//
// PACKAGES is the folder that npm installed @resvg/resvg-js into. Seconds include reading the file and writing
// the PNG, but not the start of Node. A file that resvg does not draw has the line "failed".
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [packages, width, out, ...files] = process.argv.slice(2);
const { Resvg } = createRequire(join(resolve(packages), "from-here.js"))("@resvg/resvg-js");
const options = { fitTo: { mode: "width", value: Number(width) },
  font: { loadSystemFonts: false } };

function draw(file) {
  writeFileSync(out, new Resvg(readFileSync(file), options).render().asPng());
}

function measure(file) {
  const begin = process.hrtime.bigint();
  const before = process.cpuUsage();
  draw(file);
  const { user, system } = process.cpuUsage(before);
  return `${Number(process.hrtime.bigint() - begin) / 1e9} ${(user + system) / 1e6}`;
}

for (const file of files) {
  try {
    console.log(measure(file));
  } catch (error) {
    console.error(`resvg: ${file}: ${error.message ?? error}`);
    console.log("failed");
  }
}
