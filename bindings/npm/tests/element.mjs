// Tests what <sfumato-picture> shows, and how it reacts to pointers and keys.
import { mkdirSync } from "node:fs";
import { checkPixel, pixelOf, visit } from "./builds.mjs";
import { check, checkEqual, checkNear } from "./tools.mjs";

/** The page refers on purpose to a missing file and to one that is not a drawing. */
const expected = /status of 404/;

const ready = (page, id) => page.evaluate((name) => document.getElementById(name).ready, id);
const reason = (page, id) => page.evaluate((name) => document.getElementById(name).ready.then(() => "", (error) => error.message), id);
const viewOf = (page, id) => page.evaluate((name) => document.getElementById(name).view, id);
const isCanvasShown = (page, id) => page.evaluate((name) => !document.getElementById(name).shadowRoot.querySelector("canvas").hidden, id);

/** Resolves when nothing moves and the frame is as fine as possible. */
export const settled = (page, id, act) =>
  page.evaluate(([name, text]) => new Promise((resolve) => {
    const picture = document.getElementById(name);
    picture.addEventListener("settled", () => resolve(), { once: true });
    new Map([["mesh", () => (picture.mesh = !picture.mesh)], ["fit", () => picture.fit()],
      ["close", () => (picture.view = { x: 150, y: 100, zoom: 40 })],
      ["clear", () => picture.setAttribute("background", "none")]]).get(text)();
  }), [id, act]);

/** Resolves when the page has had this many frames. */
export const frames = (page, count) =>
  page.evaluate(async (most) => {
    for (let i = 0; i < most; ++i) await new Promise((resolve) => requestAnimationFrame(resolve));
  }, count);

async function testFirst(tap, { pages, address, shot }) {
  await tap.test("npm: drawings and payloads are drawn, and what is far below waits", () =>
    visit(pages, address, { expected }, async (page) => {
      for (const id of ["first", "second", "payload"]) {
        await ready(page, id);
        await checkPixel(page, id, [0.5, 0.05], [255, 0, 0, 255]);
        await checkPixel(page, id, [0.5, 0.95], [0, 0, 255, 255]);
      }
      checkEqual(await isCanvasShown(page, "far"), false, "what is far below is drawn");
      await shot(page, "plain");
      await page.evaluate(() => document.getElementById("far").scrollIntoView());
      await ready(page, "far");
      const textured = await pixelOf(page, "far", 0.5, 0.05);
      check(textured[0] > 180 && textured[1] > 140 && textured[2] < 40, `its texture: ${textured}`);
      await checkPixel(page, "far", [0.5, 0.95], [0, 128, 0, 255]);
      await shot(page, "texture");
    }));
  await tap.test("npm: an edge is as sharp when it is enlarged", () =>
    visit(pages, address, { expected }, async (page) => {
      await ready(page, "first");
      await settled(page, "first", "close");
      const rows = await page.evaluate(() => {
        const canvas = document.getElementById("first").shadowRoot.querySelector("canvas");
        const { data } = canvas.getContext("2d").getImageData(canvas.width >> 1, 0, 1, canvas.height);
        return Array.from({ length: canvas.height }, (_, y) => data[4 * y]);
      });
      const between = rows.filter((red) => red > 20 && red < 235).length;
      check(between <= 2, `${between} rows are neither red nor blue`);
      check(rows[2] > 235 && rows.at(-3) < 20, "the colours");
      await shot(page, "close");
    }));
  await tap.test("npm: the mesh is shown where it is asked for", () =>
    visit(pages, address, { expected }, async (page) => {
      await ready(page, "first");
      const before = await page.evaluate(() => document.getElementById("first").shadowRoot.querySelector("canvas").toDataURL());
      await settled(page, "first", "mesh");
      const after = await page.evaluate(() => document.getElementById("first").shadowRoot.querySelector("canvas").toDataURL());
      check(before !== after, "nothing has changed");
      await shot(page, "mesh");
    }));
}

