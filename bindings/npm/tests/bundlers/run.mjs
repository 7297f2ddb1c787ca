// Installs bundlers and frameworks at fixed versions, and tests the package in each: needs the npm registry.
//   node run.mjs TARBALL FOLDER [NAME…]
import { spawn } from "node:child_process";
import { copyFileSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { launch } from "../builds.mjs";
import { check, checkEqual, pathOf, run, serve, Tap } from "../tools.mjs";

const [tarball, folder, ...names] = process.argv.slice(2);
const tap = new Tap();
const browser = await launch();
const npm = process.platform === "win32" ? "npm.cmd" : "npm";
const page = (script) => `<!doctype html><html lang="en"><meta charset="utf-8"><title>A page</title>
  <script type="module" src="${script}"></script><sfumato-picture src="halves.svg"></sfumato-picture></html>`;
const main = `import "sfumato/element";
  import { read } from "sfumato";
  window.layers = fetch("halves.svg").then((answer) => answer.blob()).then(read).then((drawing) => drawing.layerCount);`;

/** Makes a project with the tarball and packages, and writes its files. */
function project(name, packages, files) {
  const at = resolve(folder, name);
  rmSync(at, { recursive: true, force: true });
  mkdirSync(join(at, "public"), { recursive: true });
  writeFileSync(join(at, "package.json"), JSON.stringify({ private: true, type: "module" }));
  run(at, npm, "install", "--no-audit", "--no-fund", "--ignore-scripts", resolve(tarball), ...packages);
  copyFileSync(pathOf("bindings/npm/tests/site/public/halves.svg"), join(at, "public/halves.svg"));
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(dirname(join(at, path)), { recursive: true });
    writeFileSync(join(at, path), text);
  }
  return at;
}

/** Opens a page, and checks that its element draws and that `read` works. */
async function look(address) {
  const tab = await browser.newPage();
  try {
    await tab.goto(address);
    await tab.waitForFunction(() => window.layers && customElements.get("sfumato-picture"));
    const said = await tab.evaluate(async () => [await document.querySelector("sfumato-picture").ready.then(() => "ready", (error) => error.message), await window.layers]);
    checkEqual(said, ["ready", 1], "the element, and the layers");
  } finally {
    await tab.close();
  }
}

async function lookIn(out) {
  const server = await serve(out);
  try {
    await look(server.address);
  } finally {
    server.close();
  }
}

async function testVite(version) {
  const at = project(`vite-${version}`, [`vite@${version}`], { "index.html": page("./main.js"), "main.js": main });
  const { build, createServer } = await import(pathToFileURL(join(at, "node_modules/vite/dist/node/index.js")));
  const options = { root: at, configFile: false, logLevel: "error" };
  const server = await createServer({ ...options, server: { port: 0, host: "127.0.0.1" } });
  await server.listen();
  await look(server.resolvedUrls.local[0]);
  await server.close();
  await build(options);
  await lookIn(join(at, "dist"));
}

async function testRollup() {
  const text = `${main}\nimport { load } from "sfumato"; import { SfumatoPicture } from "sfumato/element";
    SfumatoPicture.workerUrl = "worker.js";`.replace("window.layers = fetch", 'window.layers = load("sfumato.wasm").then(() => fetch').replace('"halves.svg")', '"halves.svg"))');
  const at = project("rollup", ["rollup@4.68.8", "@rollup/plugin-node-resolve@16.0.3"], { "main.js": text, "out/index.html": page("main.js") });
  const find = createRequire(join(at, "package.json"));
  const { rollup } = find("rollup");
  const { nodeResolve } = find("@rollup/plugin-node-resolve");
  const bundle = await rollup({ input: join(at, "main.js"), plugins: [nodeResolve({ browser: true })] });
  await bundle.write({ dir: join(at, "out"), format: "es" });
  for (const name of ["worker.js", "sfumato-solver.wasm", "sfumato.wasm"]) copyFileSync(find.resolve(`sfumato/${name}`), join(at, "out", name));
  copyFileSync(join(at, "public/halves.svg"), join(at, "out/halves.svg"));
  await lookIn(join(at, "out"));
}

async function testNext() {
  const at = project("next", ["next@15.5.29", "react@19.3.1", "react-dom@19.3.1"], {
    "app/layout.jsx": "export default ({ children }) => <html><body>{children}</body></html>;",
    "app/page.jsx": "export default () => <p>x</p>;",
    "app/draw/route.js": `import { read } from "sfumato"; import { readFile } from "node:fs/promises";
      export const dynamic = "force-dynamic";
      export const GET = () => readFile("public/halves.svg").then(read).then((d) => Response.json(d.layerCount), (e) => Response.json(String(e)));`,
  });
  delete process.env.NODE_ENV; // Vite sets it
  const next = join(at, "node_modules/next/dist/bin/next");
  run(at, process.execPath, next, "build");
  const server = spawn(process.execPath, [next, "start", "--port", "5391"], { cwd: at, stdio: ["ignore", "pipe", "inherit"] });
  try {
    await new Promise((started) => server.stdout.on("data", (text) => /Ready/.test(text) && started()));
    checkEqual(await (await fetch("http://127.0.0.1:5391/draw")).json(), 1, "layers");
  } finally {
    server.kill();
  }
}

function testJsdom() {
  const at = project("jsdom", ["vitest@3.2.7", "jsdom@26.1.0"], {
    "a.test.js": `import { expect, test } from "vitest";
      test("an element", async () => {
        await import("sfumato/element");
        const picture = document.createElement("sfumato-picture");
        picture.src = "a.svg";
        document.body.append(picture);
        expect(picture.getAttribute("role")).toBe("img");
        await expect(picture.ready).rejects.toThrow("in browsers only");
        const { read } = await import("sfumato");
        expect((await read("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'/>")).layerCount).toBe(0);
      });`,
  });
  check(/1 passed/.test(run(at, process.execPath, "node_modules/vitest/vitest.mjs", "run", "--environment", "jsdom")), "the test failed");
}

const all = {
  ...Object.fromEntries(["5.4.21", "6.4.6", "7.3.8"].map((version) => [`vite-${version}`, () => testVite(version)])),
  rollup: testRollup, next: testNext, jsdom: testJsdom,
};
process.env.NEXT_TELEMETRY_DISABLED = "1";
for (const [name, body] of Object.entries(all)) {
  if (names.length === 0 || names.includes(name)) await tap.whole(`bundlers: ${name}`, body);
}
await browser.close();
process.exit(tap.failures > 0 ? 1 : 0);
