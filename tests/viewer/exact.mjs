// Exact pixels, gathered in a page, compared with the library's.
import { readFileSync, writeFileSync } from "node:fs";
import { deflateSync, inflateSync } from "node:zlib";
import { PayloadError } from "../../web/viewer/bytes.js";
import { readExactLayers } from "../../web/viewer/exact_fields.js";
import { PictureReader } from "../../web/viewer/payload.js";
import { check, randomNumbers, settled, show } from "./harness.mjs";
import { withServer } from "./updates.mjs";

/** Limit in code values. */
const MOST_MISS = 0.05;

export const svg = (body, attributes = "") =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0.0371 0.0193 48 40" ${attributes}>${body}</svg>`;

/** Off the grid of pixels, so that no centre lies on a curve. */
const DOCUMENTS = {
  plain: svg(`<g sf:diffuse="true">
    <path d="M-5 30 C10 5 30 40 55 10" sf:left="#236, #fc8" sf:right="#264, #f00, #08f"/>
    <circle cx="15" cy="12" r="6.3" sf:left="#fff" sf:right="#420"/></g>`),
  "free ends": svg(`<g sf:diffuse="true">
    <path d="M8 30 C14 8 26 34 40 12" sf:left="#136" sf:right="#fe8"/>
    <path d="M30 35 L44 30" sf:left="#f00" sf:right="#0f0"/></g>`),
  blur: svg(`<g sf:diffuse="true">
    <path d="M-5 30 C10 5 30 40 55 10" sf:left="#136" sf:right="#fe8" sf:blur="2, 9"/>
    <circle cx="15" cy="12" r="7.3" sf:left="#fff" sf:right="#420" sf:blur="3"/></g>`),
  opacity: svg(`<g sf:diffuse="true">
    <path d="M-5 30 C10 5 30 40 55 10" sf:left="#136" sf:right="#fe8" sf:opacity="1, .2"/>
    <circle cx="15" cy="12" r="7.3" sf:left="#fff" sf:right="#420" sf:opacity=".9"/></g>`),
  linear: svg(
    `<g sf:diffuse="true"><path d="M-5 30 C10 5 30 40 55 10" sf:left="#113, #fc8" sf:right="#264"/></g>`,
    'sf:interpolation="linear"',
  ),
  oklab: svg(
    `<g sf:diffuse="true"><path d="M-5 30 C10 5 30 40 55 10" sf:left="#113, #fc8" sf:right="#264"/></g>`,
    'sf:interpolation="oklab"',
  ),
};

/** Further defines of the walk's program. */
const DEFINES = { blur: " WITH_BLUR", opacity: " WITH_OPACITY" };

const SIZE = [48, 40];
const WHOLE = [1, 0, 0, 1, -0.0371, -0.0193];

function documentOf(command, name) {
  const path = command.file(`exact_${name.replace(" ", "_")}.svg`);
  writeFileSync(path, DOCUMENTS[name]);
  return path;
}

export const payloadOf = (path) => readFileSync(path, "utf8").match(/id="payload">([^<]*)</)[1];

function pageOf(command, name) {
  const page = command.file(`exact_${name.replace(" ", "_")}.html`);
  command.run("render", documentOf(command, name), "-o", page, "--quiet");
  return page;
}

/** Returns the pixels that a page gathers from a payload. */
export async function gathered({ pages }, payload, wish) {
  let result = null;
  await withServer(payload, async (address) => {
    await pages.visit(address, {}, async (page) => {
      result = await page.evaluate(async (asked) => {
        const module = await import("/tests/viewer/exact_page.js");
        return module.gathered(asked);
      }, wish);
    });
  });
  return result;
}

/** Returns the library's pixels, 16 bits, as premultiplied code values from 0 to 1. */
function expectedOf({ command, PNG }, name) {
  const path = command.file("exact_expected.png");
  command.run("render", documentOf(command, name), "-o", path, "--method", "pixels", "--depth", 16, "--no-antialias",
    "--width", SIZE[0], "--height", SIZE[1], "--quiet");
  const { data, width, height } = PNG.sync.read(readFileSync(path), { skipRescale: true });
  check(width === SIZE[0] && height === SIZE[1], `it is ${width} x ${height}`);
  return data;
}

