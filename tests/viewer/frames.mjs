// The viewer in frames, on paper, and with slow drawing.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import {
  Skip,
  check,
  checkNear,
  difference,
  settled,
  shortName,
  show,
  viewOf,
} from "./harness.mjs";

const DOCUMENT = "tests/wasm/controls.svg";
/** The page's width and height. */
const PAGE = [128, 96];

/** Returns a long page with the viewer in a frame at its top. */
function pageWithFrame(command, name, hash) {
  const viewer = command.html(DOCUMENT);
  const path = command.file(`${name}.html`);
  writeFileSync(
    path,
    `<!DOCTYPE html><title>page</title><body style="margin:0;height:3000px">` +
      `<iframe src="${shortName(viewer)}${hash}" style="width:300px;height:200px;border:0">` +
      `</iframe></body>`,
  );
  return path;
}

async function inFrame(pages, path, options, body) {
  await pages.open(path, { ...options, broken: true }, async (page) => {
    const frame = page.frames()[1];
    await frame.waitForFunction(() => window.sfumatoViewer);
    await frame.evaluate(() => window.sfumatoViewer.ready);
    await frame.evaluate(() => window.sfumatoViewer.goLive());
    await settled(frame);
    await page.mouse.move(150, 80);
    await body(page, frame);
  });
}

const scrolled = (page) => page.evaluate(() => window.scrollY);

/** Does something that scrolls the page, and waits until it rests. */
async function scrolling(page, act) {
  await page.evaluate(() => {
    window.isScrolled = false;
    addEventListener("scrollend", () => (window.isScrolled = true), { once: true });
  });
  await act();
  await page.waitForFunction(() => window.isScrolled);
}

/** Turns the wheel over the picture, and waits until it has zoomed in. */
async function zooming(page, frame, delta) {
  const { zoom } = await viewOf(frame);
  await page.mouse.wheel(0, delta);
  await frame.waitForFunction((before) => window.sfumatoViewer.view.zoom > before, zoom);
  await settled(frame);
}

async function testFrames(tap, { command, pages }) {
  await tap.test("a frame takes no focus by itself", () =>
    inFrame(pages, pageWithFrame(command, "focus", ""), {}, async (page, frame) => {
      const active = await page.evaluate(() => document.activeElement?.tagName);
      check(active === "BODY", `${active} has the focus`);
      check(!(await frame.evaluate(() => document.hasFocus())), "the frame has the focus");
      check((await frame.$("[autofocus]")) === null, "something asks for the focus");
    }),
  );
  await tap.test("the picture is an image with a name", () =>
    inFrame(pages, pageWithFrame(command, "name", ""), {}, async (page, frame) => {
      check((await frame.getAttribute("#canvas", "role")) === "img", "it is no image");
      check((await frame.getAttribute("#canvas", "aria-label")) === "controls", "it has no name");
    }),
  );
  await tap.test("a wheel over a frame scrolls the page until the picture is clicked", () =>
    inFrame(pages, pageWithFrame(command, "frame", ""), {}, async (page, frame) => {
      const before = await viewOf(frame);
      await scrolling(page, () => page.mouse.wheel(0, 60));
      check((await scrolled(page)) > 0, "the page did not scroll");
      await settled(frame);
      checkNear((await viewOf(frame)).zoom, before.zoom, 1e-9, "the zoom");
      await page.mouse.click(150, 40);
      const rest = await scrolled(page);
      await zooming(page, frame, -60);
      check((await scrolled(page)) === rest, "the page scrolled too");
    }),
  );
}

