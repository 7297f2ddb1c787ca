// The panels: each field and button does one undo step; picker, tree, dialogs, hints, tour.
import { check, checkEqual, EditorPage } from "./harness.mjs";
import { changing, count, openWithoutPickers, startBlank } from "./draw.mjs";
import { askedAgain, callsOf } from "./hooks.mjs";

const pixel = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==";
const drawing = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <g id="back" sf:diffuse="true">
    <path id="low" d="M100 300C200 250 300 350 400 300" sf:left="#e33, #fe8" sf:right="#36c" sf:left-opacity=".5" sf:right-opacity="1"/>
    <path id="high" d="M100 120L300 100L500 140" sf:left="#fe8" sf:right="#284" sf:left-blur="4"/>
  </g>
  <g id="front" sf:diffuse="true"><path id="own" d="M200 400L440 420" sf:left="#fff" sf:right="#000"/></g>
  <use id="copy" href="#front" transform="translate(20 -200)"/>
  <g id="strokes"><path id="brush" d="M500 100L600 300" sf:left="#f00" sf:right="#00f" sf:radius="12"/></g>
  <image id="photo" sf:reference="true" href="${pixel}" x="500" y="20" width="100" height="80"/>
</svg>
`;

const row = (page, name) => page.getByRole("treeitem", { name: new RegExp(`^${name}\\b`) });

async function select(editor, name, layer) {
  const { page } = editor;
  await editor.load(drawing);
  await page.locator(".canvas-stage").focus();
  if (layer) {
    await row(page, layer).click();
    await page.keyboard.press("ArrowRight");
  }
  await row(page, name).click();
}

/** How to reach each state of the panel. */
const states = {
  document: (editor) => editor.load(drawing),
  curve: (editor) => select(editor, "low", "back"),
  async node(editor) {
    await select(editor, "high", "back");
    await editor.page.locator(".canvas-stage").focus();
    await editor.key("a", "Enter");
  },
  async several(editor) {
    await select(editor, "low", "back");
    await row(editor.page, "high").click({ modifiers: ["Shift"] });
  },
  stroke: (editor) => select(editor, "brush", "strokes"),
  layer: (editor) => select(editor, "front"),
  group: (editor) => select(editor, "strokes"),
  instance: (editor) => select(editor, "copy"),
  reference: (editor) => select(editor, "photo"),
};

/** Returns another value; some fields show a place, and another number must be another place. */
const step = (value) => (value.startsWith("100") ? "90" : String(Number(value || 1) + 1));

/** Fields without effect on the drawing: a single stop has no place, and photo sampling is not saved. */
const isQuiet = (name, value) => (/^Position of|position of point/.test(name) && value === "0") || /^(Distance|Tolerance)$/.test(name);

/** Every field of the inspector accepts typed values, and undo restores the text. */
async function fields(editor, state) {
  const { page } = editor;
  const inputs = page.locator(".inspector input:not([type=range]):not([type=checkbox]):not([disabled])");
  const names = await inputs.evaluateAll((all) => all.map((one) => one.getAttribute("aria-label") ?? one.labels?.[0]?.textContent ?? ""));
  const failed = [];
  for (const [k, name] of names.entries()) {
    const before = await editor.text;
    const input = inputs.nth(k);
    const value = await input.inputValue();
    if (isQuiet(name, value)) continue;
    const wanted = /hex/i.test(name) ? (value === "123456" ? "654321" : "123456") : step(value);
    try {
      await input.fill(wanted);
      await changing(editor, `${state}, “${name}” from ${value} to ${wanted}`, () => input.press("Enter"));
      await page.locator(".canvas-stage").focus();
      await page.keyboard.press("Control+z");
      await page.waitForFunction((text) => window.sfumatoEditor.text === text, before);
      // The panel is drawn a little later than the text changes.
      const shown = await input.elementHandle();
      await page.waitForFunction(([field, text]) => field.value === text, [shown, value]);
    } catch (error) {
      failed.push(error.message.split("\n")[0]);
    }
  }
  check(names.length > 0, `${state} has no fields`);
  return failed;
}

/** The eyedropper of the panel takes the clicked colour of the picture; Escape ends it. */
async function testPicked({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await states.curve(editor);
  await editor.settled();
  const drop = page.locator(".inspector").getByRole("button", { name: "Pick the left side from the picture" });
  const before = await editor.text;
  await drop.click();
  await page.keyboard.press("Escape");
  await editor.click(20, 20);
  checkEqual(await editor.text, before, "the text after Escape");
  await states.curve(editor);
  await drop.click();
  // The copy of the upper layer is black there.
  const picked = await changing(editor, "the eyedropper", () => editor.click(250, 330));
  check(/sf:left="#0(00|10101)"/.test(picked), `not the colour there: ${picked}`);
  await editor.close();
}

async function testFields({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const failed = [];
  for (const [state, enter] of Object.entries(states)) {
    await enter(editor);
    failed.push(...(await fields(editor, state)));
  }
  checkEqual(failed, [], "fields that do nothing");
  const { page } = editor;
  await states.curve(editor);
  const at = page.locator(".inspector").getByLabel("Blur, radius of point 1");
  await at.fill("3*4+2");
  check((await changing(editor, "a sum", () => at.press("Enter"))).includes('="14"'), "the sum is not 14");
  const before = await editor.text;
  await at.fill("abc");
  await at.press("Enter");
  await page.getByText("Not a number").waitFor();
  await at.press("Escape");
  checkEqual(await at.inputValue(), "14", "the field after Escape");
  checkEqual(await editor.text, before, "the text");
  editor.checkQuiet();
  await editor.close();
}

async function undone(editor, what, act) {
  const before = await editor.text;
  const after = await changing(editor, what, act);
  await editor.page.locator(".canvas-stage").focus();
  await editor.page.keyboard.press("Control+z");
  await editor.page.waitForFunction((text) => window.sfumatoEditor.text === text, before).catch(() => check(false, `${what} is more than one step`));
  return after;
}

async function testPicker({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await states.curve(editor);
  await page.getByRole("group", { name: "Left side" }).locator(".stop").first().click();
  await page.getByRole("button", { name: /^Colour of left stop 1/ }).click();
  const picker = page.locator(".picker");
  const start = await editor.text;
  // Alpha is the side's opacity: another attribute in the same step.
  const alpha = picker.getByRole("slider", { name: /^Alpha/ });
  await changing(editor, "alpha", () => alpha.press("ArrowLeft"));
  const plane = await picker.locator(".plane").boundingBox();
  await changing(editor, "a drag on the plane", async () => {
    await page.mouse.move(plane.x + 60, plane.y + 60);
    await page.mouse.down();
    await page.mouse.move(plane.x + 160, plane.y + 90, { steps: 5 });
    await page.mouse.up();
  });
  await changing(editor, "the hue", () => picker.getByRole("slider", { name: "Hue" }).press("ArrowLeft"));
  for (const model of ["HSV", "RGB", "OKLCH"]) {
    await picker.getByRole("button", { name: /Colour model/ }).click();
    await page.getByRole("menuitemcheckbox", { name: model }).or(page.getByRole("menuitem", { name: model })).click();
    const first = picker.locator(".four input").first();
    const value = Number(await first.inputValue());
    await first.fill(String(value > 50 ? value - 9 : value + 9));
    await changing(editor, `a number of ${model}`, () => first.press("Enter"));
  }
  await changing(editor, "a swatch", () => picker.locator(".swatches .swatch").last().click());
  await changing(editor, "back to the old colour", () => picker.getByRole("button", { name: /^Revert to/ }).click());
  await changing(editor, "the hex", async () => {
    await picker.getByLabel("Hex").fill("#0af");
    await picker.getByLabel("Hex").press("Enter");
  });
  await picker.press("Escape");
  await picker.waitFor({ state: "detached" });
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("Control+z");
  await page.waitForFunction((text) => window.sfumatoEditor.text === text, start).catch(() => check(false, "a session of the picker is more than one step"));
  editor.checkQuiet();
  await editor.close();
}

async function testTree({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  const first = page.getByRole("treeitem").first();
  await first.click();
  await page.keyboard.press("End");
  await page.waitForFunction(() => document.activeElement?.getAttribute("role") === "treeitem" && document.activeElement.querySelector(".name")?.textContent === "back");
  await page.keyboard.press("ArrowRight");
  await row(page, "low").waitFor();
  await page.keyboard.press("ArrowDown");
  await page.waitForFunction(() => window.sfumatoEditor.selection[0]?.name === "high");
  await undone(editor, "Alt and an arrow", () => page.keyboard.press("Alt+ArrowDown"));
  await row(page, "high").click();
  await page.keyboard.press("F2");
  await page.keyboard.type("peak");
  const renamed = await changing(editor, "F2", () => page.keyboard.press("Enter"));
  check(/peak/.test(renamed), "it is not renamed");
  await undone(editor, "an eye", () => row(page, "front").getByRole("button", { name: /^Hide/ }).click());
  await undone(editor, "a lock", async () => {
    await row(page, "front").hover();
    await row(page, "front").getByRole("button", { name: /^Lock/ }).click();
  });
  const panel = page.getByRole("region", { name: "Layers" });
  await undone(editor, "New layer", () => panel.getByRole("button", { name: "New layer" }).click());
  await row(page, "front").click();
  await undone(editor, "Group", () => panel.getByRole("button", { name: /^Group/ }).click());
  await row(page, "front").click();
  await undone(editor, "Delete", () => panel.getByRole("button", { name: /^Delete/ }).click());
  editor.checkQuiet();
  await editor.close();
}

async function testExport({ browser, address }) {
  const editor = await openWithoutPickers(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  for (const format of ["SVG", "PNG", "HTML"]) {
    await page.getByRole("button", { name: /^Export/ }).first().click();
    const dialog = page.getByRole("dialog", { name: "Export" });
    await dialog.getByRole("radio", { name: new RegExp(`^${format}`) }).click();
    const download = page.waitForEvent("download");
    await dialog.getByRole("button", { name: `Export ${format}` }).click();
    check((await download).suggestedFilename().endsWith(`.${format.toLowerCase()}`), `${format} has another name`);
    await page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
  }
  editor.checkQuiet();
  await editor.close();
}

const leaky = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480">
  <g id="l" sf:diffuse="true"><path id="ring" d="M300 100C420 100 420 300 300 300S180 110 296 101" sf:left="#e33" sf:right="#36c"/></g>
</svg>
`;

