// Tests how <sfumato-picture> loads, fails, waits and shares the workers, and what its `ready` says.
import { copyFileSync } from "node:fs";
import { join } from "node:path";
import { checkPixel, visit } from "./builds.mjs";
import { frames } from "./element.mjs";
import { check, checkEqual, pathOf } from "./tools.mjs";

const noise = /status of 404|<sfumato-picture>:|ERR_FAILED|Failed to load resource/;

/** Adds a picture to the page. */
const add = (page, id, attributes, inside = "") =>
  page.evaluate(([name, given, html]) => {
    const picture = document.createElement("sfumato-picture");
    picture.id = name;
    picture.innerHTML = html;
    for (const [key, value] of Object.entries(given)) picture.setAttribute(key, value);
    document.body.append(picture);
  }, [id, attributes, inside]);

/** Returns "ready", or how `ready` was rejected. */
const outcome = (page, id) =>
  page.evaluate((name) => document.getElementById(name).ready.then(() => "ready", (error) => `${error.name}: ${error.message}`), id);

const blank = (pages, address, options, body) => visit(pages, `${address}blank.html`, { expected: noise, ...options }, body);

async function testOrdinary(tap, { pages, address }) {
  await tap.test("npm: an ordinary SVG is an error in words, and its still picture stays", () =>
    blank(pages, address, {}, async (page) => {
      for (const name of ["logo", "card"]) {
        await add(page, name, { src: `${name}.svg` }, '<img src="still.png" alt="x">');
        const said = await outcome(page, name);
        check(/^SfumatoError: .*the picture is empty[^]*the attribute `import`/.test(said), said);
        check(await page.locator(`#${name} img`).isVisible(), "the still picture is hidden");
      }
      checkEqual(await page.evaluate(() => window.failures.map(([id]) => id)), ["logo", "card"], "events");
    }));
  await tap.test("npm: with `import` an ordinary SVG is drawn", () =>
    blank(pages, address, {}, async (page) => {
      await add(page, "a", { src: "logo.svg", import: "" });
      checkEqual(await outcome(page, "a"), "ready", "the outcome");
      await checkPixel(page, "a", [0.3, 0.5], [0xe0, 0x20, 0x20, 255]);
    }));
  await tap.test("npm: a texture that is missing is left out, and a warning says so", () =>
    blank(pages, address, {}, async (page) => {
      await add(page, "a", { src: "untextured.svg" });
      checkEqual(await outcome(page, "a"), "ready", "the outcome");
      const warnings = await page.evaluate(() => document.getElementById("a").warnings);
      check(warnings.length === 1 && /"gone\.png" is missing/.test(warnings[0]), JSON.stringify(warnings));
      await checkPixel(page, "a", [0.5, 0.95], [0, 128, 0, 255]);
    }));
  await tap.test("npm: the error is the class that both entries export, and names the address", () =>
    blank(pages, address, {}, async (page) => {
      await page.route("**/unreachable.svg", (route) => route.abort());
      for (const [src, words] of Object.entries({ "broken.svg": /broken\.svg:3:/, "unreachable.svg": /unreachable\.svg: the browser could not fetch/, "": /src is empty/, "cut.sfv": /cut\.sfv: ./ })) {
        const [isOne, message] = await page.evaluate((name) => new Promise((resolve) => {
          const picture = document.createElement("sfumato-picture");
          picture.addEventListener("error", ({ error, message: text }) =>
            resolve([error instanceof window.sfumato.SfumatoError && error instanceof window.sfumato.OfLibrary, text]));
          picture.src = name;
          document.body.append(picture);
        }), src);
        check(isOne && words.test(message), `${src}: ${isOne} ${message}`);
      }
    }));
}

