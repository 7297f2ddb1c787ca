// Continuing and cutting curves, their style and their place, and the list of commands: by pointer and keys.
import { check, checkEqual, EditorPage } from "./harness.mjs";
import { changing, count } from "./draw.mjs";
import { said, shows } from "./words.mjs";

const text = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <g id="layer" sf:diffuse="true">
    <path id="c" d="M100 300L200 300L300 300" sf:left="#e33, #36c" sf:right="#fc0"/>
    <path id="d" d="M100 100L500 100" sf:left="#fe8" sf:right="#284"/>
  </g>
</svg>
`;

class Curves {
  constructor(editor) {
    this.editor = editor;
    this.page = editor.page;
  }

  async fresh(tool) {
    await this.editor.load(text);
    await this.page.locator(".canvas-stage").focus();
    await this.page.keyboard.press(tool);
  }

  async clicks(...points) {
    for (const [x, y] of points) {
      await this.editor.click(x, y);
      // The next click is not the second of a double click.
      await this.page.mouse.move(5, 300);
    }
  }

  press(key) {
    return changing(this.editor, key, () => this.page.keyboard.press(key));
  }

  cursor() {
    return this.page.evaluate(() => getComputedStyle(document.querySelector(".canvas-stage")).cursor);
  }
}

/** Returns the numbers and the Z of a path. */
const dataOf = (now, id) => new RegExp(`id="${id}" d="([^"]*)"`).exec(now)[1].match(/-?[\d.]+|Z/g).join(" ");

async function testPen({ editor, page }, tools) {
  await tools.fresh("p");
  await tools.clicks([300, 300], [400, 380], [500, 300]);
  let now = await tools.press("Enter");
  checkEqual(count(now, /<path /g), 2, "curves after the pen continued one");
  checkEqual(dataOf(now, "c"), "100 300 200 300 300 300 400 380 500 300", "its points");
  check(/id="c"[^>]*sf:left="#e33, #36c 43.\d+%"/.test(now), `its colours: ${now}`);
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), text, "the text after one undo");

  await tools.fresh("p");
  await tools.clicks([100, 300], [60, 400]);
  now = await tools.press("Enter");
  checkEqual(dataOf(now, "c"), "60 400 100 300 200 300 300 300", "its points after its start was continued");

  await tools.fresh("p");
  await tools.clicks([300, 300], [200, 420]);
  now = await changing(editor, "a click on the other end", () => editor.click(100, 300));
  checkEqual(dataOf(now, "c"), "100 300 200 300 300 300 200 420 Z", "the closed curve");

  await tools.fresh("p");
  await page.keyboard.down("Control");
  await tools.clicks([300, 300]);
  await page.keyboard.up("Control");
  await tools.clicks([400, 380]);
  now = await tools.press("Enter");
  checkEqual(count(now, /<path /g), 3, "curves after Ctrl");
}

async function testPenUndo({ editor, page }, tools) {
  await tools.fresh("p");
  await tools.clicks([300, 300], [400, 380]);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await tools.clicks([420, 200], [500, 220]);
  const now = await tools.press("Enter");
  checkEqual(count(now, /<path /g), 3, "curves after both nodes were taken back");
  check(now.includes('d="M100 300L200 300L300 300"'), "the curve is not continued");
  await tools.fresh("p");
  await editor.click(300, 300);
  await page.keyboard.press("Escape");
  await shows(page, text);
}

async function testCut({ page, editor }, tools) {
  await tools.fresh("v");
  await editor.click(150, 300);
  await page.keyboard.press("a");
  await editor.click(200, 300);
  const now = await tools.press("Shift+B");
  checkEqual(count(now, /<path /g), 3, "curves after the cut");
  check(/sf:left="#e33, (rgb[^"]*)"[^]*sf:left="\1, #36c"/.test(now), `their colours: ${now}`);
  const names = await page.evaluate(() => window.sfumatoEditor.selection.map(({ name }) => name));
  checkEqual(names, ["c", "c-2"], "what is selected");
}

