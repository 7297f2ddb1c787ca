// Films the first screen of README.md in the editor: a horizon and a sun are drawn and coloured, the sun is
// dragged, and its edge is enlarged. scripts/make-animation packs the frames.
//
//   node tests/editor/e2e/animation.mjs BUILD_FOLDER FRAMES
//
// Writes FRAMES/000.png, 001.png, …, and FRAMES/durations: a frame's name and milliseconds per line.
import { mkdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { MESA } from "../../chromium.mjs";
import { Artist } from "./artist.mjs";
import { EditorPage, launch, serve } from "./harness.mjs";

/** Milliseconds that a frame is shown: while the pointer moves, after a step, and at the end. */
const MOVING = 60;
const STEP = 500;
const END = 2000;
/** Milliseconds after which the page shows the picture of a moved pointer. */
const DRAWN = 120;
const BLUR = "Blur, radius of point 1";

/** Shows where the pointer is: screenshots leave it out. Runs in the page. */
function showPointer() {
  const arrow = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const shape = document.createElementNS(arrow.namespaceURI, "path");
  shape.setAttribute("d", "M1 1V17L5 13.4L7.8 19.4L10.4 18.2L7.7 12.4H13Z");
  shape.setAttribute("fill", "white");
  shape.setAttribute("stroke", "black");
  arrow.append(shape);
  Object.assign(arrow.style, { position: "fixed", left: 0, top: 0, width: "24px", height: "24px" });
  Object.assign(arrow.style, { zIndex: 2147483647, pointerEvents: "none" });
  document.body.append(arrow);
  const follow = ({ clientX, clientY }) => (arrow.style.translate = `${clientX}px ${clientY}px`);
  addEventListener("pointermove", follow, { capture: true });
}

/** Films an editor: each frame is a picture of its window. */
class Camera {
  #durations = [];

  constructor(editor, folder) {
    this.editor = editor;
    this.page = editor.page;
    this.folder = folder;
  }

  /** Adds a frame that is shown for so many milliseconds. */
  async take(milliseconds) {
    const name = `${String(this.#durations.length).padStart(3, "0")}.png`;
    await this.page.screenshot({ path: join(this.folder, name), caret: "initial" });
    this.#durations.push(`${name} ${milliseconds}\n`);
  }

  /** Does something, and films the exact picture after it. */
  async step(act, milliseconds = STEP) {
    await act();
    await this.editor.settled();
    await this.take(milliseconds);
  }

  /** Moves the pointer through points of the artboard, a frame each. */
  async follow(points) {
    for (const place of await this.editor.all(points)) {
      await this.page.mouse.move(...place);
      await sleep(DRAWN);
      await this.take(MOVING);
    }
  }

  /** Presses the pointer at the first of some points, and films the drag through the rest. */
  async drag(points) {
    await this.page.mouse.move(...(await this.editor.at(...points[0])));
    await this.page.mouse.down();
    await this.follow(points.slice(1));
    await this.page.mouse.up();
    await this.editor.settled();
    await this.take(STEP);
  }

  end() {
    writeFileSync(join(this.folder, "durations"), this.#durations.join(""));
  }
}

const steps = (count, at) => Array.from({ length: count + 1 }, (_, k) => at(k / count));

/** A horizon with hills, from left to right. */
const horizon = steps(14, (t) => [-8 + 496 * t, 212 - 16 * Math.sin(6 * t) - 9 * Math.sin(13 * t)]);

/** The sun where it is drawn, and how far it is dragged. */
const sun = { x: 340, y: 150, radius: 30, byX: -170, byY: -62 };

/** A point at the sun's lower right edge, before the drag. */
const edge = [sun.x + sun.radius * Math.SQRT1_2, sun.y + sun.radius * Math.SQRT1_2];

/** The way of that point: an arc. */
const way = steps(20, (t) => [edge[0] + sun.byX * t, edge[1] + sun.byY * Math.sin((Math.PI * t) / 2)]);

/** Nodes of a circle for the pen, clockwise from the left: [x, y, handle's x, handle's y]. */
const circle = [180, 270, 360, 450].map((degrees) => {
  const angle = (degrees * Math.PI) / 180;
  const [x, y] = [sun.radius * Math.cos(angle), sun.radius * Math.sin(angle)];
  return [sun.x + x, sun.y + y, sun.x + x - 0.5523 * y, sun.y + y + 0.5523 * x];
});

async function drawHorizon(camera, artist) {
  await artist.tool("Pencil");
  await camera.take(STEP);
  await camera.drag(horizon);
}

/** A line above the artboard gives the sky its upper colours. New curves take the colours at their place. */
async function drawSky(camera, artist) {
  await camera.step(() => artist.curve([[-30, -10], [510, -10]]));
}

async function drawSun(camera, artist) {
  const { page } = camera;
  await artist.tool("Pen");
  for (const [x, y, toX, toY] of [...circle, circle[0]]) {
    await camera.follow([[x, y]]);
    await page.mouse.down();
    await camera.follow([[(x + toX) / 2, (y + toY) / 2], [toX, toY]]);
    await page.mouse.up();
  }
}

async function colourSun(camera, artist) {
  await camera.step(() => artist.color("Inside", 0, "fff3c8"));
  await camera.step(() => artist.color("Outside", 0, "ffb46a"));
  await camera.step(() => artist.field(BLUR, 1.5));
}

async function colourHorizon(camera, artist) {
  await artist.select(240, 212 - 16 * Math.sin(3) - 9 * Math.sin(6.5));
  await camera.step(() => artist.color("Left", 0, "f0846a"));
  await camera.step(() => artist.addStop("Left", 0.62, "ffd48a"));
  await camera.step(() => artist.color("Right", 0, "2b2350"));
  await camera.step(() => artist.addStop("Right", 0.62, "7a4a72"));
}

async function colourSky(camera, artist) {
  await artist.choose("Curve 2");
  await camera.step(() => artist.color("Right", 0, "243a7c"));
  await camera.step(() => artist.addStop("Right", 0.98, "43256b"));
}

async function dragSun(camera, artist) {
  await artist.choose("Curve 3");
  await artist.tool("Select");
  await camera.drag(way);
}

/** Enlarges the sun's edge a hundredfold. */
async function zoom(camera, artist) {
  await artist.deselect();
  await camera.page.mouse.move(...(await camera.editor.at(...way.at(-1))));
  for (let turn = 0; turn < 19; turn += 1) {
    await camera.page.mouse.wheel(0, -120);
    await sleep(DRAWN);
    await camera.take(MOVING);
  }
  await camera.step(() => {}, END);
}

const scenes = [drawHorizon, drawSky, drawSun, colourSun, colourHorizon, colourSky, dragSun, zoom];

async function film(editor, folder) {
  const artist = new Artist(editor);
  const camera = new Camera(editor, folder);
  await artist.blank(480, 300, "1d2130");
  await editor.page.evaluate(showPointer);
  for (const scene of scenes) await scene(camera, artist);
  camera.end();
}

const [build, folder] = process.argv.slice(2);
const server = await serve(resolve(build, "editor"));
const browser = await launch(MESA);
try {
  mkdirSync(folder, { recursive: true });
  const looks = { size: [1000, 640], ratio: 1, isDrawn: true, colorScheme: "dark", reducedMotion: "reduce" };
  const editor = await EditorPage.open(browser, server.address, looks);
  await editor.settled();
  await film(editor, folder);
  editor.checkQuiet();
} finally {
  await browser.close();
  server.close();
}