async function testReady(tap, { pages, address }) {
  await tap.test("npm: `ready` settles, whatever becomes of the element", () =>
    blank(pages, address, {}, async (page) => {
      const said = await page.evaluate(async () => {
        const name = (promise) => promise.then(() => "ready", (error) => error.name);
        const made = (src, how = {}) => {
          const picture = document.createElement("sfumato-picture");
          if (src) picture.src = src;
          for (const [key, value] of Object.entries(how)) picture.setAttribute(key, value);
          return picture;
        };
        const all = {};
        all.without = name(made(null).ready);
        all.detached = name(made("halves.svg").ready);
        const [replaced, removed, hidden, far] = [made("halves.svg?1"), made("halves.svg?2"), made("halves.svg?3", { loading: "eager", hidden: "" }), made("halves.svg?4", { loading: "eager" })];
        const space = document.createElement("div");
        space.style.height = "9000px";
        document.body.append(replaced, removed, hidden, space, far);
        [all.replaced, all.removed, all.hidden, all.far] = [replaced, removed, hidden, far].map(({ ready }) => name(ready));
        replaced.src = "halves.svg?5";
        removed.remove();
        all.next = name(replaced.ready);
        return Object.fromEntries(await Promise.all(Object.entries(all).map(async ([key, promise]) => [key, await promise])));
      });
      checkEqual(said, { without: "EncodingError", detached: "ready", replaced: "AbortError", removed: "AbortError", hidden: "ready", far: "ready", next: "ready" }, "outcomes");
    }));
  await tap.test("npm: a failed `src` is tried again when it is set again or the element comes back", () =>
    blank(pages, address, {}, async (page) => {
      let isThere = false;
      await page.route(/late\.svg/, (route) => (isThere ? route.fulfill({ path: pathOf("bindings/npm/tests/site/public/halves.svg") }) : route.fulfill({ status: 404 })));
      for (const again of ["src", "move"]) {
        isThere = false;
        await add(page, again, { src: `late.svg?${again}` });
        check(/404/.test(await outcome(page, again)), "the first try");
        isThere = true;
        await page.evaluate((id) => {
          const picture = document.getElementById(id);
          if (id === "src") picture.src = picture.getAttribute("src");
          else document.body.prepend(picture);
        }, again);
        checkEqual(await outcome(page, again), "ready", again);
      }
    }));
  await tap.test("npm: a moved or removed element keeps its picture and its view", () =>
    blank(pages, address, {}, async (page) => {
      const asked = [];
      page.on("request", (request) => asked.push(request.url()));
      await add(page, "a", { src: "halves.svg" });
      await page.evaluate(() => (document.getElementById("a").view = { zoom: 4 }));
      checkEqual(await outcome(page, "a"), "ready", "the outcome");
      const viewOf = () => page.evaluate(() => document.getElementById("a").view);
      const before = await viewOf();
      checkEqual(before.zoom, 4, "the zoom that was set before there was a picture");
      const drawings = asked.length;
      for (const wait of [0, 300]) {
        const count = await page.evaluate(async (time) => {
          const picture = document.getElementById("a");
          const { frames: drawn } = picture;
          picture.remove();
          if (time > 0) await new Promise((resolve) => setTimeout(resolve, time));
          document.body.append(picture);
          return drawn;
        }, wait);
        await page.waitForFunction((drawn) => document.getElementById("a").frames > drawn, count);
        checkEqual(await viewOf(), before, "the view");
      }
      checkEqual(asked.length, drawings, "requests");
    }));
}

async function testWorkers(tap, { pages, address }) {
  await tap.test("npm: a small drawing does not wait for slow ones, and what is not wanted is cancelled", () =>
    blank(pages, address, {}, async (page) => {
      for (let i = 0; i < 2; ++i) await add(page, `slow${i}`, { src: `slow.svg?${i}`, "max-error": "0.002" });
      await page.waitForFunction(() => performance.getEntriesByType("resource").filter(({ name }) => name.includes("slow.svg")).length === 2);
      await frames(page, 5);
      await add(page, "a", { src: "halves.svg" });
      checkEqual(await outcome(page, "a"), "ready", "the small one");
      checkEqual(await page.evaluate(() => document.getElementById("slow0").frames + document.getElementById("slow1").frames), 0, "frames of slow ones");
      await page.evaluate(() => document.querySelectorAll("[id^=slow]").forEach((picture) => (picture.src = "halves.svg?1")));
      for (const id of ["slow0", "slow1"]) checkEqual(await outcome(page, id), "ready", id);
      // A worker that was ended disappears a little later.
      while (page.workers().length > 2) await page.waitForTimeout(50);
    }));
  await tap.test("npm: max-time ends a slow drawing, and a bare per cent sign is a name", () =>
    blank(pages, address, {}, async (page) => {
      await add(page, "slow", { src: "slow.svg", "max-error": "0.002", "max-time": "0.2" });
      check(/^SfumatoError: slow\.svg.*time/.test(await outcome(page, "slow")), await outcome(page, "slow"));
      await page.route("**/100%.svg", (route) => route.fulfill({ path: pathOf("bindings/npm/tests/site/public/halves.svg") }));
      await add(page, "a", { src: "100%.svg" });
      checkEqual(await outcome(page, "a"), "ready", "100%.svg");
    }));
}

