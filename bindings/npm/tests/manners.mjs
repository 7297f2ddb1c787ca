// Tests how <sfumato-picture> behaves towards the page, the browser and people who cannot see it.
import { readFileSync } from "node:fs";
import { Pages } from "../../../tests/viewer/harness.mjs";
import { checkPixel, launch, visit } from "./builds.mjs";
import { frames, settled } from "./element.mjs";
import { PATIENCE, check, checkEqual, packageOf } from "./tools.mjs";

const expected = /status of 404/;
const axe = readFileSync(packageOf.resolve("axe-core/axe.min.js"), "utf8");
const ready = (page, id) => page.evaluate((name) => document.getElementById(name).ready, id);

async function testAccess(tap, { pages, address }) {
  await tap.test("npm: pictures have names, and axe finds nothing", () =>
    visit(pages, address, { expected }, async (page) => {
      await ready(page, "first");
      await ready(page, "second");
      const told = await page.evaluate(() => ["first", "second", "missing"].map((id) => {
        const picture = document.getElementById(id);
        return ["role", "aria-label", "tabindex"].filter((name) => picture.hasAttribute(name));
      }));
      checkEqual(told, [[], [], []], "attributes that the page has not set");
      const session = await page.context().newCDPSession(page);
      const { nodes } = await session.send("Accessibility.getFullAXTree");
      const tree = nodes.filter(({ ignored, role }) => !ignored && /^(application|image|img)$/.test(role?.value)).map(({ role, name, properties }) =>
        [role.value.replace("img", "image"), name.value, properties.some(({ name: what, value }) => what === "focusable" && value.value)]);
      for (const node of [["application", "Red above blue", true], ["image", "The same, to look at", false], ["image", "A still picture", false]]) {
        check(tree.some((other) => String(other) === String(node)), `${node} is missing in ${JSON.stringify(tree)}`);
      }
      await page.getByRole("application", { name: "Red above blue" }).waitFor();
      await page.evaluate(axe);
      const found = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
      checkEqual(found.violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), [], "violations");
    }));
  await tap.test("npm: what the page says of roles and names stands", () =>
    visit(pages, address, { expected }, async (page) => {
      const told = await page.evaluate(() => {
        const picture = document.createElement("sfumato-picture");
        picture.setAttribute("role", "figure");
        picture.alt = "One";
        document.body.append(picture);
        picture.alt = "Two";
        picture.interactive = true;
        picture.interactive = false;
        const after = [picture.getAttribute("role"), picture.getAttribute("aria-label"), picture.hasAttribute("tabindex")];
        picture.remove();
        return after;
      });
      checkEqual(told, ["figure", null, false], "role and name");
    }));
}

async function testLosses(tap, { pages, address }) {
  await tap.test("npm: a lost context comes back, or another takes its place", async () => {
    const context = await pages.browser.newContext();
    context.setDefaultTimeout(PATIENCE);
    try {
      const page = await context.newPage();
      // The page cannot reach the element's context.
      await page.addInitScript(() => {
        window.contexts = [];
        const { getContext } = OffscreenCanvas.prototype;
        OffscreenCanvas.prototype.getContext = function (...asked) {
          const made = getContext.apply(this, asked);
          if (asked[0] === "webgl2") window.contexts.push([made, made.getExtension("WEBGL_lose_context")]);
          return made;
        };
      });
      await page.goto(address);
      await ready(page, "first");
      checkEqual(await page.evaluate(() => window.contexts.length), 1, "contexts of the page");
      for (const comesBack of [true, false]) {
        const before = await page.evaluate((restores) => {
          const [, loss] = window.contexts.at(-1);
          loss.loseContext();
          if (restores) setTimeout(() => loss.restoreContext(), 100);
          return document.getElementById("first").frames;
        }, comesBack);
        await page.waitForFunction((frames) => document.getElementById("first").frames > frames, before);
        await checkPixel(page, "first", [0.5, 0.05], [255, 0, 0, 255]);
      }
      checkEqual(await page.evaluate(() => window.contexts.length), 2, "contexts after two losses");
    } finally {
      await context.close();
    }
  });
  const without = {
    "WebGL 2": ["no WebGL 2", "first", () => {
      for (const Canvas of [OffscreenCanvas, HTMLCanvasElement]) {
        const { getContext } = Canvas.prototype;
        Canvas.prototype.getContext = function (kind, ...more) {
          return kind === "webgl2" ? null : getContext.call(this, kind, ...more);
        };
      }
    }],
    "workers": ["could not be started", "first", () => {
      window.Worker = class extends EventTarget {
        postMessage() {
          setTimeout(() => this.dispatchEvent(new ErrorEvent("error", { message: "refused" })));
        }
        terminate() {}
      };
    }],
  };
  for (const [what, [words, id, before]] of Object.entries(without)) {
    await tap.test(`npm: without ${what} the still picture stays, and an event says so`, async () => {
      const context = await pages.browser.newContext();
      context.setDefaultTimeout(PATIENCE);
      try {
        const page = await context.newPage();
        await page.addInitScript(before);
        await page.goto(address);
        const why = await page.evaluate((name) => document.getElementById(name).ready.then(() => "", (error) => error.message), id);
        check(why.includes(words), why);
        check(await page.locator(`#${id} img`).isVisible(), "the still picture is hidden");
        check((await page.evaluate(() => window.failures.map(([name]) => name))).includes(id), "there was no event");
      } finally {
        await context.close();
      }
    });
  }
  await tap.test("npm: without WebAssembly payloads are drawn, and drawings say so", async () => {
    const context = await pages.browser.newContext();
    context.setDefaultTimeout(PATIENCE);
    try {
      const page = await context.newPage();
      await page.route(/worker[^/]*\.js$/, async (route) => {
        const answer = await route.fetch();
        await route.fulfill({ response: answer, body: `delete self.WebAssembly;\n${await answer.text()}` });
      });
      await page.goto(address);
      await ready(page, "payload");
      await checkPixel(page, "payload", [0.5, 0.05], [255, 0, 0, 255]);
      const why = await page.evaluate(() => document.getElementById("first").ready.then(() => "", (error) => error.message));
      check(why.includes("no WebAssembly"), why);
      check(await page.locator("#first img").isVisible(), "the still picture is hidden");
    } finally {
      await context.close();
    }
  });
}