async function testEmbedded(tap, { command, pages }) {
  const embedded = (name, options, body) =>
    inFrame(pages, pageWithFrame(command, name, "#embed"), options, body);
  await tap.test("#embed has no tools, and its wheel scrolls the page even after a click", () =>
    embedded("embed", {}, async (page, frame) => {
      check(!(await frame.isVisible("#tools")), "there are tools");
      const before = await viewOf(frame);
      checkNear(before.zoom, Math.min(300 / PAGE[0], 200 / PAGE[1]), 1e-9, "the zoom that fits");
      await page.mouse.click(150, 80);
      await scrolling(page, () => page.mouse.wheel(0, 60));
      check((await scrolled(page)) > 0, "the page did not scroll");
      await settled(frame);
      checkNear((await viewOf(frame)).zoom, before.zoom, 1e-9, "the zoom");
    }),
  );
  await tap.test("#embed zooms by Ctrl and the wheel, and its address says so", () =>
    embedded("embed-zoom", {}, async (page, frame) => {
      const before = await viewOf(frame);
      await page.keyboard.down("Control");
      await zooming(page, frame, -120);
      await page.keyboard.up("Control");
      const { zoom } = await viewOf(frame);
      check(zoom > 1.1 * before.zoom && zoom < 1.5 * before.zoom, `zoom ${zoom / before.zoom}`);
      check((await scrolled(page)) === 0, "the page scrolled too");
      const hash = await frame.evaluate(() => location.hash);
      check(/^#embed,[\d.]+,[\d.]+,[\d.]+$/.test(hash), `the address ends ${hash}`);
    }),
  );
  await tap.test("#embed leaves a finger to the page and takes two", () =>
    embedded("embed-touch", { hasTouch: true }, async (page, frame) => {
      const before = await viewOf(frame);
      const session = await page.context().newCDPSession(page);
      const touch = (type, ...points) =>
        session.send("Input.dispatchTouchEvent", {
          type,
          touchPoints: points.map(([x, y]) => ({ x, y })),
        });
      await scrolling(page, async () => {
        await touch("touchStart", [150, 150]);
        for (let i = 1; i <= 8; ++i) await touch("touchMove", [150, 150 - 10 * i]);
        await touch("touchEnd");
      });
      await settled(frame);
      check((await scrolled(page)) > 0, "the page did not scroll");
      check(JSON.stringify(await viewOf(frame)) === JSON.stringify(before), "the picture moved");
      await scrolling(page, () => page.evaluate(() => window.scrollTo(0, 0)));
      await touch("touchStart", [120, 100], [180, 100]);
      for (let i = 1; i <= 8; ++i) await touch("touchMove", [120 - 5 * i, 100], [180 + 5 * i, 100]);
      await touch("touchEnd");
      const isNearer = (zoom) => window.sfumatoViewer.view.zoom > zoom;
      await frame.waitForFunction(isNearer, 1.5 * before.zoom);
    }),
  );
  await tap.test("#embed may come and go without a new page", () =>
    pages.open(command.html(DOCUMENT), {}, async (page) => {
      const fitted = await viewOf(page);
      await page.evaluate(() => (location.hash = "#embed"));
      await settled(page);
      check(!(await page.isVisible("#tools")), "there are tools");
      check((await viewOf(page)).zoom > fitted.zoom, "their room is not used");
      await page.evaluate(() => (location.hash = ""));
      await settled(page);
      check(await page.isVisible("#tools"), "there are no tools");
    }),
  );
}

/** Returns the first printed page, one pixel per CSS pixel. */
async function printed(page, command, name) {
  const path = command.file(`${name}.pdf`);
  await page.pdf({ path, width: "400px", height: "400px", printBackground: true });
  try {
    execFileSync("pdftoppm", ["-png", "-r", "96", path, command.file(name)]);
  } catch (error) {
    if (error.code === "ENOENT") throw new Skip("there is no pdftoppm here");
    throw error;
  }
  return readFileSync(command.file(`${name}-1.png`));
}

async function testPaper(tap, { PNG, command, pages }) {
  /** Returns the expected content of paper of 400 pixels: the page as wide as the paper, white below. */
  const expected = () => {
    const width = 400,
      height = (width * PAGE[1]) / PAGE[0];
    const picture = PNG.sync.read(command.raster(DOCUMENT, [width, height], [0, 0, ...PAGE]));
    const paper = new PNG({ width, height: width });
    paper.data.fill(255);
    paper.data.set(picture.data);
    return PNG.sync.write(paper);
  };
  const checkPaper = (shown, what) => {
    const { mean, percentile } = difference(PNG, shown, expected());
    console.log(`# ${what}: mean ${mean.toFixed(3)}, 99th percentile ${percentile}`);
    check(mean < 2 && percentile < 12, `${what}: mean ${mean}, 99th percentile ${percentile}`);
  };
  await tap.test("paper has the whole picture on white", () =>
    pages.open(
      command.html(DOCUMENT),
      { colorScheme: "dark", before: smallTextures },
      async (page) => {
        await settled(page);
        checkPaper(await printed(page, command, "paper"), "whole");
      },
    ),
  );
  // As many pixels as the paper has.
  await tap.test("paper has the whole picture, whatever the window shows", () =>
    pages.open(command.html(DOCUMENT), { colorScheme: "dark" }, async (page) => {
      await show(page, { x: 10, y: 10, zoom: 40 });
      const before = await page.screenshot();
      checkPaper(await printed(page, command, "paper-near"), "from near");
      await settled(page);
      check((await page.$("#paper")) === null, "what was printed stays in the page");
      check(difference(PNG, before, await page.screenshot()).mean === 0, "the window has changed");
    }),
  );
  await tap.test("paper has the still picture where nothing can be drawn", () =>
    pages.open(
      command.html(DOCUMENT),
      { before: "HTMLCanvasElement.prototype.getContext = () => null", broken: true },
      async (page) => {
        await page.waitForFunction(() => !document.getElementById("message").hidden);
        await page.waitForFunction(() => !document.getElementById("fallback").hidden);
        const { mean } = difference(PNG, await printed(page, command, "paper-still"), expected());
        check(mean < 4, `mean difference ${mean}`);
      },
    ),
  );
}

/** Limits textures to a few pixels, because software would draw the whole paper for long. */
function smallTextures() {
  const { getParameter } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.getParameter = function (name) {
    return name === this.MAX_TEXTURE_SIZE ? 800 : getParameter.call(this, name);
  };
}

/** Makes every frame seem slow to the page. */
function slowClock() {
  const real = performance.now.bind(performance);
  const frame = window.requestAnimationFrame.bind(window);
  performance.now = () => 1e4 * real();
  window.requestAnimationFrame = (act) => frame(() => act(performance.now()));
}

async function testStill(tap, { PNG, command, pages }) {
  const boxOf = (page) =>
    page.evaluate(() => {
      const { x, y, width, height } = document.getElementById("fallback").getBoundingClientRect();
      return [x, y, width, height];
    });
  const opacity = (page) =>
    page.evaluate(() => getComputedStyle(document.getElementById("canvas")).opacity);
  await tap.test("where frames take over a second the still picture stands, and can be moved", () =>
    pages.open(command.html(DOCUMENT), { before: slowClock, isSlow: true }, async (page) => {
      await page.waitForSelector("#still", { state: "visible" });
      check(await page.evaluate(() => window.sfumatoViewer.still), "it does not say so");
      check(await page.isVisible("#fallback"), "there is no still picture");
      check((await opacity(page)) === "0", "the canvas is seen");
      const frames = await page.evaluate(() => window.sfumatoViewer.frames);
      await page.evaluate(() => {
        window.sfumatoViewer.view = { x: 64, y: 48, zoom: 5 };
      });
      await settled(page);
      const [left, top, width, height] = await boxOf(page);
      checkNear(left, 160 - 64 * 5, 0.1, "its left");
      checkNear(top, 120 - 48 * 5, 0.1, "its top");
      checkNear(width, 128 * 5, 0.1, "its width");
      checkNear(height, 96 * 5, 0.1, "its height");
      check((await page.evaluate(() => window.sfumatoViewer.frames)) === frames, "it was drawn");
    }),
  );
  await tap.test("a button goes from the still picture back to drawing", () =>
    pages.open(command.html(DOCUMENT), { before: slowClock, isSlow: true }, async (page) => {
      await page.waitForSelector("#still", { state: "visible" });
      await page.click("#live");
      await settled(page);
      check((await opacity(page)) === "1", "the canvas did not come back");
      check(!(await page.isVisible("#still")), "the way back is still there");
      check(!(await page.isVisible("#fallback")), "the still picture is still there");
    }),
  );
  await tap.test("a picture that waited long between quick frames is drawn on", () => {
    const idle = () => {
      const real = performance.now.bind(performance);
      let lead = 0;
      const frame = window.requestAnimationFrame.bind(window);
      performance.now = () => real() + lead;
      window.requestAnimationFrame = (act) => frame(() => act(performance.now()));
      window.wait = () => (lead += 60_000);
    };
    return pages.open(command.html(DOCUMENT), { before: idle, isSlow: true }, async (page) => {
      for (let i = 0; i < 4; ++i) {
        await settled(page);
        await page.evaluate((zoom) => {
          window.wait();
          window.sfumatoViewer.view = { zoom };
        }, 5 + i);
      }
      await settled(page);
      check(!(await page.evaluate(() => window.sfumatoViewer.still)), "it stands still");
    });
  });
  await tap.test("the still picture lies where the first frame will be", () =>
    pages.open(command.html(DOCUMENT), { before: slowClock, isSlow: true }, async (page) => {
      await page.waitForSelector("#still", { state: "visible" });
      await page.evaluate(() => (document.getElementById("still").style.visibility = "hidden"));
      const still = await page.screenshot();
      await page.evaluate(() => window.sfumatoViewer.goLive());
      await settled(page);
      const { mean } = difference(PNG, still, await page.screenshot());
      check(mean < 3, `mean difference ${mean}`);
    }),
  );
}

export async function testFramesAndPaper(tap, tools) {
  await testFrames(tap, tools);
  await testEmbedded(tap, tools);
  await testPaper(tap, tools);
  await testStill(tap, tools);
}
