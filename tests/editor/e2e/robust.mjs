// Faults around the page: graphics, workers, the module, the network; and actions that the page must never do.
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { copied, drop, paste } from "./disk.mjs";
import { check, checkEqual, EditorPage, newContext, packageOf, serve } from "./harness.mjs";
import { messagesGo } from "./hooks.mjs";
import { example, small } from "./texts.mjs";
import { closeDialog, edit, said, shows } from "./words.mjs";

const { decode } = packageOf("fast-png");
const size = [900, 600];
const status = ({ page }) => page.evaluate(() => window.sfumatoEditor.status);

async function within(browser, address, script, body, options) {
  const context = await newContext(browser, { size: [900, 600], ...options });
  if (script) await context.addInitScript(script);
  const editor = await EditorPage.within(context, address);
  try {
    await body(editor);
  } finally {
    await context.close();
  }
}

/** Returns the share of two pictures' numbers that differ. */
function share(a, b) {
  const [one, two] = [a, b].map((png) => decode(png).data);
  return one.filter((value, i) => value !== two[i]).length / one.length;
}

async function testLostContext(editor) {
  const { page } = editor;
  await editor.load(small);
  const before = await editor.picture();
  await page.evaluate(() => {
    const gl = document.querySelector("canvas.picture").getContext("webgl2");
    window.taken = gl.getExtension("WEBGL_lose_context");
    window.taken.loseContext();
  });
  await said(page, /graphics driver was reset/);
  await edit(editor);
  await editor.key("Control+z");
  await page.evaluate(() => window.taken.restoreContext());
  await page.waitForFunction(() => !document.querySelector("canvas.picture").getContext("webgl2").isContextLost());
  await editor.key("Control+Shift+a");
  await messagesGo(page);
  await page.waitForFunction(() => !document.querySelector(".toast"));
  // The focus ring may lie above it.
  const others = share(before, await editor.picture());
  check(others < 0.02, `${(100 * others).toFixed(1)} % of the picture differ after the graphics came back`);
}

/** Without graphics or engine, the text can still be edited and saved. */
async function testWithout(editor, kind, pattern) {
  await editor.load(small);
  await editor.page.waitForFunction((wanted) => window.sfumatoEditor.status.kind === wanted, kind);
  if (kind === "failed") check(pattern.test((await status(editor)).reason), `the reason: ${(await status(editor)).reason}`);
  else await said(editor.page, pattern);
  await edit(editor);
  await editor.key("Control+z");
  await shows(editor.page, small);
}

const noWebGl = () => {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (name, ...given) {
    return name === "webgl2" ? null : getContext.call(this, name, ...given);
  };
};
const noWebAssembly = () => delete window.WebAssembly;
const noWorker = () => {
  window.Worker = class {
    constructor() {
      throw new DOMException("refused", "SecurityError");
    }
  };
};
const brokenWorker = () => {
  window.Worker = class {
    constructor() {
      setTimeout(() => this.onerror?.({ message: "" }));
    }
    postMessage() {}
    terminate() {}
  };
};

/** More than the engine's memory holds: a message appears, and the next drawing is drawn. */
async function testHuge(editor) {
  const curves = Array.from({ length: 40000 }, (_, i) => `<path d="M${i % 200},${i / 200} c1,2 3,4 5,${i % 7}" sf:left="#fff" sf:right="#000"/>`);
  const huge = small.replace(/<path[^]*?\/>/, curves.join("\n"));
  await editor.page.evaluate((text) => window.sfumatoEditor.open(text.replace("#fff", "salmonish"), "huge.svg"), huge);
  await editor.page.waitForFunction(() => window.sfumatoEditor.status.kind === "problem");
  await editor.load(small);
  checkEqual((await status(editor)).kind, "exact", "the next picture");
  editor.checkQuiet();
}

/** A whole session; requests to other servers and violations of the page's policy are recorded. */
async function testSession(editor) {
  const { page } = editor;
  for (const command of ["?", "Control+e", "Control+n"]) {
    await page.keyboard.press(command);
    if (await page.locator("dialog[open]").count()) await page.keyboard.press("Escape");
  }
  await drop(page, [{ name: "textures.svg", bytes: Buffer.from(example("textures.svg")) }, ...["wood.png", "waves.png", "hemp.png"].map((name) => ({ name, bytes: readFileSync(new URL(`../../../examples/${name}`, import.meta.url)) }))]);
  await shows(page, example("textures.svg"));
  await editor.load(small);
  await edit(editor);
  for (const key of ["v", "a", "p", "b", "k", "i", "u", "h", "m", "o", "F8", "1", "2", "3"]) await page.keyboard.press(key);
  for (const key of ["Control+e", "Control+n", "?"]) {
    await page.keyboard.press(key);
    await page.locator("dialog[open]").waitFor();
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => !document.querySelector("dialog[open]"));
  }
  const remote = small.replace("</svg>", '<image href="https://example.org/a.png" width="9" height="9"/></svg>');
  await drop(page, [{ name: "remote.svg", bytes: Buffer.from(remote) }]);
  await shows(page, remote);
  checkEqual(await page.evaluate(() => window.violations), [], "violations of the page's policy");
  editor.checkQuiet();
}