export function compare(expected, pixels) {
  let miss = 0,
    found = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = pixels[i + 3];
    if (alpha < 0) continue;
    found += 1;
    for (let c = 0; c < 3; ++c) {
      const value = expected[i + c] / 65535;
      miss = Math.max(miss, 255 * alpha * Math.abs(pixels[i + c] - value));
    }
    miss = Math.max(miss, 255 * Math.abs(alpha - expected[i + 3] / 65535));
  }
  return { miss, found };
}

async function testPixels(tap, tools) {
  for (const name of Object.keys(DOCUMENTS)) {
    await tap.test(`exact pixels are the library's: ${name}`, async () => {
      const payload = payloadOf(pageOf(tools.command, name));
      const wish = { size: SIZE, views: [WHOLE] };
      const { pixels, error, programs } = await gathered(tools, payload, wish);
      const walks = programs.filter((program) => program.startsWith("screen exact "));
      check(walks.join() === `screen exact WITH_WALK${DEFINES[name] ?? ""}`, `it ran ${walks}`);
      const { miss, found } = compare(expectedOf(tools, name), pixels);
      console.log(`# ${found} of ${pixels.length / 4} pixels, at most ${miss.toFixed(4)} off`);
      check(error === 0, `GL says ${error}`);
      check(found > 0.8 * SIZE[0] * SIZE[1], `only ${found} pixels were gathered`);
      check(miss <= MOST_MISS, `${miss} code values off`);
    });
  }
}

/** Returns where a row changes from its left value to its right one, from the share that equals the left. */
function crossing(pixels, width, row) {
  const at = (x) => pixels[4 * (width * row + x)];
  const left = at(0),
    right = at(width - 1);
  let sum = 0;
  for (let x = 0; x < width; ++x) sum += (at(x) - right) / (left - right);
  return sum;
}

/** Returns the largest distance of points from their best parabola. */
function strayOf(values) {
  const n = values.length;
  const basis = values.map((_, i) => {
    const t = (2 * i + 1) / n - 1;
    return [1, t, 1.5 * t * t - 0.5];
  });
  // Legendre polynomials are nearly orthogonal on even steps; two passes suffice.
  let rest = values;
  for (let pass = 0; pass < 8; ++pass) {
    for (let k = 0; k < 3; ++k) {
      const dot = rest.reduce((sum, v, i) => sum + v * basis[i][k], 0);
      const size = basis.reduce((sum, row) => sum + row[k] ** 2, 0);
      rest = rest.map((v, i) => v - (dot / size) * basis[i][k]);
    }
  }
  return Math.max(...rest.map(Math.abs));
}

async function testZoom(tap, tools) {
  for (const zoom of [64, 1000]) {
    await tap.test(`outlines are curves at ${zoom} times`, async () => {
      const payload = payloadOf(pageOf(tools.command, "plain"));
      const view = [zoom, 0, 0, zoom, SIZE[0] / 2 - zoom * 21.3, SIZE[1] / 2 - zoom * 12];
      const { pixels } = await gathered(tools, payload, { size: SIZE, views: [view] });
      const rows = Array.from({ length: SIZE[1] }, (_, row) => crossing(pixels, SIZE[0], row));
      const stray = strayOf(rows);
      console.log(`# the outline strays ${stray.toFixed(3)} pixels from a parabola`);
      check(Math.min(...rows) > 1 && Math.max(...rows) < SIZE[0] - 1, "the outline is not there");
      check(stray < 0.2, `it strays ${stray} pixels`);
      check(pixels.every((value) => value >= 0), "a pixel is not there");
    });
  }
}

async function testLimit(tap, tools) {
  await tap.test("a pixel that takes too many steps is left to the patches", async () => {
    const payload = payloadOf(pageOf(tools.command, "plain"));
    const wish = { size: SIZE, views: [WHOLE], limit: 1 };
    const { pixels } = await gathered(tools, payload, wish);
    const { miss, found } = compare(expectedOf(tools, "plain"), pixels);
    check(found < 0.5 * SIZE[0] * SIZE[1], `${found} pixels need no more than a step`);
    check(miss <= MOST_MISS, `${miss} code values off`);
  });
}

