// Helpers of the tests: the command, pages in Chromium, comparison of pictures.
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { PATIENCE, Skip, check } from "../tap.mjs";

export { PATIENCE, Skip, Tap, check, checkEqual, checkNear } from "../tap.mjs";

const root = new URL("../../", import.meta.url);

/** Returns the absolute path of a file of the project. */
export const pathOf = (relative) => fileURLToPath(new URL(relative, root));

/** Yields the same numbers in every run. */
export function* randomNumbers(seed) {
  for (let state = seed >>> 0; ;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state >>> 8;
  }
}

/** Returns the path of a document of the tests; skips the test if it is a missing public scene. */
export function documentPath(name) {
  const path = pathOf(name);
  if (!existsSync(path)) throw new Skip(`${name} is not here`);
  return path;
}

export const shortName = (document) => document.split("/").at(-1);

/** The command and a folder for its outputs. */
export class Command {
  constructor(program, folder) {
    this.program = program;
    this.folder = folder;
    mkdirSync(folder, { recursive: true });
  }

  file(name) {
    return `${this.folder}/${name}`;
  }

  run(...words) {
    execFileSync(this.program, words.map(String), { stdio: ["ignore", "ignore", "pipe"] });
  }

  /** Renders a document to the format of the extension, once. Returns the file's path. */
  made(document, extension, ...options) {
    const path = this.file(`${document.replace(/\W/g, "_")}${options.join("")}.${extension}`);
    if (!existsSync(path))
      this.run("render", documentPath(document), "-o", path, "--quiet", ...options);
    return path;
  }

  /** Returns the viewer of a document. */
  html(document, ...options) {
    return this.made(document, "html", ...options);
  }

  /** Returns a page made by changing the text of a document's page. */
  changed(document, name, change) {
    const path = this.file(`${name}.html`);
    writeFileSync(path, change(readFileSync(this.html(document), "utf8")));
    return path;
  }

  /** Returns the rasterizer's picture of a part of the artboard: x, y, width, height. */
  raster(document, size, part) {
    const path = this.file("raster.png");
    this.run(
      "render",
      documentPath(document),
      "-o",
      path,
      "--width",
      size[0],
      "--height",
      size[1],
      "--viewport",
      part.join(","),
      "--no-dither",
      "--quiet",
    );
    return readFileSync(path);
  }
}

/** Messages for which the page is not responsible: reading a screenshot back is slow. */
const HARMLESS = /GPU stall due to ReadPixels/;

/** Collects the errors and warnings of a page. */
class Complaints {
  /**
   * @param {string} address the only server that the page may access, beside files
   * @param {RegExp} harmless allowed messages
   */
  constructor(page, address, harmless) {
    this.all = [];
    const { protocol, origin } = new URL(address);
    const hearRequest = (request) => {
      const isOwn = protocol === "http:" && request.url().startsWith(origin);
      const isNear = isOwn || /^(file|data|blob|about):/.test(request.url());
      if (!isNear) this.all.push(`asked for ${request.url()}`);
    };
    const hearWords = (message) => {
      const isLoud = ["error", "warning"].includes(message.type());
      if (isLoud && !harmless.test(message.text())) this.all.push(message.text());
    };
    const hearError = (error) => this.all.push(String(error));
    const heard = { pageerror: hearError, console: hearWords, request: hearRequest };
    for (const [name, hear] of Object.entries(heard)) page.on(name, hear);
    this.end = () => {
      for (const [name, hear] of Object.entries(heard)) page.off(name, hear);
    };
  }
}

/** Pages of one browser; their consoles must stay silent. */
export class Pages {
  /** Pages by their options, kept because a new process takes most of the time of a small test. */
  #kept = new Map();

  constructor(browser) {
    this.browser = browser;
  }