const listen = () => {
  window.violations = [];
  addEventListener("securitypolicyviolation", (event) => window.violations.push(`${event.violatedDirective} ${event.blockedURI}`));
};

/** From a folder below the origin, and then without any network; an update is complete. */
async function testOffline(browser, folder, host) {
  const root = mkdtempSync(join(tmpdir(), "sfumato-site-"));
  const below = join(root, "art/editor");
  cpSync(join(folder, "editor"), below, { recursive: true });
  const server = await serve(root);
  const address = `${server.address.replace("127.0.0.1", host)}art/editor/`;
  const context = await newContext(browser, { size: [900, 600], serviceWorkers: "allow" });
  const opened = async () => {
    const editor = await EditorPage.within(context, address);
    await editor.load(small);
    checkEqual((await status(editor)).kind, "exact", "the picture");
    editor.checkQuiet();
    return editor;
  };
  try {
    const first = await opened();
    await first.page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    const worker = join(below, "sw.js");
    writeFileSync(worker, readFileSync(worker, "utf8").replace(/const version = "/, 'const version = "next-'));
    await first.page.evaluate(async () => void (await (await navigator.serviceWorker.ready).update()));
    await first.page.close();
    const second = await opened();
    await second.page.waitForFunction(async () => (await caches.keys()).some((name) => name.includes("next-")));
    await second.page.close();
    await context.setOffline(true);
    const third = await opened();
    await third.page.close();
  } finally {
    await context.close();
    server.close();
    rmSync(root, { recursive: true });
  }
}

/** The file with dialogs and panels does not load: the page says so and continues. */
async function testMissingParts(browser, address) {
  const context = await newContext(browser, { size: [900, 600], serviceWorkers: "block" });
  await context.route(/\/parts-[^/]*\.js$/, (route) => route.abort());
  try {
    const editor = await EditorPage.within(context, address);
    await said(editor.page, /A part of the editor could not be loaded/);
    await editor.page.locator(".toast button").click();
    await editor.load(small);
    checkEqual((await status(editor)).kind, "exact", "the picture");
    checkEqual(await editor.page.locator(".toast").count(), 0, "the number of messages");
    await editor.page.keyboard.press("Control+e");
    await said(editor.page, /A part of the editor could not be loaded/);
    await edit(editor);
  } finally {
    await context.close();
  }
}

const mine = [{ name: "a.svg", bytes: Buffer.from(small) }];

/** The engine does not load: the first page says so, and again when it is needed. */
async function testMissingWork(browser, address) {
  const context = await newContext(browser, { size: [900, 600], serviceWorkers: "block" });
  await context.route(/\/work-[^/]*\.js$/, (route) => route.abort());
  const page = await context.newPage();
  const isSaidAfter = async (act) => {
    await act();
    await said(page, /A part of the editor could not be loaded|could not be read/);
    await page.locator(".toast button").click();
    await page.locator(".toast").waitFor({ state: "detached" });
  };
  await isSaidAfter(() => page.goto(address));
  await isSaidAfter(() => page.keyboard.press("Control+o"));
  await isSaidAfter(() => page.getByRole("button", { name: /^Sunset/ }).click());
  await isSaidAfter(() => drop(page, mine));
  await isSaidAfter(() => paste(page, { text: small }));
  await context.close();
}

/** Runs before the page's scripts: cancels the page's file dialogs at once. */
function noteAsked() {
  window.showOpenFilePicker = async () => {
    window.wasAsked = true;
    throw new DOMException("left", "AbortError");
  };
}

/** A request on the first page, made before the rest of the editor is loaded, is done after loading. */
async function testEarly(browser, address) {
  const early = async (act, isDone) => {
    const context = await newContext(browser, { size: [900, 600], serviceWorkers: "block" });
    await context.addInitScript(noteAsked);
    const page = await context.newPage();
    let come;
    const coming = new Promise((resolve) => (come = resolve));
    await context.route(/\/work-[^/]*\.js$/, (route) => coming.then(() => route.continue()));
    await page.goto(address);
    await page.locator(".welcome").waitFor();
    await act(page);
    check((await page.evaluate(() => window.sfumatoEditor)) === undefined, "the rest was there already");
    come();
    await page.waitForFunction(() => window.sfumatoEditor !== undefined);
    await isDone(page);
    await context.close();
  };
  await early((page) => page.getByRole("button", { name: /^Sunset/ }).click(), (page) => shows(page, example("sunset.svg")));
  await early((page) => page.keyboard.press("Control+Alt+n"), (page) => page.locator("dialog[open]").waitFor());
  await early((page) => page.getByRole("button", { name: /Start blank/ }).click(), (page) => page.locator("dialog[open]").waitFor());
  await early((page) => page.getByRole("button", { name: /^Open/ }).click(), (page) => page.waitForFunction(() => window.wasAsked));
  await early((page) => page.keyboard.press("Control+o"), (page) => page.waitForFunction(() => window.wasAsked));
  await early((page) => page.getByRole("button", { name: "Try the five steps" }).click(), (page) => page.locator(".tour-card").waitFor());
  await early((page) => drop(page, mine), (page) => shows(page, small));
  await early((page) => paste(page, { text: small }), (page) => shows(page, small));
  await early((page) => paste(page, { files: mine }), (page) => shows(page, small));
  await early((page) => paste(page, { text: "Dear Sir," }), (page) => said(page, /no drawing on the clipboard/));
  // Actions without a meaning on the first page have none later either.
  await early(meddle, async (page) => {
    check(await page.locator(".welcome").isVisible(), "the first page is gone");
    checkEqual(await page.locator(".menu, .toast, dialog[open]").count(), 0, "what has opened");
  });
}

/** Cut, copy, the menu's button, the wheel and a double click, beside all buttons. */
async function meddle(page) {
  for (const name of ["x", "c"]) await page.keyboard.press(`Control+${name}`);
  await page.locator("h1").click({ button: "right" });
  await page.locator("h1").dblclick();
  await page.mouse.wheel(0, 300);
  await page.mouse.wheel(0, -300);
}

/** Panels and dialogs load late: the stage works, and they show everything later. */
async function testEarlyStage(browser, address) {
  const context = await newContext(browser, { size: [1200, 800], serviceWorkers: "block" });
  let come;
  const coming = new Promise((resolve) => (come = resolve));
  await context.route(/\/parts-[^/]*\.js$/, (route) => coming.then(() => route.continue()));
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error)));
  await page.goto(address);
  await page.locator(".welcome").waitFor();
  await paste(page, { text: small });
  const stage = page.locator(".canvas-stage");
  await stage.waitFor();
  const zoom = () => page.locator(".status-button.zoom").textContent();
  const [x, y] = await stage.boundingBox().then((box) => [box.x + box.width / 2, box.y + box.height / 2]);
  await page.mouse.move(x, y);
  const before = await zoom();
  await page.mouse.wheel(0, -200);
  await page.waitForFunction((text) => document.querySelector(".status-button.zoom").textContent !== text, before);
  await stage.focus();
  await page.keyboard.press("Control+a");
  check((await copied(page, "copy")).includes("sf:left"), "nothing was copied");
  check((await copied(page, "cut")).includes("sf:left"), "nothing was cut");
  await page.keyboard.press("Control+z");
  await paste(page, { text: small });
  await page.mouse.click(x, y, { button: "right" });
  await page.locator("[role=menu]").first().waitFor();
  await page.keyboard.press("Escape");
  await page.mouse.dblclick(x, y);
  await page.keyboard.press("Control+e");
  come();
  await page.waitForFunction(() => window.sfumatoEditor !== undefined);
  await page.locator("dialog[open]").waitFor();
  checkEqual((await page.evaluate(() => window.sfumatoEditor.text.match(/<path/g).length)), 2 * small.match(/<path/g).length, "paths after a paste");
  checkEqual(errors, [], "errors of the page");
  await context.close();
}

