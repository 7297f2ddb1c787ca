// Builds a project with Vite, webpack and esbuild, and checks the resulting pages.
import { copyFileSync, mkdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { launchWith } from "../../../tests/chromium.mjs";
import { Pages } from "../../../tests/viewer/harness.mjs";
import { testElement } from "./element.mjs";
import { testLoads } from "./loads.mjs";
import { testManners } from "./manners.mjs";
import { writeFiles } from "./node.mjs";
import { testPolicies } from "./policies.mjs";
import { checkNear, packageOf, serve } from "./tools.mjs";

const { chromium } = packageOf("playwright-core");

export const launch = () => launchWith(chromium);

/** Builds as a user would who has read only Vite's first page. */
async function buildByVite(project) {
  const { build } = await import(pathToFileURL(packageOf.resolve("vite")));
  const input = ["index.html", "many.html", "print.html", "blank.html"].map((name) => join(project, name));
  await build({ root: project, logLevel: "warn", configFile: false, base: "./", build: { rollupOptions: { input } } });
  return join(project, "dist");
}

async function buildByWebpack(project) {
  const webpack = packageOf("webpack");
  const out = join(project, "webpacked");
  const options = {
    mode: "production", context: project, entry: "./main.js",
    output: { path: out, filename: "bundle.js" }, performance: { hints: false },
  };
  await new Promise((resolve, reject) => {
    webpack(options, (error, stats) => (error || stats.hasErrors() ? reject(error ?? new Error(stats.toString("errors-only"))) : resolve()));
  });
  return out;
}

/** Builds with esbuild, which does not follow `new URL`, by the instructions of docs/npm.md. */
async function buildByEsbuild(project) {
  const { build } = packageOf("esbuild");
  const out = join(project, "esbuilt");
  await build({ entryPoints: [join(project, "esbuild-main.js")], bundle: true, format: "esm", outfile: join(out, "bundle.js"), logLevel: "warning" });
  for (const name of ["worker.js", "sfumato-solver.wasm"]) {
    copyFileSync(createRequire(join(project, "package.json")).resolve(`sfumato/${name}`), join(out, name));
  }
  return out;
}

/** Adds a page with one picture beside a bundle. */
function addPage(project, out) {
  mkdirSync(out, { recursive: true });
  copyFileSync(join(project, "public/halves.svg"), join(out, "halves.svg"));
  copyFileSync(join(project, "style.css"), join(out, "style.css"));
  writeFileSync(join(out, "index.html"), `<!doctype html><html lang="en"><meta charset="utf-8"><title>A bundle</title>
    <link rel="stylesheet" href="style.css"><script type="module" src="bundle.js"></script>
    <sfumato-picture id="first" src="halves.svg" alt="Red above blue"></sfumato-picture>`);
}

/** Returns a pixel of an element's canvas: red, green, blue, alpha. x, y: shares of its size. */
export const pixelOf = (page, id, x, y) =>
  page.evaluate(([name, a, b]) => {
    const canvas = document.getElementById(name).shadowRoot.querySelector("canvas");
    const at = [Math.floor(a * canvas.width), Math.floor(b * canvas.height)];
    return [...canvas.getContext("2d").getImageData(...at, 1, 1).data];
  }, [id, x, y]);

export async function checkPixel(page, id, [x, y], expected) {
  const found = await pixelOf(page, id, x, y);
  expected.forEach((value, i) => checkNear(found[i], value, 10, `channel ${i} of ${id} at ${x}, ${y} (${found})`));
}

/** A message of Chromium about slow reads of pixels; the page is not its cause. */
const harmless = /GPU stall due to ReadPixels|Multiple readback operations/;

/** Opens an address, and fails if the page reports errors that are not in `expected`. */
export const visit = (pages, address, { expected, ...options }, body) =>
  pages.visit(address, {
    size: [1000, 800],
    ratio: 0.5,
    harmless: expected ? new RegExp(`${harmless.source}|${expected.source}`) : harmless,
    ...options,
  }, body);

async function testOneBuild(tap, pages, name, project, make) {
  await tap.test(`npm: ${name} builds a page that draws`, async () => {
    const out = await make(project);
    addPage(project, out);
    const { address, close } = await serve(out);
    try {
      await visit(pages, address, {}, async (page) => {
        await page.evaluate(() => document.getElementById("first").ready);
        await checkPixel(page, "first", [0.5, 0.1], [255, 0, 0, 255]);
      });
    } finally {
      close();
    }
  });
}

export async function testBuilds(tap, project, folder) {
  await writeFiles(project, join(project, "public"));
  let site = null;
  await tap.test("npm: an empty project of Vite's takes the package as it is", async () => {
    site = await buildByVite(project);
  });
  const browser = await launch();
  const pages = new Pages(browser);
  try {
    if (site) {
      const server = await serve(site);
      await testElement(tap, pages, server.address, folder);
      await testManners(tap, pages, server.address);
      await testLoads(tap, pages, server.address, site);
      server.close();
    }
    await testPolicies(tap, browser, project);
    await testOneBuild(tap, pages, "webpack", project, buildByWebpack);
    await testOneBuild(tap, pages, "esbuild", project, buildByEsbuild);
  } finally {
    await browser.close();
  }
}
