// Drawings that follow a photo: its colours, its blur, its edges, and the places where they differ.
import { check, checkEqual, EditorPage } from "./harness.mjs";
import { workersRest } from "./hooks.mjs";
import { small } from "./texts.mjs";
import { said, shows, textAfter } from "./words.mjs";

const WIDTH = 150;
const HEIGHT = 120;
const RED = [216, 48, 32];
const BLUE = [32, 64, 156];

/** Returns a red disc on blue as an address, with an edge as soft as so many pixels. */
function disc(page, blur) {
  return page.evaluate(async ([w, h, red, blue, soft]) => {
    const canvas = new OffscreenCanvas(w, h);
    const context = canvas.getContext("2d");
    context.fillStyle = `rgb(${blue})`;
    context.fillRect(0, 0, w, h);
    context.filter = soft > 0 ? `blur(${soft}px)` : "none";
    context.fillStyle = `rgb(${red})`;
    context.beginPath();
    context.arc(w / 2, h / 2, 40, 0, 7);
    context.fill();
    const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
    return `data:image/png;base64,${btoa(String.fromCharCode(...bytes))}`;
  }, [WIDTH, HEIGHT, RED, BLUE, blur]);
}

/** Returns a circle around the disc, shifted sideways, in two colours. */
const text = (href, { shift = 0, out = "#888", within = "#888", more = "" } = {}) => `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 ${WIDTH} ${HEIGHT}" sf:version="1">
  <g sf:diffuse="true">
    <path id="disc" transform="translate(${shift} 0)" d="M115 60C115 82 97 100 75 100S35 82 35 60S53 20 75 20S115 38 115 60Z" sf:left="${out}" sf:right="${within}"${more}/>
    <path id="far" d="M-400 -400L-400 -300" sf:left="#345" sf:right="#345"/>
  </g>
  <image id="photo" sf:reference="true" href="${href}" width="${WIDTH}" height="${HEIGHT}" preserveAspectRatio="none"/>
</svg>
`;

const hex = (color) => `#${color.map((value) => value.toString(16).padStart(2, "0")).join("")}`;

async function choose({ page }, label, kind = "menuitem") {
  await page.getByRole("button", { name: "Menu", exact: true }).click();
  await page.getByRole("menuitem", { name: "Photo" }).click();
  await page.getByRole(kind, { name: label }).click();
}

/** Returns the bytes of a side's only colour. */
function colorIn(svg, id, side) {
  const [, digits] = new RegExp(`id="${id}"[^>]*sf:${side}="#([0-9a-f]+)"`).exec(svg);
  const long = digits.length === 3 ? [...digits].map((one) => one + one).join("") : digits;
  return [0, 2, 4].map((at) => parseInt(long.slice(at, at + 2), 16));
}

function checkNear(color, wanted, what) {
  check(color.every((value, k) => Math.abs(value - wanted[k]) <= 12), `${what}: ${color}, expected ${wanted}`);
}

async function testColors(editor) {
  const { page } = editor;
  const before = text(await disc(page, 0));
  await editor.load(before);
  await choose(editor, "Colours from photo");
  const after = await textAfter(page, before);
  await said(page, /Colours of \d+ curves? fitted to the photo/);
  checkNear(colorIn(after, "disc", "left"), BLUE, "outside");
  checkNear(colorIn(after, "disc", "right"), RED, "within");
  await editor.key("Control+z");
  await shows(page, before);
  // Only a selected curve is changed.
  await editor.click(115, 60);
  await editor.key("Shift+I");
  const chosen = await textAfter(page, before);
  checkNear(colorIn(chosen, "disc", "right"), RED, "within");
  check(chosen.includes('sf:left="#345" sf:right="#345"'), "another curve has changed");
}

