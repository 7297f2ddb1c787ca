// What the editor's tests in a browser share: a server of static files, pages.
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

const root = new URL("../../../", import.meta.url);

/** A path of the project, absolute. */
export const pathOf = (relative) => fileURLToPath(new URL(relative, root));

/** Packages of the editor. */
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

/** Serves a folder on this machine alone: {address, close}. */
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

/** Between two looks at what may have changed, milliseconds. */
const PAUSE = 25;

/** The page is put together without graphics, which leaves these to the picture. */
export const launch = (flags = [...MESA, "--disable-gpu-compositing"]) => launchWith(chromium, flags);

/** Device pixels to a CSS pixel, where nobody looks at them. Places on the page are the same. */
const RATIO = 0.25;

/**
 * A fresh profile. size: of the window, CSS pixels; ratio: device pixels to a CSS pixel; isDrawn: whether
 * there is a picture to look at, and motion; and what Playwright has for contexts.
 */
export async function newContext(browser, options = {}) {
  const { size = [1440, 900], ratio = RATIO, isDrawn = false, ...more } = options;
  const [width, height] = size;
  const window = { viewport: { width, height }, deviceScaleFactor: ratio };
  const reducedMotion = isDrawn ? "no-preference" : "reduce";
  const context = await browser.newContext({ ...window, reducedMotion, ...more });
  context.setDefaultTimeout(PATIENCE);
  if (!isDrawn) await context.addInitScript(drawNothing);
  return context;
}

/** Waits until something is so that the page alone cannot know. */
export async function until(what, test) {
  const end = performance.now() + PATIENCE;
  while (!(await test())) {
    check(performance.now() < end, `not so: ${what}`);
    await sleep(PAUSE);
  }
}

/** The editor in a page of a fresh profile, and what it says on its console. */
export class EditorPage {
  /** Messages of errors that the page did not expect. */
  errors = [];
  /** Addresses beyond the server's that were asked for. */
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

  /** Opens a text as a file would be. */
  async load(text, name = "drawing.svg") {
    await this.page.evaluate(([t, n]) => window.sfumatoEditor.open(t, n), [text, name]);
    await this.settled();
  }

  get text() {
    return this.page.evaluate(() => window.sfumatoEditor.text);
  }

  /** When the exact picture of the text is drawn. */
  settled() {
    return this.page.evaluate(() => window.sfumatoEditor.settled());
  }

  /** A point of the artboard on the page, CSS pixels. */
  at(x, y) {
    return this.page.evaluate(([a, b]) => window.sfumatoEditor.place(a, b), [x, y]);
  }

  /** The same of many points. */
  all(points) {
    return this.page.evaluate((all) => all.map(([x, y]) => window.sfumatoEditor.place(x, y)), points);
  }

  /** The picture on the stage as a PNG, without what is drawn above it. */
  async picture() {
    await this.settled();
    await this.page.evaluate(() => {
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(".canvas-stage > :not(canvas), .toasts, .tooltip, .resizer { visibility: hidden !important }");
      document.adoptedStyleSheets = [sheet];
    });
    const png = await this.pictureOf(".canvas-stage > canvas");
    await this.page.evaluate(() => void (document.adoptedStyleSheets = []));
    return png;
  }

  /** An element as it looks, a PNG. */
  pictureOf(selector) {
    // The page's policy lets nobody add a <style>, as hiding the caret would.
    return this.page.locator(selector).screenshot({ caret: "initial" });
  }

  async key(...names) {
    for (const name of names) await this.page.keyboard.press(name);
  }

  /** A stroke through points of the artboard. */
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

  /** Fails where the page has complained or asked for anything from elsewhere. */
  checkQuiet() {
    checkEqual(this.errors, [], "errors on the console");
    checkEqual(this.requests, [], "requests to elsewhere");
  }

  /** A picture to be looked at: each CSS pixel is one. */
  async shot(name) {
    const folder = pathOf("build/editor-shots");
    mkdirSync(folder, { recursive: true });
    const ratio = await this.page.evaluate(() => devicePixelRatio);
    if (ratio !== 1) await this.#showAt(1);
    await this.page.screenshot({ path: `${folder}/${name}.png`, caret: "initial" });
    if (ratio !== 1) await this.#showAt(ratio);
  }

  /** From now on a CSS pixel has so many of the screen. */
  async #showAt(deviceScaleFactor) {
    // It stays: with its end the window would have another size.
    this.screen ??= await this.context.newCDPSession(this.page);
    const size = this.page.viewportSize();
    const wanted = { ...size, deviceScaleFactor, mobile: false };
    await this.screen.send("Emulation.setDeviceMetricsOverride", wanted);
  }

  close() {
    return this.context.close();
  }
}
