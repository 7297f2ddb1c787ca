// Isolation of a layer: what is seen, what the tools reach, and how it ends.
import { check, checkEqual, EditorPage, until } from "./harness.mjs";
import { changing } from "./draw.mjs";
import { decode, largestDifference } from "./pixels.mjs";

const head = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 600 400" sf:background="#fff">`;
const square = (name, x, color, more = "") =>
  `<g id="${name}" sf:diffuse="true"><path id="${name}-square" d="M${x} 100h200v200h-200z" sf:right="${color}" sf:left="${color}" sf:left-opacity="0" sf:right-opacity="1"/>${more}</g>`;
/** The middle square covers the right third of the left one; the right square covers the middle one's. */
const drawing = `${head}
  ${square("left", 50, "#ff0000")}
  ${square("middle", 200, "#00c000")}
  <g id="set">${square("right", 350, "#0000ff")}</g>
  <path id="brush" d="M60 60L540 60" sf:left="#000" sf:right="#000" sf:radius="12"/>
</svg>
`;

const row = (page, name) => page.locator("[role=treeitem]", { has: page.locator(`.name:text-is("${name}")`) });
const bar = (page) => page.locator(".isolation");
const selected = ({ page }) => page.evaluate(() => window.sfumatoEditor.selection.map(({ name }) => name));

/** Returns red, green and blue of the picture at points of the artboard. */
async function colors(editor, points) {
  const png = decode(await editor.picture());
  const stage = await editor.page.locator(".canvas-stage").boundingBox();
  return Promise.all(
    points.map(async ([x, y]) => {
      const [left, top] = await editor.at(x, y);
      const at = png.channels * (Math.round(top - stage.y) * png.width + Math.round(left - stage.x));
      return [...png.data.slice(at, at + 3)];
    }),
  );
}

const isPale = (color) => Math.min(...color) > 150 && Math.min(...color) < 240;

async function isolate(editor, name) {
  await row(editor.page, name).locator(".thumb").dblclick();
  await bar(editor.page).filter({ hasText: `Isolated: ${name}` }).waitFor();
}

/** The isolated layer is in its own colours and in front; all others are pale. The text and the thumbs stay. */
async function testPicture({ browser, address }) {
  const editor = await EditorPage.open(browser, address, { isDrawn: true, ratio: 1 });
  const { page } = editor;
  await editor.load(drawing);
  const places = [[100, 200], [300, 200], [380, 200], [500, 200], [300, 60], [20, 380]];
  const whole = await editor.picture();
  await row(page, "middle").locator("img.thumb").waitFor();
  const thumb = () => row(page, "right").locator("img.thumb").getAttribute("src");
  await row(page, "set").locator(".twist").click();
  await row(page, "right").locator("img.thumb").waitFor();
  const before = await thumb();
  await isolate(editor, "middle");
  const [left, own, shared, right, brush, ground] = await colors(editor, places);
  checkEqual([own, shared, ground], [[0, 192, 0], [0, 192, 0], [255, 255, 255]], "colours of the isolated layer");
  check([left, right, brush].every(isPale), `the others are ${[left, right, brush].join(" ")}`);
  await editor.shot("isolation");
  checkEqual(await editor.text, drawing, "the text");
  checkEqual(await thumb(), before, "the thumb of a pale layer");
  // Each tool but Sample shows the isolation: Sample takes colours from all layers.
  await page.locator(".canvas-stage").focus();
  await editor.key("i");
  await until("the sample tool shows all colours", async () => largestDifference(whole, await editor.picture()) === 0);
  await editor.key("v", "Escape", "Escape");
  await bar(page).waitFor({ state: "detached" });
  checkEqual(largestDifference(whole, await editor.picture()), 0, "the picture after the isolation");
  // A group is isolated with all that is in it.
  await isolate(editor, "set");
  const [, green, blue] = await colors(editor, [[100, 200], [300, 200], [380, 200]]);
  check(isPale(green), `the middle square is ${green}`);
  checkEqual(blue, [0, 0, 255], "the square in the group");
  editor.checkQuiet();
  await editor.close();
}

