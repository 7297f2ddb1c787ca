// Helpers for the editor's tests in a browser: a server of static files, pages.
import { createReadStream, existsSync, mkdirSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join, normalize } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { fileURLToPath } from "node:url";
import { launchWith, MESA } from "../../chromium.mjs";
import { PATIENCE, check, checkEqual } from "../../tap.mjs";
import { drawNothing, installHooks } from "./hooks.mjs";

export { PATIENCE, Skip, Tap, check, checkEqual } from "../../tap.mjs";

const root = new URL("../../..", import.meta.url);

/** Returns the absolute path of a file of the project. */
export const pathOf = (relative) => fileURLToPath(new URL(relative, root));

/** Finds packages of the editor. */
export const packageOf = createRequire(pathOf("web/editor/package.json"));
export const { chromium } = packageOf("playwright-core");

const types = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".jpg": "image/jpeg",
  ".webp": "image/webp",
  ".webmanifest": "application/manifest+json",
};

/** Serves a folder on this machine only: {address, close}. */
export async function serve(folder) {
  const server = createServer((request, response) => {
    const name = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname));
    let path = join(folder, name);
    if (existsSync(path) && statSync(path).isDirectory()) path = join(path, "index.html");
    if (!path.startsWith(folder) || !existsSync(path)) return response.writeHead(404).end();
    response.writeHead(200, { "Content-Type": types[extname(path)] ?? "application/octet-stream" });
    createReadStream(path).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

/** Interval between polls, milliseconds. */
const PAUSE = 25;

/** The page is composited without graphics, which are then free for the picture. */
export const launch = (flags = [...MESA, "--disable-gpu-compositing"]) => launchWith(chromium, flags);

/** Device pixels per CSS pixel, for tests that do not look at pixels. Places on the page do not change. */
const RATIO = 0.25;

/**
 * Opens a fresh profile. size: of the window, CSS pixels; ratio: device pixels per CSS pixel; isDrawn: whether the
 * test looks at the picture, or needs motion; other options are Playwright's for contexts.
 */
export async function newContext(browser, options = {}) {
  const { size = [1440, 900], ratio = RATIO, isDrawn = false, ...more } = options;
  const [width, height] = size;
  const window = { viewport: { width, height }, deviceScaleFactor: ratio };
  const reducedMotion = isDrawn ? "no-preference" : "reduce";
  // The service worker would download all files of the page in each context.
  const context = await browser.newContext({ ...window, reducedMotion, serviceWorkers: "block", ...more });
  context.setDefaultTimeout(PATIENCE);
  if (!isDrawn) await context.addInitScript(drawNothing);
  return context;
}

/** Waits for a condition outside the page. */
export async function until(what, test) {
  const end = performance.now() + PATIENCE;
  while (!(await test())) {
    check(performance.now() < end, `not so: ${what}`);
    await sleep(PAUSE);
  }
}

/** The editor in a page of a fresh profile, with the messages on its console. */
export class EditorPage {
  /** Unexpected error messages of the page. */
  errors = [];
  /** Requested addresses outside the server. */
  requests = [];

  static async open(browser, address, options) {
    return EditorPage.within(await newContext(browser, options), address);
  }

  static async within(context, address) {
    const editor = new EditorPage(await context.newPage());
    editor.context = context;
    await editor.page.addInitScript(installHooks);
    await editor.go(address);
    return editor;
  }

  constructor(page) {
    this.page = page;
    page.setDefaultTimeout(PATIENCE);
    page.on("pageerror", (error) => this.errors.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error") this.errors.push(message.text());
    });
  }

  async go(address) {
    const { origin, protocol } = new URL(address);
    this.page.on("request", (request) => {
      const url = request.url();
      const isOwn = protocol === "file:" ? url.startsWith("file:") : url.startsWith(origin);
      if (!isOwn && !/^(blob|data):/.test(url)) this.requests.push(url);
    });
    await this.page.goto(address);
    await this.page.waitForFunction(() => window.sfumatoEditor !== undefined);
  }

  /** Opens a text like a file. */
  async load(text, name = "drawing.svg") {
    await this.page.evaluate(([t, n]) => window.sfumatoEditor.open(t, n), [text, name]);
    await this.settled();
  }

  get text() {
    return this.page.evaluate(() => window.sfumatoEditor.text);
  }

  /** Resolves when the exact picture of the text is drawn. */
  settled() {
    return this.page.evaluate(() => window.sfumatoEditor.settled());
  }

  /** Returns a point of the artboard on the page, CSS pixels. */
  at(x, y) {
    return this.page.evaluate(([a, b]) => window.sfumatoEditor.place(a, b), [x, y]);
  }

  /** The same for many points. */
  all(points) {
    return this.page.evaluate((all) => all.map(([x, y]) => window.sfumatoEditor.place(x, y)), points);
  }

  /** Returns the picture on the stage as a PNG, without the marks above it. */
  async picture() {
    await this.settled();
    await this.page.evaluate(() => {
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(".canvas-stage > :not(canvas), .isolation, .toasts, .tooltip, .resizer { visibility: hidden !important }");
      document.adoptedStyleSheets = [sheet];
    });
    const png = await this.pictureOf(".canvas-stage > canvas");
    await this.page.evaluate(() => void (document.adoptedStyleSheets = []));
    return png;
  }

  /** Returns a PNG of an element. */
  pictureOf(selector) {
    // The page's policy forbids a new <style>, which hiding the caret would need.
    return this.page.locator(selector).screenshot({ caret: "initial" });
  }

  async key(...names) {
    for (const name of names) await this.page.keyboard.press(name);
  }

  /** Drags through points of the artboard. */
  async drag(points, { steps = 4, keys = [] } = {}) {
    const places = await this.all(points);
    for (const key of keys) await this.page.keyboard.down(key);
    await this.page.mouse.move(...places[0]);
    await this.page.mouse.down();
    for (const place of places.slice(1)) await this.page.mouse.move(...place, { steps });
    await this.page.mouse.up();
    for (const key of keys) await this.page.keyboard.up(key);
  }

  async click(x, y, options = {}) {
    const place = await this.at(x, y);
    await this.page.mouse.click(...place, options);
  }

  /** Fails if the page has complained or requested an outside address. */
  checkQuiet() {
    checkEqual(this.errors, [], "errors on the console");
    checkEqual(this.requests, [], "requests to elsewhere");
  }

  /** Takes a picture for people: each CSS pixel is one pixel. */
  async shot(name) {
    const folder = pathOf("build/editor-shots");
    mkdirSync(folder, { recursive: true });
    const ratio = await this.page.evaluate(() => devicePixelRatio);
    if (ratio !== 1) await this.#showAt(1);
    await this.page.screenshot({ path: `${folder}/${name}.png`, caret: "initial" });
    if (ratio !== 1) await this.#showAt(ratio);
  }

  /** Changes the number of screen pixels per CSS pixel. */
  async #showAt(deviceScaleFactor) {
    // The session stays open, because its end would resize the window.
    this.screen ??= await this.context.newCDPSession(this.page);
    const size = this.page.viewportSize();
    const wanted = { ...size, deviceScaleFactor, mobile: false };
    await this.screen.send("Emulation.setDeviceMetricsOverride", wanted);
  }

  close() {
    return this.context.close();
  }
}
