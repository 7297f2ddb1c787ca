// Pointers, wheel, keys, buttons, and changes of the window.
import { readFileSync } from "node:fs";
import { check, checkNear, difference, pictureOf, settled, show, viewOf } from "./harness.mjs";

const DOCUMENT = "tests/wasm/controls.svg";
const SIZE = [320, 240];
const MIDDLE = [160, 120];
/** Device pixels per CSS pixel, for tests that do not look at them: software draws a quarter of the pixels. */
const RATIO = 0.5;

/** Returns the artboard point under a point of the window. */
const pointAt = ({ x, y, zoom }, px, py) => [
  x + (px - MIDDLE[0]) / zoom,
  y + (py - MIDDLE[1]) / zoom,
];

function checkStays(before, after, px, py, what) {
  const [x0, y0] = pointAt(before, px, py),
    [x1, y1] = pointAt(after, px, py);
  check(
    Math.hypot(x1 - x0, y1 - y0) * after.zoom < 0.5,
    `${what}: the point under the pointer moved`,
  );
}

async function testPointers(test) {
  await test("the wheel zooms about the pointer", {}, async (page) => {
    const before = await viewOf(page);
    await page.mouse.move(200, 90);
    await page.mouse.wheel(0, -240);
    await settled(page);
    const near = await viewOf(page);
    check(near.zoom > 1.3 * before.zoom, "it did not come nearer");
    checkStays(before, near, 200, 90, "in");
    await page.mouse.wheel(0, 240);
    await settled(page);
    checkNear(
      (await viewOf(page)).zoom,
      before.zoom,
      0.01 * before.zoom,
      "the zoom after the way back",
    );
  });
  await test("dragging moves the picture with the pointer", {}, async (page) => {
    await show(page, { x: 60, y: 40, zoom: 8 });
    await page.mouse.move(100, 100);
    await page.mouse.down();
    await page.mouse.move(140, 120, { steps: 4 });
    await page.mouse.up();
    const after = await viewOf(page);
    checkNear(after.x, 60 - 40 / 8, 1e-6, "x");
    checkNear(after.y, 40 - 20 / 8, 1e-6, "y");
  });
  await test("a drag that leaves the window goes on", {}, async (page) => {
    await show(page, { x: 60, y: 40, zoom: 8 });
    await page.mouse.move(300, 100);
    await page.mouse.down();
    await page.mouse.move(400, 100, { steps: 4 });
    await page.mouse.up();
    checkNear((await viewOf(page)).x, 60 - 100 / 8, 1e-6, "x");
  });
  await test("a double click comes nearer there", {}, async (page) => {
    const before = await viewOf(page);
    await page.mouse.dblclick(100, 100);
    await settled(page);
    const after = await viewOf(page);
    checkNear(after.zoom, 2 * before.zoom, 1e-6, "zoom");
    checkStays(before, after, 100, 100, "double click");
  });
  await test("two fingers zoom and move", { touch: true }, async (page) => {
    await show(page, { x: 64, y: 48, zoom: 4 });
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...points) =>
      session.send("Input.dispatchTouchEvent", {
        type,
        touchPoints: points.map(([x, y]) => ({ x, y })),
      });
    await touch("touchStart", [120, 120], [200, 120]);
    for (let i = 1; i <= 8; ++i) await touch("touchMove", [120 - 5 * i, 120], [200 + 5 * i, 120]);
    await touch("touchEnd");
    const after = await viewOf(page);
    checkNear(after.zoom, 8, 0.05, "zoom");
    checkNear(after.x, 64, 0.5, "x");
  });
}

async function testKeys(test) {
  await test("keys move and zoom", {}, async (page) => {
    await show(page, { x: 64, y: 48, zoom: 8 });
    for (const [key, x, y] of [
      ["ArrowRight", 74, 48],
      ["ArrowDown", 74, 58],
      ["ArrowLeft", 64, 58],
      ["ArrowUp", 64, 48],
    ]) {
      await page.keyboard.press(key);
      await settled(page);
      const view = await viewOf(page);
      checkNear(view.x, x, 1e-6, `x after ${key}`);
      checkNear(view.y, y, 1e-6, `y after ${key}`);
    }
    await page.keyboard.press("+");
    await settled(page);
    checkNear((await viewOf(page)).zoom, 12, 1e-6, "zoom after +");
    await page.keyboard.press("-");
    await page.keyboard.press("-");
    await settled(page);
    checkNear((await viewOf(page)).zoom, 8 / 1.5, 1e-6, "zoom after two -");
    await page.keyboard.press("1");
    await settled(page);
    checkNear((await viewOf(page)).zoom, 1, 1e-6, "zoom after 1");
    check((await page.textContent("#percent")) === "100 %", "the read-out does not say 100 %");
  });
  await test("0 and the button fit the page into the window", {}, async (page) => {
    const fitted = await viewOf(page);
    for (const act of [() => page.keyboard.press("0"), () => page.click("#fit")]) {
      await show(page, { x: 10, y: 10, zoom: 20 });
      await act();
      await settled(page);
      const view = await viewOf(page);
      for (const name of ["x", "y", "zoom"]) checkNear(view[name], fitted[name], 1e-9, name);
    }
    check((await page.evaluate(() => location.hash)) === "", "the address holds a fitted view");
  });
  await test("F and the button fill the screen", {}, async (page) => {
    const isFull = () => page.evaluate(() => document.fullscreenElement !== null);
    await page.click("#full");
    await page.waitForFunction(() => document.fullscreenElement !== null);
    check(
      (await page.getAttribute("#full", "aria-pressed")) === "true",
      "the button is not pressed",
    );
    await page.keyboard.press("f");
    await page.waitForFunction(() => document.fullscreenElement === null);
    check(!(await isFull()), "it still fills the screen");
  });
  await test("? shows the keys, and Escape closes the list", {}, async (page) => {
    await page.keyboard.press("?");
    check(await page.isVisible("#keys-dialog"), "there is no list");
    const before = await viewOf(page);
    await page.keyboard.press("ArrowRight");
    check((await viewOf(page)).x === before.x, "a key moved the picture behind the list");
    await page.keyboard.press("Escape");
    check(!(await page.isVisible("#keys-dialog")), "the list is still there");
  });
  await test("every button can be reached and has a name", {}, async (page) => {
    await page.focus("#canvas");
    const names = [];
    for (let i = 0; i < 7; ++i) {
      await page.keyboard.press("Tab");
      names.push(await page.evaluate(() => document.activeElement?.textContent?.trim() ?? ""));
    }
    check(
      names.every((name) => name.length > 0),
      `a button has no name: ${names}`,
    );
    check(new Set(names).size === names.length, `not all are reached: ${names}`);
  });
}