/** Tools reach nothing outside of the isolated layer; an edit within it, its undo and its redo keep the isolation. */
async function testReach({ browser, address }) {
  const editor = await EditorPage.open(browser, address, { isDrawn: true });
  const { page } = editor;
  await editor.load(drawing);
  await isolate(editor, "middle");
  await page.locator(".canvas-stage").focus();
  await editor.click(50, 200);
  checkEqual(await selected(editor), [], "a click on a square outside");
  await editor.drag([[30, 80], [590, 330]]);
  checkEqual(await selected(editor), ["middle-square"], "a box around everything");
  await editor.key("Escape", "Control+a");
  checkEqual(await selected(editor), ["middle-square"], "select all");
  await editor.key("Escape", "Escape");
  checkEqual(await selected(editor), [], "Escape leaves the layer's own selection first");
  await editor.key("Tab");
  checkEqual(await selected(editor), ["middle-square"], "Tab");
  await editor.key("Tab");
  checkEqual(await selected(editor), ["middle-square"], "Tab past the last curve of the layer");
  // A row outside is selected, and the stage's keys and drags do not change it.
  await row(page, "left").click();
  await page.locator(".canvas-stage").focus();
  await editor.key("ArrowRight");
  await editor.drag([[150, 200], [150, 300]]);
  checkEqual(await editor.text, drawing, "the text after keys and a drag outside");
  await editor.click(400, 200);
  const moved = await changing(editor, "an arrow", () => editor.key("ArrowRight"));
  check(/id="middle-square" d="M20[01]\.\d/.test(moved), `not moved: ${moved}`);
  await changing(editor, "undo", () => editor.key("Control+z"));
  await changing(editor, "redo", () => editor.key("Control+Shift+z"));
  check(await bar(page).isVisible(), "undo and redo ended the isolation");
  // New curves go into the isolated layer, whatever is selected.
  await row(page, "left").click();
  await page.locator(".canvas-stage").focus();
  await editor.key("b");
  const drawn = await changing(editor, "the pencil", () => editor.drag([[220, 120], [300, 150], [370, 130]]));
  check(/id="middle"[^]*<path[^]*<path[^]*<g id="set"/.test(drawn), `the curve is elsewhere: ${drawn}`);
  check(await bar(page).isVisible(), "a curve in the layer ended the isolation");
  editor.checkQuiet();
  await editor.close();
}

/** Escape, the bar's button, the key, the palette, and the end of the layer each end it. */
async function testEnds({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  const gone = () => bar(page).waitFor({ state: "detached" });
  await isolate(editor, "left");
  await bar(page).getByRole("button", { name: /^Leave isolation/ }).click();
  await gone();
  check(await page.locator(".canvas-stage").evaluate((stage) => document.activeElement === stage), "the focus is lost");
  // From the tree, where Escape does nothing else.
  await isolate(editor, "left");
  await editor.key("Escape");
  await gone();
  await isolate(editor, "left");
  await isolate(editor, "middle");
  await row(page, "middle").locator(".thumb").dblclick();
  await gone();
  await row(page, "right").waitFor({ state: "detached" });
  await editor.click(400, 200);
  await editor.key("Control+k");
  await page.keyboard.type("isolate");
  await editor.key("Enter");
  await bar(page).filter({ hasText: "Isolated: middle" }).waitFor();
  // A dialog has Escape for itself.
  await editor.key("?");
  await page.getByRole("dialog").waitFor();
  await editor.key("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  check(await bar(page).isVisible(), "Escape of a dialog ended the isolation");
  await row(page, "middle").click();
  await changing(editor, "Delete", () => editor.key("Delete"));
  await gone();
  await changing(editor, "undo", () => editor.key("Control+z"));
  await isolate(editor, "left");
  await changing(editor, "an eye", () => row(page, "left").getByRole("button", { name: /^Hide/ }).click());
  await gone();
  // A hidden layer cannot be isolated, and a stroke on the artboard is in no layer.
  await row(page, "left").locator(".thumb").dblclick();
  await row(page, "brush").click();
  await page.locator(".canvas-stage").focus();
  await editor.key("q");
  await page.locator(".toast", { hasText: "Select a layer" }).waitFor();
  check(!(await bar(page).isVisible()), "there is an isolation");
  // A shape becomes a layer of its own, which is seen at once.
  await isolate(editor, "middle");
  await page.locator(".canvas-stage").focus();
  await editor.key("r");
  await changing(editor, "a rectangle", () => editor.drag([[60, 320], [160, 380]]));
  await gone();
  await isolate(editor, "middle");
  await editor.load(drawing, "other.svg");
  await gone();
  editor.checkQuiet();
  await editor.close();
}

export async function testIsolation(tap, given) {
  await tap.test("isolation: the layer keeps its colours, and all others are pale", () => testPicture(given));
  await tap.test("isolation: tools reach only the layer", () => testReach(given));
  await tap.test("isolation: ends by keys, the bar, the tree, and with the layer", () => testEnds(given));
}
