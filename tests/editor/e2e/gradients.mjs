// A gradient's stops on its ribbon: by the pointer, by keys, by fields and the picker; each action is one undo
// step.
import { check, checkEqual, EditorPage } from "./harness.mjs";
import { changing, count } from "./draw.mjs";

const drawing = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <defs>
    <linearGradient id="sky" gradientUnits="userSpaceOnUse" x1="0" y1="0" x2="640" y2="0">
      <stop offset="0" stop-color="#ff0000"/>
      <stop offset="50%" style="stop-color:#00ff00"/>
      <stop offset="1" stop-color="#0000ff"/>
    </linearGradient>
  </defs>
  <g id="back" sf:diffuse="true">
    <path id="low" d="M-10 240L650 240" sf:left="url(#sky)" sf:right="#36c" stroke="url(#sky)"/>
  </g>
</svg>
`;

const stopOf = (page, index) => page.locator(".inspector .ribbon").first().locator(".stop").nth(index);
const field = (page, name) => page.locator(".inspector").getByRole("textbox", { name });

async function openSky(given, options) {
  const editor = await EditorPage.open(given.browser, given.address, options);
  await editor.load(drawing);
  await editor.click(320, 240);
  await editor.page.getByRole("group", { name: "Left side, linear gradient “sky”" }).waitFor();
  return editor;
}

/** Does something in one step, and undoes it. @returns the text in between */
async function oneStep(editor, what, act) {
  const { page } = editor;
  const before = await editor.text;
  const after = await changing(editor, what, act);
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("Control+z");
  await page.waitForFunction((text) => window.sfumatoEditor.text === text, before).catch(() => check(false, `${what} is more than one step`));
  await page.waitForFunction((stops) => document.querySelectorAll(".inspector .ribbon")[0].querySelectorAll(".stop").length === stops, count(before, /<stop /g));
  return after;
}

const same = (after, from, to, what) => checkEqual(after, drawing.replace(from, to), what);

async function testPointer(given) {
  const editor = await openSky(given);
  const { page } = editor;
  const band = await page.locator(".inspector .ribbon .band").first().boundingBox();
  const y = band.y + band.height / 2;
  const added = await oneStep(editor, "a click on the band", () => page.mouse.click(band.x + 0.75 * band.width, y));
  check(/<stop offset="7\d(\.\d+)?%" style="stop-color:(#|rgb)[^"]+"\/>/.test(added), `no stop with the colour there: ${added}`);
  checkEqual(count(added, /<stop /g), 4, "stops after a click");
  const drag = async (index, dx, dy) => {
    const box = await stopOf(page, index).boundingBox();
    const [x, from] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, from);
    await page.mouse.down();
    await page.mouse.move(x + dx, from + dy, { steps: 6 });
    await page.mouse.up();
  };
  const moved = await oneStep(editor, "a drag", () => drag(1, 0.2 * band.width, 0));
  check(/<stop offset="(6|7)[\d.]+%" style="stop-color:#00ff00"\/>/.test(moved), `the stop is not there: ${moved}`);
  const passed = await oneStep(editor, "a drag past another", () => drag(0, 0.7 * band.width, 0));
  check(/#00ff00"\/>\s*<stop offset="0\.[67]\d*" stop-color="#ff0000"\/>\s*<stop offset="1"/.test(passed), `not past the other: ${passed}`);
  const pulled = await oneStep(editor, "a drag away", () => drag(1, 0, 90));
  same(pulled, '\n      <stop offset="50%" style="stop-color:#00ff00"/>', "", "the text without a stop");
  editor.checkQuiet();
  await editor.close();
}

async function testKeys(given) {
  const editor = await openSky(given);
  const { page } = editor;
  const at = (index) => stopOf(page, index);
  await at(1).focus();
  const moved = await changing(editor, "an arrow", () => page.keyboard.press("Shift+ArrowLeft"));
  same(moved, '"50%"', '"40%"', "the text after an arrow");
  await page.waitForFunction(() => document.activeElement.getAttribute("aria-label")?.includes("at 40 %"));
  // The stop passes another one, and the keys still move it.
  for (let k = 0; k < 5; k += 1) await page.keyboard.press("Shift+ArrowLeft");
  await page.waitForFunction(() => /#00ff00.*at 0 %/.test(document.activeElement.getAttribute("aria-label") ?? ""));
  await page.locator(".canvas-stage").focus();
  while ((await editor.text) !== drawing) await changing(editor, "undo", () => page.keyboard.press("Control+z"));
  await at(0).focus();
  const added = await changing(editor, "Insert", () => page.keyboard.press("Insert"));
  check(added.includes('<stop offset="0.25" stop-color="'), `no stop in between: ${added}`);
  await page.waitForFunction(() => document.activeElement.getAttribute("aria-label")?.startsWith("Left stop 2 of 4"));
  const removed = await changing(editor, "Delete", () => page.keyboard.press("Delete"));
  checkEqual(removed, drawing, "the text after Insert and Delete");
  await at(2).focus();
  await changing(editor, "Delete", () => page.keyboard.press("Delete"));
  check(await at(1).evaluate((stop) => stop === document.activeElement), "the focus went with the last stop");
  await page.keyboard.press("Enter");
  await page.locator(".picker").waitFor();
  editor.checkQuiet();
  await editor.close();
}

async function testFields(given) {
  const editor = await openSky(given, { isDrawn: true });
  const { page } = editor;
  await stopOf(page, 1).click();
  const typed = (name, value) => async () => {
    await field(page, name).fill(value);
    await field(page, name).press("Enter");
  };
  const choose = async () => {
    await stopOf(page, 1).click();
    await page.locator(".inspector").getByRole("textbox", { name: "Position of left stop 2" }).waitFor();
  };
  same(await oneStep(editor, "a colour", typed(/hex/, "123456")), "#00ff00", "#123456", "the text with a colour");
  await choose();
  same(await oneStep(editor, "a place", typed(/^Position of left stop 2/, "37.5")), "50%", "37.5%", "the text with a place");
  await choose();
  const faint = await oneStep(editor, "alpha", typed(/^Alpha of left stop 2/, "40"));
  same(faint, 'style="stop-color:#00ff00"', 'style="stop-color:#00ff00" stop-opacity="0.4"', "the text with alpha");
  const before = await editor.picture();
  const spread = async () => {
    await page.getByRole("button", { name: /^Beyond the ends/ }).click();
    await page.getByRole("menuitemcheckbox", { name: "Reflected" }).click();
  };
  same(await oneStep(editor, "spread", spread), 'id="sky" gradientUnits="userSpaceOnUse" x1="0" y1="0" x2="640" y2="0"', 'id="sky" gradientUnits="userSpaceOnUse" x1="0" y1="0" x2="640" y2="0" spreadMethod="reflect"', "the text with spread");
  await choose();
  await changing(editor, "a colour", typed(/hex/, "000"));
  check(!before.equals(await editor.picture()), "the picture is as before");
  editor.checkQuiet();
  await editor.close();
}

async function testPicker(given) {
  const editor = await openSky(given);
  const { page } = editor;
  const picker = page.locator(".picker");
  const session = async () => {
    await stopOf(page, 1).dblclick();
    await picker.getByLabel("Hex").fill("#0af");
    await picker.getByLabel("Hex").press("Enter");
    await picker.getByRole("slider", { name: "Alpha of the stop" }).press("Home");
    await picker.press("Escape");
    await picker.waitFor({ state: "detached" });
  };
  same(await oneStep(editor, "a session of the picker", session), 'style="stop-color:#00ff00"', 'style="stop-color:#0af" stop-opacity="0"', "the text after the picker");
  // Another kind keeps the stops.
  await page.getByRole("button", { name: "Type of the left side" }).click();
  const radial = await changing(editor, "radial", () => page.getByRole("menuitem", { name: "Radial gradient" }).click());
  checkEqual(count(radial, /<stop /g), 6, "stops of both gradients");
  editor.checkQuiet();
  await editor.close();
}

export async function testGradients(tap, given) {
  await tap.test("gradient: stops are added, moved and pulled away", () => testPointer(given));
  await tap.test("gradient: stops by keys alone, and the focus stays with them", () => testKeys(given));
  await tap.test("gradient: colour, place, alpha and spread by fields", () => testFields(given));
  await tap.test("gradient: the picker's session is one step", () => testPicker(given));
}