/** Returns the memory of a browser's pages and their graphics, MB; null if the system does not report it. */
async function memoryOf(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  try {
    const kilobytes = processInfo
      .filter(({ type }) => ["renderer", "GPU"].includes(type))
      .map(({ id }) => Number(/^Pss:\s+(\d+)/m.exec(readFileSync(`/proc/${id}/smaps_rollup`, "utf8"))[1]));
    return kilobytes.reduce((sum, count) => sum + count, 0) / 1000;
  } catch {
    return null;
  }
}

async function testForty(browser, address) {
  const blank = await browser.newPage();
  const before = await memoryOf(browser);
  await blank.close();
  await visit(new Pages(browser), `${address}many.html`, {}, async (page) => {
    const seen = () => page.evaluate(() => [...document.querySelectorAll("sfumato-picture")].filter((picture) => picture.frames > 0).length);
    await page.waitForFunction(() => document.querySelectorAll("sfumato-picture")[0].frames > 0);
    check((await seen()) < 40, "those far below are drawn");
    for (let y = 0; y < 4000; y += 400) {
      await page.evaluate((to) => window.scrollTo(0, to), y);
      await frames(page, 5);
    }
    await page.evaluate(() => document.querySelectorAll("sfumato-picture")[39].scrollIntoView());
    await page.waitForFunction(() => document.querySelectorAll("sfumato-picture")[39].frames > 0);
    await page.waitForFunction(() => [...document.querySelectorAll("sfumato-picture")].filter((p) => p.frames > 0).length >= 36);
    check(page.workers().length <= 2, `${page.workers().length} workers`);
    const kept = await page.evaluate(() => [...document.querySelectorAll("sfumato-picture")].filter((p) => p.shadowRoot.querySelector("canvas").width > 1).length);
    check(kept < 40, "pictures out of sight keep their pixels");
    const megabytes = await memoryOf(browser);
    const grown = megabytes - before;
    console.log(`# ${megabytes?.toFixed(0)} MB, ${grown.toFixed(0)} more than an empty page; ${kept} pictures with pixels`);
    check(grown < 300, `${grown} MB`);
    await page.evaluate(() => window.scrollTo(0, 0));
    await page.waitForFunction(() => document.querySelector("sfumato-picture").shadowRoot.querySelector("canvas").width > 1);
  });
}

async function testMany(tap, { pages, address }) {
  await tap.test("npm: forty pictures of a page share a context, two workers and their memory", async () => {
    const other = await launch();
    try {
      await testForty(other, address);
    } finally {
      await other.close();
    }
  });
  await tap.test("npm: elements come, move and go", () =>
    visit(pages, address, { expected, ratio: 1 }, async (page) => {
      await ready(page, "first");
      await page.evaluate(() => {
        const picture = document.getElementById("first");
        document.querySelector("main").prepend(picture); // removed and added again
      });
      await page.waitForFunction(() => document.getElementById("first").shadowRoot.querySelector("canvas").hidden === false);
      await page.evaluate(() => document.getElementById("first").style.setProperty("width", "450px"));
      await page.waitForFunction(() => document.getElementById("first").shadowRoot.querySelector("canvas").width === 450);
      await page.evaluate(() => document.querySelectorAll("sfumato-picture").forEach((picture) => picture.remove()));
      // After a message has gone, no error remains.
      await frames(page, 10);
    }));
  await tap.test("npm: paper gets the whole picture", () =>
    visit(pages, `${address}print.html`, {}, async (page) => {
      await ready(page, "first");
      await settled(page, "first", "close");
      await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
      const size = await page.evaluate(async () => {
        const paper = document.getElementById("first").shadowRoot.getElementById("paper");
        await paper.decode();
        return [paper.naturalWidth, paper.naturalHeight];
      });
      checkEqual(size, [1200, 800], "the size of the page on paper");
      await page.evaluate(() => window.dispatchEvent(new Event("afterprint")));
      checkEqual(await page.evaluate(() => document.getElementById("first").shadowRoot.getElementById("paper")), null, "what is left");
    }));
}

export async function testManners(tap, pages, address) {
  const given = { pages, address };
  await testAccess(tap, given);
  await testLosses(tap, given);
  await testMany(tap, given);
}
