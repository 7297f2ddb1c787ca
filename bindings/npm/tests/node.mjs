// Tests the package in Node, as installed in a project.
import { spawnSync } from "node:child_process";
import { copyFileSync, cpSync, existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { deflateSync, gzipSync } from "node:zlib";
import { check, checkEqual, checkNear, importOf, packageOf, pathOf, run } from "./tools.mjs";

const halves = () => readFileSync(pathOf("bindings/npm/tests/site/public/halves.svg"), "utf8");

/** Returns the error that a call throws. */
function thrown(body) {
  try {
    body();
  } catch (error) {
    return error;
  }
  throw new Error(`nothing was thrown by ${body}`);
}

async function thrownLater(promise) {
  try {
    await promise;
  } catch (error) {
    return error;
  }
  throw new Error("nothing was thrown");
}

/** Sizes that a change must not exceed, bytes. docs/npm.md lists the present ones. */
const limits = { tarball: 1_430_000, element: 8_000, drawing: 28_500, worker: 8_000, solver: 405_000 };

async function testSizes(tap, project, tarball) {
  await tap.test("npm: what a page fetches and what is installed stay small", () => {
    const packed = (name) => gzipSync(readFileSync(join(project, "node_modules/sfumato", name)), { level: 9 }).length;
    const sizes = {
      tarball: statSync(tarball).size,
      element: packed("element.js"),
      drawing: packed("drawing.js"),
      worker: packed("worker.js"),
      solver: packed("sfumato-solver.wasm"),
    };
    for (const [name, size] of Object.entries(sizes)) console.log(`# ${name}: ${size} bytes${name === "tarball" ? "" : " gz"}`);
    for (const [name, size] of Object.entries(sizes)) check(size <= limits[name], `${name}: ${size} > ${limits[name]}`);
  });
  await tap.test("npm: the solver's module holds no reader of ordinary SVG", () => {
    const holds = (name) => readFileSync(join(project, "node_modules/sfumato", name)).includes("is not for readers of English");
    checkEqual([holds("sfumato.wasm"), holds("sfumato-solver.wasm")], [true, false], "who has a message of the import");
  });
  await tap.test("npm: the package holds what it names and nothing else", () => {
    const names = run(project, "tar", "--list", "--file", tarball).trim().split("\n").map((name) => name.replace("package/", ""));
    const expected = ["LICENSE", "README.md", "drawing.js", "element.d.ts", "element.js", "error.js", "index.d.ts", "index.js",
      "library.js", "licences.txt", "node.js", "package.json", "sfumato-solver.wasm", "sfumato.wasm", "worker.js"];
    checkEqual(names.sort(), expected, "its files");
  });
}

async function testDrawing(tap, { read, importSvg, create, load, Side, Attribute, Kind, Status, SfumatoError }) {
  await tap.test("npm: node reads, solves, rasters, exports and writes", async () => {
    const drawing = await read(halves(), { name: "halves.svg" });
    checkEqual([drawing.artboard, drawing.layerCount, drawing.curveCount(0)], [[0, 0, 300, 200], 1, 1], "the document");
    const picture = drawing.solve();
    const { width, height, data } = picture.raster({ width: 150 });
    checkEqual([width, height, data.length], [150, 100, 60000], "the size that fits");
    const corners = [...data.subarray(0, 4), ...data.subarray(-4)];
    [255, 0, 0, 255, 0, 0, 255, 255].forEach((value, i) => checkNear(corners[i], value, 8, `channel ${i}`));
    checkEqual(picture.raster({ height: 10 }).width, 15, "the width that fits");
    const starts = { png: "\x89PNG", svg: "<svg", pdf: "%PDF", eps: "%!PS", glb: "glTF", html: "<!do" };
    for (const [format, start] of Object.entries(starts)) {
      const file = picture.export(format);
      checkEqual(Buffer.from(file.subarray(0, 4)).toString("latin1").toLowerCase(), start.toLowerCase(), format);
    }
    check(drawing.write().includes("sf:left"), "no SVG is written");
    checkEqual(Buffer.from(picture.viewerPayload().subarray(0, 7)).toString(), "SFUMATO", "the payload");
  });
  await tap.test("npm: an ordinary SVG is imported, and what is left out is named", async () => {
    const text = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 30 20"><rect x="5" y="5" width="20" height="10"
      fill="#c04030"/><text x="1" y="1">left out</text></svg>`;
    const { drawing, warnings } = await importSvg(text, { name: "box.svg" });
    checkEqual([drawing.layerCount, drawing.curveCount(0), warnings.length], [1, 1, 1], "the drawing");
    check(warnings[0].startsWith("box.svg:2:"), warnings[0]);
    const { data } = drawing.solve().raster({ width: 30, background: "#fff", dither: false });
    checkEqual([...data.subarray(4 * (10 * 30 + 15), 4 * (10 * 30 + 15) + 3)], [0xc0, 0x40, 0x30], "the inside");
  });
  await tap.test("npm: regions are combined", async () => {
    const context = (await load()).context();
    const [square, other] = ["M0 0H10V10H0Z", "M5 5H15V15H5Z"];
    const cut = context.combinePaths("subtract", square, other, 0.01);
    check(/^M.*5 5.*Z$/.test(cut) && !cut.includes("15"), cut);
    checkEqual(context.combinePaths("intersect", square, "M20 20H30V30Z", 0.01), "", "nothing");
    checkEqual(thrown(() => context.combinePaths("union", square, other, 0.01)).code, Status.badUsage, "the error");
  });
  await tap.test("npm: a pattern of shapes is drawn where it is imported", async () => {
    const text = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 30 20"><pattern id="p" width="4" height="4"
      patternUnits="userSpaceOnUse"><rect width="2" height="4" fill="#08f"/></pattern><rect width="24" height="16"
      fill="url(#p)"/></svg>`;
    const { drawing, warnings } = await importSvg(text);
    checkEqual(warnings.length, 1, "warnings");
    check(JSON.stringify(warnings).includes("becomes a texture"), "the warning names no texture");
    const { data } = drawing.solve().raster({ width: 30, background: "#fff", dither: false });
    const pixel = (x, y) => [...data.subarray(4 * (y * 30 + x), 4 * (y * 30 + x) + 3)];
    checkEqual([pixel(9, 9), pixel(11, 9)], [[0, 0x88, 0xff], [255, 255, 255]], "the pattern's stripes");
  });
  await tap.test("npm: what was written is read as the same drawing", async () => {
    const drawing = await create(40, 30, { background: "#102030" });
    drawing.insertCurve(0, null, [-5, 15, 10, 15, 30, 15, 45, 15]);
    drawing.setStops(0, 0, Side.left, Attribute.color, { kind: Kind.stops, rows: [[0, 0, 1, 0]] });
    const again = await read(drawing.write());
    const [a, b] = [drawing, again].map((document) => document.solve().raster({ width: 40 }).data.toString());
    check(a === b, "the pixels differ");
    check(a.includes("0,255,0,255"), "there is no green");
  });
  await tap.test("npm: errors have code, reason and place", async () => {
    const broken = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">\n  <g>\n</svg>';
    const error = await thrownLater(read(broken, { name: "a.svg" }));
    check(error instanceof SfumatoError && error instanceof Error, `a ${error?.name}`);
    checkEqual([error.name, error.code, error.file, error.line], ["SfumatoError", Status.badInput, "a.svg", 3], "the error");
    check(error.message.startsWith("a.svg:3:") && error.message.endsWith(error.reason), error.message);
    const drawing = await read(halves());
    const misspelt = thrown(() => drawing.solve({ maxEror: 1 }));
    check(misspelt.code === Status.badUsage && misspelt.reason.includes("max-error"), misspelt.message);
    const jpeg = thrown(() => drawing.solve().export("jpg"));
    check(jpeg.code === Status.unavailable, jpeg.message);
  });
  await tap.test("npm: what is freed or of the wrong type is an error of JavaScript", async () => {
    const drawing = await read(halves());
    const picture = drawing.solve();
    const context = (await load()).context();
    const wrong = {
      TypeError: [
        () => drawing.points(-1, 0), () => drawing.points("0", 0), () => drawing.setPoints(0, 0, 5),
        () => drawing.solve(5), () => picture.raster({ width: "9" }), () => picture.raster({ width: NaN }),
        () => context.solve(picture), () => context.solve({}), () => context.read(5), () => context.raster(drawing, { width: 1, height: 1 }),
        () => context.addImage("file", null), () => picture.table(0, undefined),
      ],
      RangeError: [() => picture.raster({ width: 0 }), () => picture.raster({ width: 1.5 }), () => context.raster(picture, { width: 1, height: 1, format: "cmyk" })],
      SfumatoError: [() => drawing.points(0, 99), () => picture.raster({ width: 65536, height: 65536 }), () => picture.raster({ width: 1e9 })],
    };
    for (const [name, bodies] of Object.entries(wrong)) {
      for (const body of bodies) checkEqual(thrown(body).name, name, String(body));
    }
    checkEqual((await thrownLater(read(null))).name, "TypeError", "read(null)");
    checkEqual((await thrownLater(create(0, 5))).name, "TypeError", "create(0, 5)");
    drawing.free();
    drawing.free();
    checkEqual(thrown(() => drawing.solve()).code, Status.badUsage, "a freed drawing");
    checkEqual(picture.raster({ width: 3 }).width, 3, "its picture");
    context.free();
    checkEqual(thrown(() => context.read(halves())).code, Status.badUsage, "a freed context");
  });
  await tap.test("npm: limits hold, and a module without memory is loaded anew", async () => {
    const sfumato = await load();
    const context = sfumato.context({ maxMemory: 1 });
    const error = thrown(() => context.raster(context.solve(context.read(halves())), { width: 4000, height: 4000 }));
    check([Status.limit, Status.outOfMemory].includes(error.code), error.message);
    check(!sfumato.isBroken, "the module is broken");
    checkEqual((await load()) === sfumato, true, "the module is shared");
  });
  await tap.test("npm: what nobody holds is given back by the collector", async () => {
    if (!globalThis.gc) throw new Error("run node with --expose-gc");
    const drawing = await read(halves());
    const sfumato = await load();
    drawing.solve({ width: 2000 });
    const before = sfumato.memoryBytes;
    for (let i = 0; i < 300; ++i) {
      drawing.solve();
      if (i % 20 === 19) {
        globalThis.gc();
        await new Promise((resolve) => setTimeout(resolve, 5));
      }
    }
    const grown = sfumato.memoryBytes - before;
    check(grown < 4e6, `the memory has grown by ${grown} bytes`);
  });
}

/** Bundles a program that reads a drawing, and runs it: what it says. */
function bundled(project, format, name) {
  const file = join(project, name);
  packageOf("esbuild").buildSync({
    stdin: { contents: 'import { read } from "sfumato"; read("<svg").catch((error) => console.log(error.name, error.message));', resolveDir: project },
    bundle: true, format, platform: "node", outfile: file, logLevel: "error",
  });
  return (folder) => run(folder, process.execPath, file).trim();
}

async function testSources(tap, project, { read }) {
  await tap.test("npm: a drawing is text, bytes, a buffer or a file, and keeps its warnings", async () => {
    const bytes = new TextEncoder().encode(halves());
    for (const drawing of [halves(), bytes, bytes.buffer, new DataView(bytes.buffer), new Blob([bytes]), Buffer.from(bytes)]) {
      const { layerCount, warnings } = await read(drawing);
      checkEqual([layerCount, warnings], [1, []], String(drawing));
    }
    const ordinary = await read('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><circle r="3"/></svg>', { name: "a.svg" });
    check(ordinary.warnings.length > 1 && ordinary.copy().warnings.some((words) => words.includes("the picture is empty")), JSON.stringify(ordinary.warnings));
  });
  await tap.test("npm: a bundler's own class URL is an address", () => {
    const text = `import { load } from "sfumato"; import { createRequire } from "node:module"; import { pathToFileURL } from "node:url";
      const { href } = pathToFileURL(createRequire(import.meta.url).resolve("sfumato/sfumato.wasm"));
      console.log((await load({ href })).abi > 0);`;
    writeFileSync(join(project, "address.mjs"), text);
    checkEqual(run(project, process.execPath, "address.mjs").trim(), "true", "load");
  });
  await tap.test("npm: bundles for node find the module in node_modules, or say what to do", () => {
    for (const [format, name] of [["esm", "bundle.mjs"], ["cjs", "bundle.cjs"]]) {
      const said = bundled(project, format, join("bundles", name));
      check(/^SfumatoError .*\d/.test(said(project)), `${name}: ${said(project)}`);
      const elsewhere = said(tmpdir());
      check(/sfumato\.wasm is not there: copy it .* load\(path\)/.test(elsewhere), `${name}: ${elsewhere}`);
    }
  });
}

/** Returns the public member names of a class or an interface in a .d.ts file. */
function declared(text, name) {
  const body = new RegExp(`export class ${name} [^{]*\\{([^]*?)\\n\\}`).exec(text)?.[1] ?? "";
  return new Set([...body.matchAll(/^ {2}(?:readonly |get |set )?(\w+)[(:?]/gm)].map(([, found]) => found));
}

async function testTypes(tap, project, library) {
  await tap.test("npm: tsc --strict takes the types", () => {
    copyFileSync(pathOf("bindings/npm/tests/typed_use.ts"), join(project, "typed_use.ts"));
    const options = { strict: true, noEmit: true, target: "es2022", module: "nodenext", lib: ["es2022", "dom"], types: [], skipLibCheck: false };
    writeFileSync(join(project, "tsconfig.json"), JSON.stringify({ compilerOptions: options, files: ["typed_use.ts"] }));
    run(project, process.execPath, pathOf("bindings/npm/tests/node_modules/typescript/bin/tsc"), "-p", "tsconfig.json");
  });
  await tap.test("npm: React's TSX and `using` know the types, and `read` needs no DOM", () => {
    const react = join(project, "node_modules/react");
    mkdirSync(react, { recursive: true });
    writeFileSync(join(react, "package.json"), JSON.stringify({ name: "react", types: "index.d.ts", exports: { ".": "./index.d.ts", "./jsx-runtime": "./jsx-runtime.d.ts" } }));
    // The parts of @types/react 19 that matter here.
    writeFileSync(join(react, "index.d.ts"), `export = React; export as namespace React; declare namespace React {
      interface HTMLAttributes<T> { id?: string } type DetailedHTMLProps<E, T> = E & { ref?: T };
      namespace JSX { interface Element {} interface IntrinsicElements { p: {} } } }`);
    writeFileSync(join(react, "jsx-runtime.d.ts"), `import * as React from "./"; export namespace JSX { interface Element extends React.JSX.Element {}
      interface IntrinsicElements extends React.JSX.IntrinsicElements {} } export function jsx(): React.JSX.Element;`);
    writeFileSync(join(project, "page.tsx"), `import "sfumato/element";
      export const page = <sfumato-picture id="a" src="a.svg" interactive max-error={2} onerror={({ error }) => console.log(error)} />;`);
    writeFileSync(join(project, "using.ts"), `import { create } from "sfumato";
      export async function count(): Promise<number> { using drawing = await create(3, 3); return drawing.layerCount; }`);
    writeFileSync(join(project, "server.ts"), 'import { read, load } from "sfumato"; export const a = [read(new ArrayBuffer(3)), load("a")];');
    const compile = (file, ...more) => run(project, process.execPath, pathOf("bindings/npm/tests/node_modules/typescript/bin/tsc"), "--ignoreConfig",
      "--strict", "--noEmit", "--module", "nodenext", "--target", "es2022", "--types", "", ...more, file);
    compile("page.tsx", "--lib", "es2022,dom", "--jsx", "react-jsx");
    compile("using.ts", "--lib", "esnext,dom");
    compile("server.ts", "--lib", "es2022");
    rmSync(react, { recursive: true });
  });
  await tap.test("npm: the element's own types are right", () => {
    const compiler = pathOf("bindings/npm/tests/node_modules/typescript/bin/tsc");
    const { stdout } = spawnSync(process.execPath, [compiler, "-p", pathOf("bindings/npm/tests")], { encoding: "utf8" });
    // The JavaScript of web/wasm has no complete types; index.d.ts declares the types of the package.
    const own = stdout.split("\n").filter((line) => /bindings\/npm\/src|^src|^\.\.\/src|TS18003/.test(line));
    checkEqual(own, [], "complaints");
  });
  await tap.test("npm: types name what is there", () => {
    const text = readFileSync(pathOf("bindings/npm/src/index.d.ts"), "utf8");
    const exported = [...text.matchAll(/^export (?:class|const|function) (\w+)/gm)].map(([, name]) => name);
    checkEqual(exported.sort(), Object.keys(library).sort(), "what is exported");
    for (const name of ["Sfumato", "SfumatoContext", "SfumatoDocument", "SfumatoPicture", "SfumatoField"]) {
      const inherited = ["constructor", "library", "address"];
      const internal = ["run", "make", "progressed", "traced", "loaded", "trace", "fitColors"];
      const here = Object.getOwnPropertyNames(library[name].prototype).filter((key) => ![...inherited, ...internal].includes(key));
      const told = declared(text, name);
      for (const key of here) check(told.has(key), `${name}.${key} has no type`);
      const all = new Set([...here, ...inherited, "free", "onProgress"]);
      for (const key of told) check(all.has(key), `${name}.${key} is not there`);
    }
  });
}

export async function testNode(tap, project, tarball) {
  await testSizes(tap, project, tarball);
  const library = await importOf(project, "sfumato");
  await testDrawing(tap, library);
  await testSources(tap, project, library);
  await testTypes(tap, project, library);
  await tap.test("npm: the element can be imported where there is no page", () => {
    const text = 'import { SfumatoPicture } from "sfumato/element"; console.log(typeof SfumatoPicture, typeof window);';
    checkEqual(run(project, process.execPath, "--input-type=module", "--eval", text).trim(), "function undefined", "what it says");
  });
  await tap.test("npm: the programs of its documents run", async () => {
    cpSync(pathOf("bindings/npm/tests/example.mjs"), join(project, "example.mjs"));
    writeFileSync(join(project, "drawing.svg"), halves());
    const text = `import * as e from "./example.mjs"; const { width, height } = await e.convert();
      await e.prepare();
      console.log(width, height, (await e.draw()).includes("sf:left"), await e.complain("<svg>\\n<"));`;
    const said = run(project, process.execPath, "--input-type=module", "--eval", text);
    check(/^600 400 true line \d+: ./.test(said), said);
    for (const name of ["drawing.pdf", "drawing.png", "drawing.sfv"]) check(existsSync(join(project, name)), `no ${name}`);
  });
}

/** Writes files that need the library: the payload that the page shows without a solver, and others. */
export async function writeFiles(project, folder) {
  const { read } = await importOf(project, "sfumato");
  const payload = (await read(halves())).solve().viewerPayload();
  writeFileSync(join(folder, "halves.sfv"), payload);
  writeFileSync(join(folder, "packed.sfv"), deflateSync(payload));
  writeFileSync(join(folder, "cut.sfv"), payload.subarray(0, payload.length - 9));
  writeFileSync(join(folder, "halves.svgz"), gzipSync(halves()));
  // A background, and a layer through which it shows.
  const clear = halves().replace("<svg ", '<svg sf:background="#00ff00" ').replace("sf:left", 'sf:opacity="0" sf:left');
  writeFileSync(join(folder, "clear.svg"), clear);
  const textured = readFileSync(join(folder, "textured.svg"), "utf8");
  writeFileSync(join(folder, "untextured.svg"), textured.replace(/href="[^"]*"/, 'href="gone.png"'));
}