async function testSources(tap, { pages, address }) {
  await tap.test("npm: gzipped drawings and deflated payloads are drawn, damaged ones refused", () =>
    visit(pages, address, { expected }, async (page) => {
      for (const src of ["halves.svgz", "packed.sfv"]) {
        await page.evaluate((name) => (document.getElementById("second").src = name), src);
        await ready(page, "second");
        await checkPixel(page, "second", [0.5, 0.95], [0, 0, 255, 255]);
      }
      await page.evaluate(() => (document.getElementById("second").src = "cut.sfv"));
      const why = await reason(page, "second");
      check(/\w/.test(why), "a payload that is cut short is drawn");
      checkEqual(await isCanvasShown(page, "second"), false, "its canvas");
    }));
  await tap.test("npm: of sources that change quickly the last one is shown", () =>
    visit(pages, address, { expected }, async (page) => {
      await page.evaluate(() => {
        const picture = document.getElementById("second");
        for (const src of ["gone.svg", "halves.svgz", "halves.sfv", "textured.svg"]) picture.src = src;
      });
      await ready(page, "second");
      await checkPixel(page, "second", [0.5, 0.95], [0, 128, 0, 255]);
    }));
  await tap.test('npm: background="none" shows what is behind', () =>
    visit(pages, address, { expected }, async (page) => {
      await page.evaluate(() => (document.getElementById("second").src = "clear.svg"));
      await ready(page, "second");
      await checkPixel(page, "second", [0.5, 0.05], [0, 255, 0, 255]);
      await settled(page, "second", "clear");
      checkEqual((await pixelOf(page, "second", 0.5, 0.05))[3], 0, "its alpha");
    }));
}

async function testWheel(tap, { pages, address, shot }) {
  await tap.test("npm: a wheel scrolls the page and hints; with Ctrl it zooms", () =>
    visit(pages, address, { expected }, async (page) => {
      await ready(page, "first");
      const { zoom } = await viewOf(page, "first");
      checkNear(zoom, 1, 0.01, "the zoom that fits");
      // A hint is shown for little more than a second, so each one is recorded.
      await page.evaluate(() => {
        const hint = document.getElementById("first").shadowRoot.getElementById("hint");
        window.hints = [];
        new MutationObserver(() => window.hints.push([hint.className, hint.textContent])).observe(hint, { attributeFilter: ["class"] });
      });
      await page.mouse.move(150, 130);
      await page.mouse.wheel(0, 200);
      await page.waitForFunction(() => window.scrollY > 100);
      checkEqual((await viewOf(page, "first")).zoom, zoom, "the zoom after a wheel");
      await page.evaluate(() => window.scrollTo(0, 0));
      await page.mouse.wheel(0, 1);
      // The hint fades in.
      await page.evaluate(() => Promise.all(document.getElementById("first").shadowRoot.getAnimations().map((one) => one.finished.catch(() => {}))));
      await shot(page, "hint");
      await page.waitForFunction(() => window.hints.at(-1)?.[0] === "");
      checkEqual(await page.evaluate(() => window.hints[0]), ["shown", "Ctrl + wheel zooms"], "the hint");
      await page.evaluate(() => window.scrollTo(0, 0));
      await page.keyboard.down("Control");
      await page.mouse.wheel(0, -300);
      await page.keyboard.up("Control");
      await page.waitForFunction(() => document.getElementById("first").view.zoom > 1.2);
      checkEqual(await page.evaluate(() => window.scrollY), 0, "the page after a wheel with Ctrl");
      await shot(page, "zoomed");
      await page.evaluate(() => document.getElementById("first").setAttribute("wheel", "zoom"));
      const before = (await viewOf(page, "first")).zoom;
      await page.mouse.wheel(0, -300);
      await page.waitForFunction((zoomed) => document.getElementById("first").view.zoom > zoomed, before);
    }));
  await tap.test("npm: without `interactive` nothing answers", () =>
    visit(pages, address, { expected }, async (page) => {
      await ready(page, "second");
      const before = await viewOf(page, "second");
      const box = await page.locator("#second").boundingBox();
      await page.mouse.move(box.x + 20, box.y + 20);
      await page.mouse.down();
      await page.mouse.move(box.x + 60, box.y + 60);
      await page.mouse.up();
      await page.evaluate(() => document.getElementById("second").dispatchEvent(new KeyboardEvent("keydown", { key: "+" })));
      await frames(page, 10);
      checkEqual(await viewOf(page, "second"), before, "the view");
    }));
}

