// What the editor's tests in a browser share: TAP, a server of static files, pages.
import { createReadStream, existsSync, mkdirSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const root = new URL("../../../", import.meta.url);

/** A path of the project, absolute. */
export const pathOf = (relative) => fileURLToPath(new URL(relative, root));

/** Packages of the editor. */
export const packageOf = createRequire(pathOf("web/editor/package.json"));
export const { chromium } = packageOf("playwright-core");

export class Skip extends Error {}

/** Runs tests one after another and prints TAP. */
export class Tap {
  failures = 0;

  /** @param {string} only tests whose names hold this; "" all */
  constructor(only = "") {
    this.only = only;
  }

  /** A test that fails is tried once more, and says so: browsers share the machine with other tests. */
  async test(name, body) {
    if (!name.includes(this.only)) return;
    const start = Date.now();
    let error = await this.attempt(body);
    if (error && !(error instanceof Skip)) {
      console.log(`# editor: ${name}: once more, after ${commented(error)}`);
      error = await this.attempt(body);
    }
    const seconds = ((Date.now() - start) / 1000).toFixed(1);
    if (!error) return console.log(`# ${seconds} s\nok - editor: ${name}`);
    if (error instanceof Skip) return console.log(`ok - editor: ${name} # SKIP ${error.message}`);
    this.failures += 1;
    console.log(`not ok - editor: ${name}\n# ${commented(error)}`);
  }

  /** @returns what was thrown, or null */
  async attempt(body) {
    try {
      await body();
      return null;
    } catch (error) {
      return error;
    }
  }
}

/** An error as lines of comment, but for the first one's sign. */
function commented(error) {
  return String(error?.stack ?? error).replaceAll("\n", "\n# ");
}

export function check(condition, message) {
  if (!condition) throw new Error(message);
}

export function checkEqual(actual, expected, what) {
  const [a, b] = [actual, expected].map((value) => JSON.stringify(value));
  if (a !== b) throw new Error(`${what}: ${a?.slice(0, 800)}, expected ${b?.slice(0, 800)}`);
}

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

const quiet = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];
/** Mesa's software driver, which is several times as fast as Chromium's own. */
const mesa = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist", "--enable-gpu"];

export function launch(flags = mesa) {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  return chromium.launch({ executablePath, args: [...quiet, ...flags] });
}

/** What has not happened after this never will, milliseconds. */
const WAIT = Number(process.env.SFUMATO_WAIT ?? 45000);

/** The editor in a page of a fresh profile, and what it says on its console. */
export class EditorPage {
  /** Messages of errors that the page did not expect. */
  errors = [];
  /** Addresses beyond the server's that were asked for. */
  requests = [];

  static async open(browser, address, { size = [1440, 900], ...options } = {}) {
    const [width, height] = size;
    const context = await browser.newContext({ viewport: { width, height }, ...options });
    return EditorPage.within(context, address);
  }

  static async within(context, address) {
    const editor = new EditorPage(await context.newPage());
    editor.context = context;
    await editor.go(address);
    return editor;
  }

  constructor(page) {
    this.page = page;
    page.setDefaultTimeout(WAIT);
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
  async drag(points, { steps = 8, keys = [] } = {}) {
    const places = [];
    for (const [x, y] of points) places.push(await this.at(x, y));
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

  async shot(name) {
    const folder = pathOf("build/editor-shots");
    mkdirSync(folder, { recursive: true });
    await this.page.screenshot({ path: `${folder}/${name}.png`, caret: "initial" });
  }

  close() {
    return this.context.close();
  }
}