const sizeOf = (page) => page.evaluate(() => {
  const { width, height } = document.getElementById("a").shadowRoot.querySelector("canvas");
  return [width, height];
});

async function testScreen(tap, { pages, address }) {
  await tap.test("npm: the canvas follows the pixel ratio and fractions of a pixel", () =>
    blank(pages, address, { ratio: 1 }, async (page) => {
      await add(page, "a", { src: "halves.svg" });
      checkEqual(await outcome(page, "a"), "ready", "the outcome");
      checkEqual(await sizeOf(page), [300, 200], "the size");
      await page.evaluate(() => Object.assign(document.getElementById("a").style, { width: "101.5px", height: "50.5px", margin: "0 0 0 0.25px" }));
      await page.waitForFunction(() => document.getElementById("a").shadowRoot.querySelector("canvas").width < 300);
      const told = await page.evaluate(() => new Promise((resolve) => {
        const box = document.getElementById("a").shadowRoot.getElementById("box");
        new ResizeObserver(([{ devicePixelContentBoxSize: [size] }]) => resolve([size.inlineSize, size.blockSize])).observe(box, { box: "device-pixel-content-box" });
      }));
      checkEqual(await sizeOf(page), told, "the size that the browser reports");
      const session = await page.context().newCDPSession(page);
      await session.send("Emulation.setDeviceMetricsOverride", { width: 1000, height: 800, deviceScaleFactor: 2, mobile: false });
      await page.waitForFunction(() => document.getElementById("a").shadowRoot.querySelector("canvas").width > 200);
    }));
  await tap.test('npm: "false" is no for boolean attributes', () =>
    blank(pages, address, {}, async (page) => {
      await add(page, "a", { src: "halves.svg", interactive: "false", mesh: "false" });
      const told = await page.evaluate(() => ["interactive", "mesh", "import"].map((name) => document.getElementById("a")[name]));
      checkEqual(told, [false, false, false], "properties");
    }));
  await tap.test("npm: printing loads a picture that was never near the screen", () =>
    blank(pages, address, { ratio: 1 }, async (page) => {
      await page.evaluate(() => document.body.append(Object.assign(document.createElement("div"), { style: "height: 9000px" })));
      await add(page, "a", { src: "halves.svg" });
      await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
      await page.waitForFunction(() => document.getElementById("a").shadowRoot.getElementById("paper"));
      await page.evaluate(() => window.dispatchEvent(new Event("afterprint")));
      await page.waitForFunction(() => document.getElementById("a").shadowRoot.querySelectorAll("img").length === 0);
    }));
  await tap.test("npm: where nothing is laid out, as in jsdom, the element has its role and says so", async () => {
    const context = await pages.browser.newContext();
    try {
      const page = await context.newPage();
      await page.addInitScript(() => {
        for (const name of ["ResizeObserver", "IntersectionObserver", "matchMedia"]) delete window[name];
        delete ElementInternals.prototype.states;
        delete CSSStyleSheet.prototype.replaceSync;
      });
      await page.goto(`${address}blank.html`);
      await add(page, "a", { src: "halves.svg", alt: "One" });
      const told = await page.evaluate(() => ["role", "aria-label"].map((name) => document.getElementById("a").getAttribute(name)));
      checkEqual(told, ["img", "One"], "role and label");
      check(/in browsers only/.test(await outcome(page, "a")), "the outcome");
    } finally {
      await context.close();
    }
  });
}

export async function testLoads(tap, pages, address, site) {
  copyFileSync(pathOf("examples/portrait.svg"), join(site, "slow.svg"));
  const given = { pages, address };
  await testOrdinary(tap, given);
  await testReady(tap, given);
  await testWorkers(tap, given);
  await testScreen(tap, given);
}