const crossing = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 512 512">
  <g id="l" sf:diffuse="true">
    <path id="ring" d="M200 100C300 100 300 300 200 300C100 300 100 100 200 100Z" sf:left="#fff" sf:right="#f00"/>
    <path id="line" d="M-10 200L190 200" sf:left="#0f0" sf:right="#00f"/>
  </g>
</svg>
`;

async function testHints({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(leaky);
  await page.getByRole("button", { name: /^\d+ hints?/ }).click();
  const fix = page.locator(".hints .hint button.button, .hints li .button").first();
  await fix.waitFor();
  await undone(editor, "a hint's button", () => fix.click());
  // A hint without an automatic fix shows its place: for a crossing, both curves.
  await editor.load(crossing);
  const show = page.locator(".hints").getByRole("button", { name: /^Show: / });
  await show.first().click();
  const chosen = () => page.evaluate(() => window.sfumatoEditor.selection.map(({ name }) => name).sort());
  await page.waitForFunction(() => window.sfumatoEditor.selection.length === 2);
  checkEqual(await chosen(), ["line", "ring"], "what a crossing shows");
  checkEqual(await editor.text, crossing, "the text");
  editor.checkQuiet();
  await editor.close();
}

const wholes = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 512 512" sf:version="1">
  <g id="ground" sf:diffuse="true">
    <path id="frame" d="M0 0H512V512H0Z" sf:right="#abc" sf:left="none"/>
  </g>
  <g id="shape" sf:diffuse="true">
    <path id="ring" d="M200 100V300H100V100Z" sf:left="#f00" sf:right="#fd0"/>
  </g>
  <g id="ghost" opacity="0">
    <g id="inner" sf:diffuse="true">
      <path id="r" d="M20 10V30H10V10Z" sf:right="#fd0" sf:left-opacity="0" sf:right-opacity="1"/>
    </g>
  </g>
  <path id="brush" d="M9 9L90 90" sf:radius="9" sf:left="red" sf:alpha="0"/>
  <g id="spot" sf:diffuse="true">
    <path id="s" d="M420 410V430H410V410Z" sf:left="#0a0" sf:right="#fd0" sf:left-opacity="0" sf:right-opacity="1"/>
  </g>
  <use id="away" href="#spot" x="900"/>
</svg>
`;