async function testPlace({ page, editor }, tools) {
  await tools.fresh("v");
  await editor.click(150, 300);
  const section = page.locator(".inspector");
  const field = section.getByLabel("Left edge");
  await field.fill("140");
  let now = await changing(editor, "X", () => field.press("Enter"));
  checkEqual(dataOf(now, "c"), "140 300 240 300 340 300", "the moved curve");
  await page.locator(".canvas-stage").focus();
  now = await tools.press("Alt+A");
  checkEqual(dataOf(now, "c"), "0 300 100 300 200 300", "a single curve, aligned to the artboard");
}

async function testCommands({ page, editor }, tools) {
  await tools.fresh("v");
  await editor.click(150, 300);
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("Control+K");
  const dialog = page.getByRole("dialog", { name: "Find a command" });
  await page.keyboard.type("rev dir");
  await dialog.getByRole("option", { name: /^Reverse direction/, selected: true }).waitFor();
  const now = await tools.press("Enter");
  checkEqual(dataOf(now, "c"), "300 300 200 300 100 300", "the reversed curve");
  await dialog.waitFor({ state: "detached" });

  await page.keyboard.press("Control+K");
  await page.keyboard.type("paste style");
  await page.keyboard.press("Enter");
  check(await dialog.isVisible(), "a disabled command ran");
  await dialog.getByText("Copy the style of a curve first").waitFor();
  await page.keyboard.press("Control+A");
  await page.keyboard.type("no such thing");
  await dialog.getByText("No command has this name.").waitFor();
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" });
}

async function testCombine({ page, editor }, tools) {
  const circle = (id, x) => `<g sf:diffuse="true"><circle id="${id}" cx="${x}" cy="240" r="100" sf:right="#fd3" sf:left="#fd3" sf:left-opacity="0"/></g>`;
  await editor.load(text.replace(/<g[^]*<\/g>/, circle("moon", 300) + circle("shade", 340)));
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("Control+A");
  const crescent = await tools.press("Alt+Shift+S");
  checkEqual(count(crescent, /<(circle|path) /g), 1, "shapes");
  check(/<path id="moon" d="[^"]*Z" sf:right="#fd3" sf:left="#fd3" sf:left-opacity="0"/.test(crescent), crescent);
  checkEqual(count(crescent, /<g /g), 1, "layers");
  await page.keyboard.press("Alt+Shift+U");
  await said(page, /Select two or more closed curves/);
  await tools.fresh("v");
  await page.keyboard.press("Control+A");
  await page.keyboard.press("Alt+Shift+U");
  await said(page, /Select two or more closed curves/);
  checkEqual(await editor.text, text, "the text of open curves");
}

async function testOwnColor({ page, editor }, tools) {
  await tools.fresh("b");
  const options = page.getByRole("group", { name: "Tool options" });
  const way = [[150, 400], [300, 420], [450, 400]];
  const taken = await changing(editor, "the pencil", () => editor.drag(way));
  check(!taken.includes("#1a2b3c"), "the curve has the current colour without being asked");
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("Control+z");
  await options.getByLabel("Own colour").check();
  const field = options.getByLabel("Colour of new curves, hex");
  await field.fill("1a2b3c");
  await field.press("Enter");
  const now = await changing(editor, "the pencil", () => editor.drag(way));
  checkEqual(count(now, /sf:left="#1a2b3c" sf:right="#1a2b3c"/g), 1, "curves of one colour");
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("k");
  const stroke = await changing(editor, "a stroke", () => editor.drag([[150, 200], [300, 220], [450, 200]]));
  check(/sf:left="#1a2b3c"[^>]*sf:radius/.test(stroke), `the stroke has another colour: ${stroke}`);
}

export async function testCurves(tap, { browser, address }) {
  const tests = {
    "the pen continues an open end": testPen,
    "undo of the pen forgets the continued end": testPenUndo,
    "a curve is cut at a node": testCut,
    "a single curve has a place and is aligned to the artboard": testPlace,
    "a command is found by its name": testCommands,
    "two circles become a crescent": testCombine,
    "curves and strokes have the current colour": testOwnColor,
  };
  for (const [name, test] of Object.entries(tests)) {
    await tap.test(`curves: ${name}`, async () => {
      const editor = await EditorPage.open(browser, address);
      await test({ editor, page: editor.page }, new Curves(editor));
      editor.checkQuiet();
      await editor.close();
    });
  }
}