  /**
   * Opens a file, passes the page to `body`, and fails if the page complains. options: as for `visit`; broken (no
   * picture expected); isSlow (the page may show the still picture).
   */
  async open(path, { broken = false, isSlow = false, ...options }, body) {
    await this.visit(`file://${path}`, options, async (page) => {
      if (!broken) await page.evaluate(() => window.sfumatoViewer.ready);
      // Software drivers on busy machines are slow; another test covers that.
      if (!broken && !isSlow) await page.evaluate(() => window.sfumatoViewer.goLive());
      await body(page);
    });
  }

  /**
   * Opens an address, passes the page to `body`, and fails if the page complains or accesses another server.
   * options: size, ratio, touch, before (a script that runs first), harmless (expected complaints), and
   * Playwright's options for contexts.
   */
  async visit(address, { size = [320, 240], before, harmless = HARMLESS, ...options }, body) {
    const page = await this.#pageFor(size, options, before);
    const complaints = new Complaints(page, address, harmless);
    let isGood = false;
    try {
      await page.goto(address);
      await body(page);
      check(complaints.all.length === 0, `the page complained: ${complaints.all.join(" | ")}`);
      isGood = true;
    } finally {
      complaints.end();
      await this.#leave(page, options, isGood && !before);
    }
  }

  async #pageFor([width, height], options, before) {
    const kept = before ? undefined : this.#kept.get(JSON.stringify(options));
    if (kept) {
      await kept.setViewportSize({ width, height });
      return kept;
    }
    const { ratio = 1, touch = false, ...rest } = options;
    const asked = { deviceScaleFactor: ratio, hasTouch: touch, ...rest };
    const context = await this.browser.newContext({ viewport: { width, height }, ...asked });
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE);
    if (before) await page.addInitScript(before);
    return page;
  }

  async #leave(page, options, isToBeKept) {
    const key = JSON.stringify(options);
    if (isToBeKept) {
      await page.goto("about:blank");
      this.#kept.set(key, page);
      return;
    }
    if (this.#kept.get(key) === page) this.#kept.delete(key);
    await page.context().close();
  }
}

export const settled = (page) => page.evaluate(() => window.sfumatoViewer.settled());

export const viewOf = (page) => page.evaluate(() => window.sfumatoViewer.view);

export async function show(page, view) {
  await page.evaluate((to) => {
    window.sfumatoViewer.view = to;
  }, view);
  await settled(page);
}

/** Takes a screenshot without the buttons, and without the note that a slow machine gets. */
export async function pictureOf(page) {
  await page.evaluate(() => {
    for (const id of ["tools", "still"]) document.getElementById(id).style.visibility = "hidden";
  });
  return page.screenshot();
}

/** Returns a channel of a decoded PNG on white paper. */
function onPaper(data, i) {
  const alpha = data[i - (i % 4) + 3] / 255;
  return Math.round(data[i] * alpha + 255 * (1 - alpha));
}

/** Returns mean, 99th percentile and maximum of the difference of two PNGs, code values. */
export function difference(PNG, a, b) {
  const [first, second] = [a, b].map((bytes) => PNG.sync.read(bytes));
  check(first.width === second.width && first.height === second.height, "the sizes differ");
  const counts = new Array(256).fill(0);
  for (let i = 0; i < first.data.length; ++i) {
    if (i % 4 < 3) counts[Math.abs(onPaper(first.data, i) - onPaper(second.data, i))] += 1;
  }
  const total = (3 * first.data.length) / 4;
  let mean = 0,
    below = 0,
    percentile = 0,
    largest = 0;
  counts.forEach((count, value) => {
    mean += (count * value) / total;
    if (below < 0.99 * total) percentile = value;
    if (count > 0) largest = value;
    below += count;
  });
  return { mean, percentile, largest };
}

/** Returns the largest difference of a picture from one colour, code values. */
export function rangeOf(PNG, bytes) {
  const { data } = PNG.sync.read(bytes);
  let range = 0;
  for (let i = 4; i < data.length; ++i) range = Math.max(range, Math.abs(data[i] - data[i % 4]));
  return range;
}