/** Hints about layers, groups, strokes and instances: each has a button, is one step, and disappears. */
async function testHintsOfWholes({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(wholes);
  await page.getByRole("button", { name: /^\d+ hints?/ }).click();
  const row = (text) => page.locator(".hints .hint").filter({ hasText: text });
  const fixHint = async (text, name, check) => {
    const found = row(text).first();
    await found.waitFor();
    const count = await row(text).count();
    await undone(editor, text, () => found.getByRole("button", { name, exact: true }).click());
    await page.keyboard.press("Control+Shift+z");
    const now = await editor.text;
    check(now);
    await page.waitForFunction(([t, n]) => [...document.querySelectorAll(".hints .hint")].filter((e) => e.textContent.includes(t)).length < n, [text, count]);
    return now;
  };
  const has = (pattern, is = true) => (text) => check(pattern.test(text) === is, `${pattern}: ${text}`);
  await fixHint("cover everything below", "Limit layer to its outline", has(/id="ring"[^>]*sf:left-opacity="0" sf:right-opacity="1"/));
  await fixHint("“ghost”", "Delete invisible object", has(/id="ghost"/, false));
  await fixHint("“brush”", "Delete invisible object", has(/id="brush"/, false));
  await fixHint("outside the artboard, so nothing", "Move into picture", has(/id="away" href="#spot" x="900" transform="translate\(-\d+ 0\)"/));
  editor.checkQuiet();
  await editor.close();
}

/** A change is reported as kept only when it is, and an untouched drawing has no hints. */
async function testKept({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  const looks = await callsOf(page, "lint");
  await startBlank(editor);
  await askedAgain(page, "lint", looks);
  await page.getByRole("button", { name: "No hints" }).waitFor();
  await editor.load(drawing);
  await page.evaluate(() => {
    const state = () => document.querySelector(".topbar .file").textContent;
    window.seen = [];
    new MutationObserver(() => window.seen.push(state())).observe(document.querySelector(".topbar .file"), { subtree: true, childList: true, characterData: true });
  });
  await states.curve(editor);
  await changing(editor, "X", async () => {
    await page.locator(".canvas-stage").focus();
    await page.keyboard.press("x");
  });
  await page.waitForFunction(() => window.seen.some((text) => text.includes("Saved on this device")));
  const seen = await page.evaluate(() => window.seen.map((text) => /Saving|Saved/.exec(text)?.[0]).filter(Boolean));
  checkEqual([seen.indexOf("Saving") >= 0, seen.at(-1)], [true, "Saved"], `what is said of keeping: ${seen}`);
  editor.checkQuiet();
  await editor.close();
}

async function testTour({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await page.getByRole("button", { name: "Try the five steps" }).click();
  const title = (text) => page.locator(".tour-card").getByRole("heading", { name: text }).waitFor();
  await title("Draw a curve");
  await editor.settled();
  await editor.drag([[120, 260], [300, 200], [500, 260]], { steps: 8 });
  await title("Colour both sides");
  for (const [side, color] of [["Left", "f06040"], ["Right", "2050a0"]]) {
    await page.getByRole("group", { name: `${side} side` }).locator(".stop").first().dblclick();
    await page.locator(".picker").getByLabel("Hex").fill(color);
    await page.locator(".picker").getByLabel("Hex").press("Enter");
    await page.locator(".picker").press("Escape");
  }
  await title("Soften with blur");
  await page.getByRole("radio", { name: "Blur", checked: true }).first().waitFor();
  await editor.drag([[300, 212], [300, 270]]);
  await title("Add a layer");
  await page.getByRole("button", { name: "New layer" }).click();
  await title("Export");
  await page.getByRole("button", { name: /^Export/ }).first().click();
  await page.locator(".tour-card").waitFor({ state: "detached" });
  checkEqual(count(await editor.text, /sf:diffuse/g), 2, "layers");
  editor.checkQuiet();
  await editor.close();
}

const banded = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <g id="back" sf:diffuse="true">
    <path id="low" d="M100 300C200 250 300 350 400 300" sf:left="${Array.from({ length: 16 }, (_, i) => `#${(i % 10).toString().repeat(3)} ${Math.round((i * 1000) / 15) / 10}%`).join(", ")}" sf:right="#36c, #fe8 50%, #284"/>
  </g>
</svg>
`;

/** A side with 16 colours gets one by its field, several stops get one together, and a key does the same. */
async function testOneColor({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  const stop = (side, index) => page.getByRole("group", { name: `${side} side` }).locator(".stop").nth(index);
  const type = (name, hex) => async () => {
    const field = page.locator(".inspector").getByRole("textbox", { name });
    await field.fill(hex);
    await field.press("Enter");
  };
  await editor.load(banded);
  const start = await editor.text;
  await page.locator(".canvas-stage").focus();
  await row(page, "back").click();
  await page.keyboard.press("ArrowRight");
  await row(page, "low").click();
  const whole = await changing(editor, "the side's colour", type("Colour of the whole left side, hex", "ffe000"));
  check(/sf:left="#ffe000" sf:right="#36c, #fe8 50%, #284"/.test(whole), `the left side has other colours: ${whole}`);
  await page.locator(".canvas-stage").focus();
  checkEqual(await changing(editor, "undo", () => editor.key("Control+z")), start, "the text after one step of undo");
  await stop("Left", 3).click();
  await stop("Left", 5).click({ modifiers: ["Shift"] });
  const several = await changing(editor, "two stops", type("Colour, hex", "ffe000"));
  checkEqual(several.match(/#ffe000/g)?.length, 2, "stops that were recoloured");
  await stop("Right", 1).click();
  await page.locator(".canvas-stage").focus();
  const one = await changing(editor, "one colour by a key", () => editor.key("Shift+C"));
  check(one.includes('sf:right="#fe8"'), `the right side has other colours: ${one}`);
  await page.getByRole("button", { name: /^Colour of the whole right side/ }).click();
  const picker = page.getByRole("dialog", { name: "Colour of the whole right side" });
  await picker.waitFor();
  await changing(editor, "the picker's hue", () => picker.getByRole("slider", { name: "Hue" }).press("PageUp"));
  await editor.close();
}

export async function testPanels(tap, given) {
  await tap.test("a colour is picked from the picture", () => testPicked(given));
  await tap.test("each field of the panel does one step", () => testFields(given));
  await tap.test("a side or several stops get one colour", () => testOneColor(given));
  await tap.test("the picker's parts change the colour, all in one step", () => testPicker(given));
  await tap.test("the tree by buttons and by keys", () => testTree(given));
  await tap.test("the export dialog writes each format", () => testExport(given));
  await tap.test("a change is said to be kept once it is", () => testKept(given));
  await tap.test("the button of a hint fixes it", () => testHints(given));
  await tap.test("hints about layers, groups, strokes and instances have fixes", () => testHintsOfWholes(given));
  await tap.test("the tour goes through its five steps", () => testTour(given));
}