async function testBlur(editor) {
  const { page } = editor;
  const before = text(await disc(page, 4), { out: hex(BLUE), within: hex(RED) });
  await editor.load(before);
  await choose(editor, "Fit blur to photo");
  const after = await textAfter(page, before);
  await said(page, /Blur of 1 curve fitted/);
  const radius = Number(/id="disc"[^>]*sf:blur="([\d.]+)/.exec(after)[1]);
  check(radius > 5 && radius < 13, `the radius is ${radius}`);
  await editor.key("Control+z");
  await shows(page, before);
}

async function testSnap(editor) {
  const { page } = editor;
  const before = text(await disc(page, 0), { shift: 4 });
  await editor.load(before);
  await page.getByRole("button", { name: "Menu", exact: true }).click();
  await page.getByRole("menuitem", { name: "Photo" }).click();
  const item = page.getByRole("menuitem", { name: /Snap to photo/ });
  check(await item.isDisabled(), "there is something to snap");
  check((await item.textContent()).includes("Select a curve first"), "nothing says why not");
  await editor.key("Escape", "Escape");
  await editor.click(119, 60);
  await editor.key("Shift+E");
  const after = await textAfter(page, before);
  await said(page, /1 curve snapped to the photo’s edges/);
  const [, data] = /id="disc"[^>]* d="([^"]+)"/.exec(after);
  const [x] = /M([\d.]+)/.exec(data).slice(1).map(Number);
  check(Math.abs(x + 4 - 115) < 1, `the disc ends at ${x + 4}`);
  await editor.key("Control+z");
  await shows(page, before);
}

const legend = ".difference-legend";
const decibels = async (page) => Number(/([\d.]+) dB/.exec(await said(page, /[\d.]+ dB/, legend))[1]);

async function testDifference(editor) {
  const { page } = editor;
  const before = text(await disc(page, 0), { out: hex(BLUE) });
  await editor.load(before);
  await choose(editor, "Show difference from photo", "menuitemcheckbox");
  const wrong = await decibels(page);
  check(wrong < 20, `${wrong} dB of a grey disc`);
  check((await page.locator("image.difference").count()) === 1, "no picture of it");
  await editor.key("Shift+I");
  await textAfter(page, before);
  // The comparison is made again when the drawing rests.
  await page.waitForFunction((was) => Number(/([\d.]+) dB/.exec(document.querySelector(".difference-legend").textContent)?.[1]) > was + 10, wrong);
  await editor.key("d");
  await page.waitForFunction(() => !document.querySelector(".difference-legend, image.difference"));
}

/** Without a photo nothing starts; running work is stopped by its button, and by an edit. */
async function testNothing(editor) {
  const { page } = editor;
  await editor.load(small);
  await page.getByRole("button", { name: "Menu", exact: true }).click();
  await page.getByRole("menuitem", { name: "Photo" }).click();
  const item = page.getByRole("menuitem", { name: "Colours from photo" });
  check(await item.isDisabled(), "there is a photo");
  check((await item.textContent()).includes("Place a photo first"), "nothing says why not");
  await editor.key("Escape", "Escape");
  const before = text(await disc(page, 0));
  await editor.load(before);
  await page.locator(".canvas-stage").focus();
  await editor.key("Shift+I");
  // At once, because so little work is soon done.
  await page.waitForFunction(() => {
    const stop = [...document.querySelectorAll(".toast button")].find(({ textContent }) => textContent === "Stop");
    stop?.click();
    return stop !== undefined;
  });
  await said(page, /Stopped. Nothing was changed/);
  await shows(page, before);
  await editor.click(115, 60);
  await editor.key("Shift+I", "x");
  await said(page, /was edited meanwhile/);
  const swapped = await editor.text;
  await editor.settled();
  await workersRest(page);
  checkEqual(await editor.text, swapped, "the text after the edit");
}

export async function testPhoto(tap, { browser, address }) {
  const editor = await EditorPage.open(browser, address);
  await tap.test("photo: curves take its colours, in one step of undo", () => testColors(editor));
  await tap.test("photo: curves take its blur, in one step of undo", () => testBlur(editor));
  await tap.test("photo: a curve goes to its edge, in one step of undo", () => testSnap(editor));
  await tap.test("photo: where the drawing is unlike it is shown, and again after edits", () => testDifference(editor));
  await tap.test("photo: without one nothing begins, and what begins can be stopped", () => testNothing(editor));
  await tap.test("photo: nothing was complained of", () => editor.checkQuiet());
  await editor.close();
}
