// The page of `sfumato watch`: its content while a drawing changes, and its appearance.
import { spawn } from "node:child_process";
import { writeFileSync } from "node:fs";
import { PATIENCE, check, checkNear, shortName } from "./harness.mjs";

/** Returns a disc of a colour on white. */
const drawing = (color) =>
  `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 64 48"
     sf:version="1">
  <g sf:diffuse="true">
    <circle cx="32" cy="24" r="16" sf:left="white" sf:right="${color}"/>
  </g>
</svg>`;

const RED = [255, 0, 0];
const BLUE = [0, 0, 255];

/** The running command on its own file, from `start` to `stop`. */
class Watch {
  constructor(command, name) {
    this.program = command.program;
    this.file = command.file(`${name}.svg`);
    this.port = 0;
  }

  draw(text) {
    writeFileSync(this.file, text);
  }

  async start() {
    this.child = spawn(this.program, ["watch", this.file, "--port", this.port, "--quiet"], {
      stdio: ["ignore", "pipe", "ignore"],
    });
    this.ended = new Promise((resolve) => this.child.once("exit", resolve));
    const printed = new Promise((resolve) => this.child.stdout.once("data", resolve));
    const word = await Promise.race([printed, this.ended]);
    this.address = String(word).trim();
    check(/^http:.*:\d+\/$/.test(this.address), `it printed ${this.address}`);
    this.port = new URL(this.address).port;
  }

  async stop() {
    this.child.kill("SIGTERM");
    await this.ended;
  }
}

/** Watches a file with a page that has shown its first picture. */
async function watched({ command, pages }, name, options, body) {
  const watch = new Watch(command, name);
  watch.draw(drawing("red"));
  await watch.start();
  try {
    await pages.visit(watch.address, options, async (page) => {
      await says(page, "drawn in");
      await body(page, watch);
    });
  } finally {
    await watch.stop();
  }
}

const says = (page, words) =>
  page.waitForFunction((text) => document.getElementById("status").textContent.includes(text), words);

/** Returns the visible colour in the middle of the picture. */
async function seenColor({ PNG }, page) {
  const { x, y, width, height } = await page.locator("#picture").boundingBox();
  const clip = { x: Math.floor(x + width / 2), y: Math.floor(y + height / 2), width: 1, height: 1 };
  const { data } = PNG.sync.read(await page.screenshot({ clip }));
  return [...data.subarray(0, 3)];
}

/** Waits until the middle of the picture has a colour, which comes a moment after the text. */
async function shows(tools, page, color) {
  let seen = [];
  for (const end = performance.now() + PATIENCE; performance.now() < end; await page.waitForTimeout(20)) {
    seen = await seenColor(tools, page);
    if (String(seen) === String(color)) return;
  }
  throw new Error(`the picture is ${seen}, expected ${color}`);
}

/** Expects that the picture fits into the stage without scrolling. */
async function checkFits(page) {
  const rest = await page.evaluate(() => {
    const { scrollWidth, scrollHeight, clientWidth, clientHeight } =
      document.getElementById("stage");
    return [
      scrollWidth - clientWidth,
      scrollHeight - clientHeight,
      document.documentElement.scrollWidth - innerWidth,
      document.documentElement.scrollHeight - innerHeight,
    ];
  });
  check(Math.max(...rest) <= 0, `it is larger than the window by ${rest}`);
}

/** Messages of the browser while no server answers. */
const SERVER_GONE = /ERR_(CONNECTION|SOCKET|EMPTY|INCOMPLETE)/;