/** With an open dialog the clipboard's keys do not change the drawing behind it. */
async function testClipboardBehindDialog(editor) {
  const { page } = editor;
  await editor.load(small);
  await page.locator(".canvas-stage").focus();
  await editor.key("Control+a", "Control+e");
  await page.locator("dialog[open]").waitFor();
  await page.locator("dialog[open] button").first().focus();
  checkEqual(await copied(page, "cut"), "", "what was cut behind the dialog");
  await paste(page, { text: small });
  await closeDialog(page);
  checkEqual(await editor.text, small, "the text behind the dialog");
  check((await copied(page, "copy")).includes("sf:left"), "nothing is copied without the dialog");
  editor.checkQuiet();
}

async function testOneFile(editor) {
  await editor.load(small, "disk.svg");
  checkEqual((await status(editor)).kind, "exact", "the picture");
  await edit(editor);
  await editor.settled();
  await editor.page.keyboard.press("Control+e");
  await editor.page.locator("dialog .export-view img").waitFor();
  checkEqual(await editor.page.evaluate(() => window.violations), [], "violations of the page's policy");
  editor.checkQuiet();
}

/** The message in a browser without scripts, without modules, or with too old ones. */
async function testTooOld(browser, addresses) {
  const says = async (what, address, prepare, where, options = {}) => {
    const context = await newContext(browser, options);
    const page = await context.newPage();
    await prepare(page);
    await page.goto(address);
    await page.locator(where).waitFor().catch(() => check(false, `${what}, ${address}: nothing is said`));
    // A browser with modules shows the editor above the message.
    const isAlone = (await page.locator("#app > *").count()) === 0;
    const box = await page.locator(where).boundingBox();
    check(!isAlone || box.y + box.height < 300, `${what}, ${address}: it is said out of sight: ${JSON.stringify(box)}`);
    await context.close();
  };
  const old = "#too-old";
  for (const address of addresses) {
    await says("without scripts", address, () => {}, "noscript p", { javaScriptEnabled: false });
    await says("without modules", address, (page) => page.addInitScript(() => delete HTMLScriptElement.prototype.noModule), old);
  }
  const [site] = addresses;
  const foreign = { contentType: "text/javascript", body: "let 1 = ;" };
  await says("with modules of an unknown language", site, (page) => page.route("**/assets/*.js", (route) => route.fulfill(foreign)), old);
}