async function testHands(tap, { pages, address }) {
  await tap.test("npm: dragging and double clicks move and zoom", () =>
    visit(pages, address, { expected, reducedMotion: "reduce" }, async (page) => {
      await ready(page, "first");
      await page.mouse.move(150, 130);
      await page.mouse.down();
      await page.mouse.move(130, 120, { steps: 3 });
      await page.mouse.up();
      const moved = await viewOf(page, "first");
      checkNear(moved.x, 170, 1, "x after a drag");
      checkNear(moved.y, 110, 1, "y after a drag");
      await page.mouse.dblclick(150, 130);
      await page.waitForFunction(() => document.getElementById("first").view.zoom > 1.9);
      checkEqual(await page.evaluate(() => document.activeElement.id), "first", "the focus");
    }));
  await tap.test("npm: keys move and zoom, and Tab leaves", () =>
    visit(pages, address, { expected, reducedMotion: "reduce" }, async (page) => {
      await ready(page, "first");
      await page.keyboard.press("Tab");
      checkEqual(await page.evaluate(() => document.activeElement.id), "first", "the focus after Tab");
      await page.keyboard.press("+");
      checkNear((await viewOf(page, "first")).zoom, 1.5, 0.01, "the zoom after +");
      await page.keyboard.press("ArrowRight");
      check((await viewOf(page, "first")).x > 190, "nothing has moved");
      await page.keyboard.press("0");
      checkEqual(await viewOf(page, "first"), { x: 150, y: 100, zoom: 1 }, "the view after 0");
      await page.keyboard.press("Tab");
      check((await page.evaluate(() => document.activeElement.id)) !== "first", "the focus is held");
    }));
  await tap.test("npm: one finger is the page's, two are the picture's", () =>
    visit(pages, address, { expected, hasTouch: true, reducedMotion: "reduce" }, async (page) => {
      await ready(page, "first");
      const session = await page.context().newCDPSession(page);
      const touch = (type, ...points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
      // The page may still scroll; only after that is the next wheel event a separate gesture.
      await page.evaluate(() => addEventListener("scrollend", () => (window.isScrolled = true), { once: true }));
      await touch("touchStart", [150, 160]);
      for (let i = 1; i <= 8; ++i) await touch("touchMove", [150, 160 - 10 * i]);
      await touch("touchEnd");
      await page.waitForFunction(() => window.isScrolled);
      check((await page.evaluate(() => window.scrollY)) > 0, "the page did not scroll");
      checkEqual(await viewOf(page, "first"), { x: 150, y: 100, zoom: 1 }, "the view after one finger");
      await page.evaluate(() => window.scrollTo(0, 0));
      await frames(page, 2);
      await touch("touchStart", [130, 130], [170, 130]);
      for (let i = 1; i <= 8; ++i) await touch("touchMove", [130 - 5 * i, 130], [170 + 5 * i, 130]);
      await touch("touchEnd");
      await page.waitForFunction(() => document.getElementById("first").view.zoom > 1.5);
    }));
}

async function testWords(tap, { pages, address, shot }) {
  await tap.test("npm: what cannot be drawn leaves its still picture and says why", () =>
    visit(pages, address, { expected }, async (page) => {
      const said = { missing: /gone\.svg: 404/, webpage: /answered with a web page/, broken: /broken\.svg:3:/ };
      for (const [id, words] of Object.entries(said)) {
        const why = await reason(page, id);
        check(words.test(why), `${id}: ${why}`);
        checkEqual(await isCanvasShown(page, id), false, `${id}: its canvas`);
        check(await page.locator(`#${id} img`).isVisible(), `${id}: its still picture is not shown`);
      }
      const failures = await page.evaluate(() => window.failures.map(([id]) => id).sort());
      checkEqual(failures, ["broken", "missing", "webpage"], "events");
      await page.evaluate(() => document.getElementById("broken").scrollIntoView());
      await shot(page, "fallback");
      await page.evaluate(() => (document.getElementById("broken").src = "halves.svg"));
      await ready(page, "broken");
      await checkPixel(page, "broken", [0.5, 0.05], [255, 0, 0, 255]);
    }));
}

export async function testElement(tap, pages, address, folder) {
  mkdirSync(folder, { recursive: true });
  const shot = (page, name) => page.screenshot({ path: `${folder}/${name}.png` });
  const given = { pages, address, shot };
  await testFirst(tap, given);
  await testSources(tap, given);
  await testWheel(tap, given);
  await testHands(tap, given);
  await testWords(tap, given);
}