async function testChanges(tap, tools) {
  await tap.test("the page shows the newest picture without being loaded again", () =>
    watched(tools, "newest", {}, async (page, watch) => {
      await shows(tools, page, RED);
      await page.evaluate(() => (window.isTheSame = true));
      watch.draw(drawing("blue"));
      await shows(tools, page, BLUE);
      check(await page.evaluate(() => window.isTheSame), "it was loaded again");
      check((await page.title()).includes(shortName(watch.file)), "its title has no name");
    }),
  );
  await tap.test("a wrong drawing shows its messages and the last good picture until it is right", () =>
    watched(tools, "wrong", {}, async (page, watch) => {
      await shows(tools, page, RED);
      check(!(await page.isVisible("#messages")), "there are messages about a good drawing");
      watch.draw(drawing("nonsense"));
      await says(page, "not drawn: the last good picture is shown");
      const messages = await page.textContent("#messages");
      check(/:4:5: error: .*"nonsense" is not a colour/.test(messages), `it says ${messages}`);
      check((await page.title()).startsWith("✗"), "its title does not say so");
      await shows(tools, page, RED);
      await checkFits(page);
      watch.draw(drawing("blue"));
      await shows(tools, page, BLUE);
      await says(page, "drawn in");
      check(!(await page.isVisible("#messages")), "the messages stay");
    }),
  );
  await tap.test("the page comes back when the command is started anew at its port", () =>
    watched(tools, "anew", { harmless: SERVER_GONE }, async (page, watch) => {
      await shows(tools, page, RED);
      await watch.stop();
      await says(page, "does not answer");
      await shows(tools, page, RED);
      watch.draw(drawing("nonsense"));
      await watch.start();
      await says(page, "not drawn: the last good picture is shown");
      await watch.stop();
      watch.draw(drawing("blue"));
      await watch.start();
      await shows(tools, page, BLUE);
      await says(page, "drawn in");
    }),
  );
  await tap.test("a zoom stays when the picture changes", () =>
    watched(tools, "zoom", {}, async (page, watch) => {
      await checkFits(page);
      await page.keyboard.press("1");
      checkNear((await page.locator("#picture").boundingBox()).width, 64, 1e-3, "its width");
      await page.click("#larger");
      watch.draw(drawing("blue"));
      await shows(tools, page, BLUE);
      checkNear((await page.locator("#picture").boundingBox()).width, 80, 1e-3, "its width");
      check((await page.textContent("#zoom")) === "125%", "the page shows another zoom");
      await page.keyboard.press("0");
      await checkFits(page);
    }),
  );
}

/** Returns the contrast of an element's text with the page's ground (WCAG 2.2, 1.4.3). */
const contrastOf = (page, selector) =>
  page.evaluate((of) => {
    const canvas = document.createElement("canvas");
    const pen = canvas.getContext("2d", { willReadFrequently: true });
    document.body.append(canvas);
    canvas.style.color = "Canvas";
    const luminance = () => {
      const linear = [...pen.getImageData(0, 0, 1, 1).data].map((value) =>
        value <= 10 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4,
      );
      return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
    };
    const paint = (color, alpha) => {
      pen.fillStyle = color;
      pen.globalAlpha = alpha;
      pen.fillRect(0, 0, 1, 1);
      return luminance();
    };
    const words = getComputedStyle(document.querySelector(of));
    const ground = paint(getComputedStyle(canvas).color, 1);
    const ink = paint(words.color, Number(words.opacity));
    canvas.remove();
    return (Math.max(ground, ink) + 0.05) / (Math.min(ground, ink) + 0.05);
  }, selector);

const LEAST_CONTRAST = 4.5;

/** Keeps screenshots in the tests' folder, for people to look at. */
async function testLooks(tap, tools) {
  const { command } = tools;
  for (const size of [
    [1280, 720],
    [320, 568],
  ]) {
    for (const colorScheme of ["light", "dark"]) {
      const look = `${size[0]}-${colorScheme}`;
      await tap.test(`the page of watch is whole and legible: ${size[0]} pixels, ${colorScheme}`, () =>
        watched(
          tools,
          `a-drawing-of-${"a-very-".repeat(8)}long-name-${look}`,
          { size, colorScheme },
          async (page, watch) => {
            await shows(tools, page, RED);
            await page.screenshot({ path: command.file(`watch-${look}-good.png`) });
            await checkFits(page);
            check((await contrastOf(page, "#status")) >= LEAST_CONTRAST, "the words are pale");
            watch.draw(drawing("nonsense"));
            await says(page, "not drawn");
            await page.screenshot({ path: command.file(`watch-${look}-wrong.png`) });
            await checkFits(page);
            for (const part of ["#name", "#status", "#messages", "#zoom"]) {
              const contrast = await contrastOf(page, part);
              check(contrast >= LEAST_CONTRAST, `${part} has a contrast of ${contrast}`);
            }
            const { height } = await page.locator("#stage").boundingBox();
            check(height > size[1] / 3, `the picture has ${height} pixels of ${size[1]}`);
          },
        ),
      );
    }
  }
}

export async function testWatch(tap, tools) {
  await testChanges(tap, tools);
  await testLooks(tap, tools);
}