/** A server that declares all pages UTF-8, while the single-file page is not. */
async function testSaidToBeUtf8(browser, address, oneFile) {
  const context = await newContext(browser, { size: [900, 600] });
  const page = { path: fileURLToPath(oneFile), contentType: "text/html; charset=utf-8" };
  await context.route(`${address}one.html`, (route) => route.fulfill(page));
  const editor = await EditorPage.within(context, `${address}one.html`);
  await editor.load(small);
  await shows(editor.page, small);
  checkEqual(await status(editor).then(({ kind }) => kind), "exact", "what the engine says");
  await context.close();
}

/** Reports, without a limit, the time from the disk to the first exact picture. */
async function testColdStart(browser, oneFile) {
  const editor = await EditorPage.open(browser, oneFile, { size });
  await editor.page.getByRole("button", { name: /Portrait/ }).click();
  await editor.page.waitForFunction(() => window.sfumatoEditor.status.kind === "exact");
  const seconds = (await editor.page.evaluate(() => performance.now())) / 1000;
  console.log(`# portrait stands ${seconds.toFixed(2)} s after a start from disk`);
  await editor.close();
}

export async function testRobust(tap, { browser, address, oneFile, folder }) {
  const test = (name, script, body, at = address) => tap.test(`robust: ${name}`, () => within(browser, at, script, body));
  await tap.test("robust: graphics that were lost come back", () => within(browser, address, null, testLostContext, { ratio: 0.5, isDrawn: true }));
  await test("without WebGL 2 all but the picture works", noWebGl, (editor) => testWithout(editor, "exact", /no WebGL 2/));
  await test("without WebAssembly the page says so", noWebAssembly, (editor) => testWithout(editor, "failed", /no WebAssembly/));
  await test("a message says that workers are refused", noWorker, (editor) => testWithout(editor, "failed", /cannot start web workers/));
  await test("a message says that workers do not start", brokenWorker, (editor) => testWithout(editor, "failed", /cannot start web workers/));
  await test("a message says what is wrong in a huge text", null, testHuge);
  await test("a session asks nobody and breaks no policy", listen, testSession);
  for (const host of ["localhost", "127.0.0.1"]) {
    await tap.test(`robust: a folder, no network, an update, from ${host}`, () => testOffline(browser, folder, host));
  }
  await tap.test("robust: a message says that parts are missing", () => testMissingParts(browser, address));
  await tap.test("robust: a message says that a file of the editor is missing", () => testMissingWork(browser, address));
  await tap.test("robust: what is asked for early waits and is done", () => testEarly(browser, address));
  await tap.test("robust: panels that are late take nothing from the stage", () => testEarlyStage(browser, address));
  await test("the clipboard's keys end at a dialog", null, testClipboardBehindDialog);
  await test("one file from the disk works", listen, testOneFile, oneFile);
  await tap.test("robust: one file works where a server says it is UTF-8", () => testSaidToBeUtf8(browser, address, oneFile));
  await tap.test("robust: a message says that the browser is too old", () => testTooOld(browser, [address, oneFile]));
  await tap.test("robust: a cold start from the disk", () => testColdStart(browser, oneFile));
}