async function testWindow(test, { PNG, command }) {
  await test("M and the button show the mesh", {}, async (page) => {
    const without = await pictureOf(page);
    await page.keyboard.press("m");
    await settled(page);
    const withMesh = await pictureOf(page);
    check(difference(PNG, without, withMesh).mean > 0.5, "there are no lines");
    check(await page.evaluate(() => window.sfumatoViewer.mesh), "mesh is not set");
    await page.evaluate(() => document.getElementById("mesh").click());
    await settled(page);
    check(difference(PNG, without, await pictureOf(page)).mean === 0, "the lines are still there");
  });
  await test("a fitted picture follows the size of the window", { ratio: 1 }, async (page) => {
    const before = await viewOf(page);
    await page.setViewportSize({ width: 640, height: 480 });
    await page.waitForFunction(() => document.getElementById("canvas").width === 640);
    await settled(page);
    check((await viewOf(page)).zoom > 1.8 * before.zoom, "it is not larger");
  });
  await test("two device pixels to a CSS pixel are drawn as such", { ratio: 2 }, async (page) => {
    const view = { x: 64, y: 48, zoom: 2.5 };
    check(
      (await page.evaluate(() => document.getElementById("canvas").width)) === 640,
      "the canvas is not 640 wide",
    );
    await show(page, view);
    const expected = command.raster(DOCUMENT, [640, 480], [0, 0, 128, 96]);
    const { mean } = difference(PNG, await pictureOf(page), expected);
    check(mean < 0.7, `mean difference ${mean}`);
  });
  await test("the address holds the view, and a reload shows it again", {}, async (page) => {
    await show(page, { x: 30, y: 40, zoom: 5 });
    const hash = await page.evaluate(() => location.hash);
    check(hash === "#30,40,5", `the address ends ${hash}`);
    await page.reload();
    await page.evaluate(() => window.sfumatoViewer.ready);
    checkNear((await viewOf(page)).zoom, 5, 1e-9, "zoom");
    checkNear((await viewOf(page)).x, 30, 1e-9, "x");
  });
  await test("a view that cannot be is brought near to one that can", {}, async (page) => {
    const before = await viewOf(page);
    await show(page, { x: NaN, y: "a", zoom: Infinity });
    check(
      JSON.stringify(await viewOf(page)) === JSON.stringify(before),
      "what is no number counts",
    );
    await show(page, { x: 1e9, y: -1e9, zoom: 1e12 });
    const { x, y, zoom } = await viewOf(page);
    check(x <= 128 && y >= -30 && zoom < 1e5, `it shows ${x}, ${y} at ${zoom}`);
  });
  await test("nothing is drawn while nothing changes", {}, async (page) => {
    await settled(page);
    const frames = () => page.evaluate(() => window.sfumatoViewer.frames);
    const before = await frames();
    await page.evaluate(async () => {
      for (let i = 0; i < 20; ++i) await new Promise((resolve) => requestAnimationFrame(resolve));
    });
    check((await frames()) === before, "frames were drawn");
    await page.keyboard.press("+");
    await settled(page);
    check((await frames()) > before, "no frame was drawn");
  });
  await test("who prefers less motion sees none", { reducedMotion: "reduce" }, async (page) => {
    const before = await viewOf(page);
    await page.keyboard.press("+");
    checkNear((await viewOf(page)).zoom, 1.5 * before.zoom, 1e-9, "zoom at once");
  });
  await test("a dark page has a dark desk", { colorScheme: "dark" }, async (page) => {
    await settled(page);
    const { data } = PNG.sync.read(await pictureOf(page));
    check(data[0] < 64 && data[1] < 64, `the corner is ${data[0]}, ${data[1]}`);
  });
}

export async function testInteraction(tap, tools) {
  const html = tools.command.html(DOCUMENT);
  check(readFileSync(html).length > 0, "no page");
  const test = (name, options, body) =>
    tap.test(name, () =>
      tools.pages.open(html, { size: SIZE, ratio: RATIO, ...options }, async (page) => {
        await settled(page);
        await body(page);
      }),
    );
  await testPointers(test);
  await testKeys(test);
  await testWindow(test, tools);
}