async function testCache(tap, tools) {
  const payload = payloadOf(pageOf(tools.command, "plain"));
  const moved = [...WHOLE.slice(0, 4), WHOLE[4] - 5, WHOLE[5] + 3];
  await tap.test("a view that is moved by whole pixels keeps what was gathered", async () => {
    const whole = await gathered(tools, payload, { size: SIZE, views: [moved] });
    const kept = await gathered(tools, payload, { size: SIZE, views: [WHOLE, moved] });
    const all = SIZE[0] * SIZE[1];
    check(whole.worked === all, `${whole.worked} pixels were asked for`);
    check(kept.worked === all - (SIZE[0] - 5) * (SIZE[1] - 3), `${kept.worked} pixels`);
    const worst = kept.pixels.reduce(
      (most, value, i) => Math.max(most, Math.abs(value - whole.pixels[i])),
      0,
    );
    check(worst < 1e-4, `they differ by ${worst}`);
  });
}

async function testPage(tap, tools) {
  const html = pageOf(tools.command, "plain");
  const stateOf = (page) => page.evaluate(() => window.sfumatoViewer.exactState);
  await tap.test("the button and its key switch exact pixels, and say so", () =>
    tools.pages.open(html, { size: [200, 160] }, async (page) => {
      await settled(page);
      check((await stateOf(page)) === "off", "it is on where the driver is software");
      await page.click("#exact");
      await settled(page);
      check((await stateOf(page)).includes("exact but"), `it says ${await stateOf(page)}`);
      check((await page.getAttribute("#exact", "aria-pressed")) === "true", "it is not pressed");
      await show(page, { zoom: 100 });
      check((await stateOf(page)).includes("16 points"), `it says ${await stateOf(page)}`);
      check((await page.getAttribute("#exact", "title")).includes("16 points"), "the title differs");
      await page.keyboard.press("e");
      await settled(page);
      check((await page.getAttribute("#exact", "aria-pressed")) === "false", "it is pressed");
    }),
  );
  await tap.test("in a narrow window the word stands on the button, and nothing is cut", () =>
    tools.pages.open(html, { size: [320, 200] }, async (page) => {
      await page.click("#exact");
      await show(page, { zoom: 40000 });
      const boxes = await page.evaluate(() =>
        ["#tools", "#tools button", "#exact", "#exact-state"].map((name) =>
          [...document.querySelectorAll(name)].map((it) => {
            const { left, top, right, bottom } = it.getBoundingClientRect();
            return [left, top, right, bottom];
          }),
        ),
      );
      const isIn = (a, b) => a[0] >= b[0] && a[1] >= b[1] && a[2] <= b[2] && a[3] <= b[3];
      const [[tools], buttons, [button], [word]] = boxes;
      check(isIn(tools, [0, 0, 320, 200]), `the buttons take ${tools}`);
      check(buttons.every((box) => isIn(box, tools)), `a button is cut: ${buttons}`);
      check(word[2] - word[0] > 20 && isIn(word, button), `the word takes ${word} of ${button}`);
    }),
  );
  await tap.test("exact pixels come back after the graphics were lost", () =>
    tools.pages.open(html, { size: [160, 120] }, async (page) => {
      await page.evaluate(() => {
        window.sfumatoViewer.exact = true;
        const gl = document.getElementById("canvas").getContext("webgl2");
        window.lose = gl.getExtension("WEBGL_lose_context");
      });
      // In the middle of the work, or at its end on a quick machine.
      await page.waitForFunction(() => {
        const isBegun = /^(gathered [1-9]|exact)/.test(window.sfumatoViewer.exactState);
        if (isBegun) window.lose.loseContext();
        return isBegun;
      });
      await page.waitForFunction(() => !document.getElementById("message").hidden);
      await page.evaluate(() => window.lose.restoreContext());
      await page.waitForFunction(() => document.getElementById("message").hidden);
      await settled(page);
      check((await stateOf(page)).includes("exact"), `it says ${await stateOf(page)}`);
    }),
  );
  await tap.test("a file without curves says that there are none", () => {
    const path = tools.command.file("exact_none.html");
    const text = readFileSync(html, "utf8");
    const bytes = inflateSync(Buffer.from(payloadOf(html), "base64"));
    const { exact } = new PictureReader(new Uint8Array(bytes)).run();
    const rest = bytes.subarray(0, bytes.length - exact.length);
    writeFileSync(path, text.replace(payloadOf(html), deflateSync(rest).toString("base64")));
    return tools.pages.open(path, {}, async (page) => {
      await page.click("#exact");
      await settled(page);
      check((await stateOf(page)).includes("holds no curves"), `it says ${await stateOf(page)}`);
    });
  });
}

/** A window size at which pictures of 20 layers take 288 MB. */
const LARGE = [1500, 1200];

async function testRoom(tap, { command, pages }) {
  const path = command.file("exact_room.svg");
  const discs = Array.from({ length: 20 }, (_, i) =>
    `<use href="#a" x="${(i % 5) * 9}" y="${Math.floor(i / 5) * 9}"/>`);
  writeFileSync(path, svg(`<defs><g id="a" sf:diffuse="true">
    <circle cx="2" cy="2" r=".9" sf:left="none" sf:right="#fe8, #136"/></g></defs>${discs.join("")}`));
  const html = command.file("exact_room.html");
  command.run("render", path, "-o", html, "--quiet");
  const stateOf = (page) => page.evaluate(() => window.sfumatoViewer.exactState);
  await tap.test("a window too large for so many layers has none until it is smaller", () =>
    pages.open(html, { size: LARGE }, async (page) => {
      await settled(page);
      await page.click("#exact");
      await settled(page);
      check((await stateOf(page)).includes("too many pixels"), `it says ${await stateOf(page)}`);
      check((await page.textContent("#exact-state")) === "None", "the button says something else");
      check((await page.getAttribute("#exact", "aria-disabled")) === "false", "it is disabled");
      await page.setViewportSize({ width: 160, height: 120 });
      await page.waitForFunction(() => !/too many/.test(window.sfumatoViewer.exactState));
      await settled(page);
      check((await stateOf(page)).includes("exact"), `it says ${await stateOf(page)}`);
      await page.setViewportSize({ width: LARGE[0], height: LARGE[1] });
      await page.waitForFunction(() => /too many/.test(window.sfumatoViewer.exactState));
      await page.click("#exact");
      await settled(page);
      check((await stateOf(page)) === "off", `it says ${await stateOf(page)}`);
    }),
  );
}

const DAMAGES = 2000;

function testDamage(tap, { command }) {
  return tap.test("damaged curves are refused, never a crash", () => {
    const random = randomNumbers(11);
    let refused = 0;
    for (const name of ["blur", "opacity"]) {
      const packed = Buffer.from(payloadOf(pageOf(command, name)), "base64");
      const picture = new PictureReader(new Uint8Array(inflateSync(packed))).run();
      check(readExactLayers(picture.exact, picture.layers)[0] !== null, "it has no curves");
      for (let i = 0; i < DAMAGES; ++i) {
        const damaged = picture.exact.slice(0, i % 5 ? undefined : random.next().value % picture.exact.length);
        for (let k = 0; k < 1 + (i % 3) && damaged.length > 0; ++k)
          damaged[random.next().value % damaged.length] = random.next().value & 255;
        try {
          readExactLayers(damaged, picture.layers);
        } catch (error) {
          if (!(error instanceof PayloadError)) throw error;
          refused += 1;
        }
      }
    }
    check(refused > DAMAGES / 5, `only ${refused} were refused`);
  });
}

export async function testExact(tap, tools) {
  await testDamage(tap, tools);
  await testPixels(tap, tools);
  await testZoom(tap, tools);
  await testLimit(tap, tools);
  await testCache(tap, tools);
  await testPage(tap, tools);
  await testRoom(tap, tools);
}
