// Accessibility: axe-core in every state, keyboard only, fingers and pens.
import { readFileSync } from "node:fs";
import { check, checkEqual, EditorPage, packageOf } from "./harness.mjs";
import { changing, count } from "./draw.mjs";
import { atOnce, pass } from "./hooks.mjs";

const axe = readFileSync(packageOf.resolve("axe-core/axe.min.js"), "utf8");

const photo = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==";
const drawing = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <g id="back" sf:diffuse="true">
    <path id="low" d="M100 300C200 250 300 350 400 300" sf:left="#e33, #fe8" sf:right="#36c" sf:left-opacity=".5, 1" sf:right-opacity="1"/>
    <path id="leak" d="M100 120C110 60 300 40 300 100S110 200 101 122" sf:left="#fe8" sf:right="none" sf:left-blur="4"/>
  </g>
  <g id="front" sf:diffuse="true"><path id="own" d="M200 400L440 420" sf:left="#fff" sf:right="#000"/></g>
  <use id="copy" href="#front" transform="translate(20 -200)"/>
  <g id="strokes"><path id="brush" d="M500 100L600 300" sf:left="#f00" sf:right="#00f" sf:radius="12"/></g>
  <image id="photo" sf:reference="true" href="${photo}" x="500" y="20" width="100" height="80"/>
</svg>
`;

const row = (page, name) => page.getByRole("treeitem", { name: new RegExp(`^${name}\\b`) });

async function showLayers(page) {
  const tab = page.getByRole("tab", { name: "Layers" });
  if (await tab.isVisible()) await tab.click();
}

async function showCurve(page) {
  const tab = page.getByRole("tab", { name: "Curve" });
  if (await tab.isVisible()) await tab.click();
}

/** Selects in the tree; curves are inside their layers. */
async function select(editor, name, layer) {
  const { page } = editor;
  await showLayers(page);
  if (layer && !(await row(page, name).isVisible())) {
    await row(page, layer).click();
    await page.keyboard.press("ArrowRight");
  }
  await row(page, name).click();
  await showCurve(page);
}

const dialog = (key, title) => ({
  async enter({ page }) {
    await page.locator(".canvas-stage").focus();
    await page.keyboard.press(key);
    await page.getByRole("dialog", { name: title }).waitFor();
  },
  leave: ({ page }) => page.keyboard.press("Escape"),
});

async function menuCommand({ page }, ...labels) {
  await page.getByRole("button", { name: /^Menu/ }).click();
  for (const label of labels) await page.getByRole("menuitem", { name: label }).click();
}

/** Each state: how to enter and how to leave it. */
const states = {
  document: {},
  layers: { enter: ({ page }) => showLayers(page) },
  curve: { enter: (editor) => select(editor, "low", "back") },
  nodes: {
    async enter({ page }) {
      await page.locator(".canvas-stage").focus();
      for (const key of ["a", "Enter"]) await page.keyboard.press(key);
    },
  },
  opacity: { enter: ({ page }) => page.keyboard.press("2") },
  picker: {
    async enter({ page }) {
      await showCurve(page);
      await page.getByRole("button", { name: /^Colour of the whole left side/ }).click();
      await page.locator(".picker").waitFor();
    },
    leave: ({ page }) => page.locator(".picker").press("Escape"),
  },
  several: {
    async enter({ page }) {
      await page.locator(".canvas-stage").focus();
      await page.keyboard.press("v");
      await page.keyboard.press("Control+a");
    },
  },
  isolation: {
    async enter(editor) {
      await select(editor, "front");
      await editor.page.locator(".canvas-stage").focus();
      await editor.page.keyboard.press("q");
      await editor.page.locator(".isolation").waitFor();
    },
    leave: ({ page }) => page.getByRole("button", { name: /^Leave isolation/ }).click(),
  },
  stroke: { enter: (editor) => select(editor, "brush", "strokes") },
  layer: { enter: (editor) => select(editor, "front") },
  group: { enter: (editor) => select(editor, "strokes") },
  instance: { enter: (editor) => select(editor, "copy") },
  reference: { enter: (editor) => select(editor, "photo") },
  difference: {
    async enter({ page }) {
      await page.locator(".canvas-stage").focus();
      await page.keyboard.press("d");
      await page.locator(".difference-legend").filter({ hasText: /dB|no photo here/ }).waitFor();
    },
    async leave({ page }) {
      await page.locator(".canvas-stage").focus();
      await page.keyboard.press("d");
    },
  },
  photos: {
    async enter({ page }) {
      await page.getByRole("button", { name: /^Menu/ }).click();
      await page.getByRole("menuitem", { name: "Photo" }).click();
    },
    async leave({ page }) {
      await page.keyboard.press("Escape");
      await page.keyboard.press("Escape");
    },
  },
  menu: {
    enter: ({ page }) => page.getByRole("button", { name: /^Menu/ }).click(),
    leave: ({ page }) => page.keyboard.press("Escape"),
  },
  hints: {
    async enter({ page }) {
      await page.locator(".canvas-stage").focus();
      await page.keyboard.press("F8");
    },
    leave: ({ page }) => page.keyboard.press("F8"),
  },
  exporting: dialog("Control+e", "Export"),
  sizes: {
    ...dialog("", ""),
    async enter(editor) {
      await select(editor, "front");
      await dialog("Control+e", "Export").enter(editor);
      for (const name of ["@1x", "@3x", "Selected layers only"]) await editor.page.getByRole("checkbox", { name }).check();
      await editor.page.getByRole("button", { name: "Export 3 PNG files" }).waitFor();
    },
  },
  commands: {
    ...dialog("", ""),
    async enter(editor) {
      await dialog("Control+k", "Find a command").enter(editor);
      await editor.page.keyboard.type("photo");
      await editor.page.getByRole("option", { name: /Place photo/ }).waitFor();
    },
  },
  noCommand: {
    ...dialog("", ""),
    async enter(editor) {
      await dialog("Control+k", "Find a command").enter(editor);
      await editor.page.keyboard.type("zzz");
    },
  },
  palette: {
    async enter(editor) {
      const { page } = editor;
      await page.locator(".canvas-stage").focus();
      await page.keyboard.press("Control+Shift+a");
      await showCurve(page);
      await changing(editor, "a colour for the palette", () => page.getByRole("button", { name: "Add the current colour" }).click());
      await page.getByRole("button", { name: /^Use #/ }).waitFor();
    },
  },
  grid: {
    async enter(editor) {
      const { page } = editor;
      await menuCommand(editor, "File", "Document settings");
      await page.getByRole("checkbox", { name: "Show and snap to it" }).check();
      await page.getByLabel("Step").fill("20");
      await page.getByLabel("Step").press("Enter");
    },
    async leave({ page }) {
      await page.getByRole("checkbox", { name: "Show and snap to it" }).uncheck();
      await page.keyboard.press("Escape");
    },
  },
  tracing: {
    ...dialog("", ""),
    async enter(editor) {
      await menuCommand(editor, "File", "Trace photo…");
      await editor.page.getByRole("status").filter({ hasText: "Traced" }).waitFor();
    },
  },
  keys: dialog("?", "Keyboard shortcuts"),
  new: dialog("Control+Alt+n", "New drawing"),
  recover: { ...dialog("", ""), enter: (editor) => menuCommand(editor, "File", "Recover") },
  about: { ...dialog("", ""), enter: (editor) => menuCommand(editor, "About Sfumato") },
  guides: {
    async enter(editor) {
      const { page } = editor;
      await page.locator(".canvas-stage").focus();
      await page.keyboard.press("Alt+r");
      await page.keyboard.press("Alt+g");
      for (const name of ["vertical", "horizontal"]) await page.getByRole("button", { name: `Add a ${name} guide` }).click();
    },
    leave: ({ page }) => page.keyboard.press("Escape"),
  },
  page: { ...dialog("", ""), enter: (editor) => menuCommand(editor, "File", "Document settings") },
  problem: {
    enter: ({ page }) => page.evaluate(() => void window.sfumatoEditor.open("<svg><g></svg>", "broken.svg")),
    leave: ({ page }) => page.keyboard.press("Escape"),
  },
};

async function violations(editor, name) {
  const { page } = editor;
  // Wait for fades to end before the check.
  await page.evaluate(() => Promise.all(document.getAnimations().map((one) => one.finished.catch(() => {}))));
  const found = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  return found.violations.map(({ id, nodes }) => `${name}: ${id}, ${nodes.length}: ${nodes[0].target.join(" ")} ${nodes[0].failureSummary}`);
}

async function testAxe({ browser, address }, size, colorScheme) {
  const editor = await EditorPage.open(browser, address, { size, colorScheme, reducedMotion: "reduce" });
  const { page } = editor;
  await page.evaluate(axe);
  const found = await violations(editor, "welcome");
  await page.getByRole("button", { name: "Try the five steps" }).click();
  await page.locator(".tour-card").waitFor();
  found.push(...(await violations(editor, "tour")));
  await page.getByRole("button", { name: "Leave the tour" }).first().click();
  await editor.load(drawing);
  for (const [name, { enter, leave }] of Object.entries(states)) {
    try {
      await enter?.(editor);
      found.push(...(await violations(editor, name)));
      await leave?.(editor);
    } catch (error) {
      await editor.shot(`axe-${name}-${size[0]}-${colorScheme}`);
      throw new Error(`${name}: ${error.message}`);
    }
  }
  checkEqual(found, [], "violations");
  await editor.close();
}

/** Presses Tab until an element has the focus. */
async function tabTo(page, selector) {
  for (let k = 0; k < 60; k += 1) {
    if (await page.evaluate((s) => document.activeElement?.matches(s) ?? false, selector)) return;
    await page.keyboard.press("Tab");
  }
  check(false, `Tab does not come to ${selector}`);
}

async function testKeyboard({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await tabTo(page, ".start");
  await page.keyboard.press("Enter");
  await page.getByRole("dialog", { name: "New drawing" }).waitFor();
  await tabTo(page, "dialog .button.primary");
  await page.keyboard.press("Enter");
  await page.locator(".canvas-stage").waitFor();
  await tabTo(page, ".canvas-stage");
  const press = async (...keys) => {
    for (const key of keys) await page.keyboard.press(key);
  };
  await press("p", "Shift+ArrowLeft", "Shift+ArrowLeft", "Shift+ArrowUp", "Enter");
  await press("Shift+ArrowRight", "Shift+ArrowRight", "Shift+ArrowUp", "Enter");
  await press("Shift+ArrowRight", "Shift+ArrowDown", "ArrowDown", "Enter");
  const drawn = await changing(editor, "Enter on the last node", () => press("Enter"));
  check(/<path [^>]*d="M\S+ \S+ ?L/.test(drawn), `no curve: ${drawn}`);
  await tabTo(page, "[aria-label^='Left stop 1']");
  await press("Enter");
  const picker = page.getByRole("dialog", { name: "Colour of left stop 1" });
  await picker.waitFor();
  await tabTo(page, ".picker input[type=range][aria-label=Hue]");
  await changing(editor, "the hue", () => press("PageUp"));
  await press("Escape");
  await tabTo(page, ".ribbon [aria-label^='Right stop 1']");
  await press("Enter");
  await page.getByRole("dialog", { name: "Colour of right stop 1" }).waitFor();
  await tabTo(page, ".picker input[aria-label=Hex]");
  await page.keyboard.type("00ff80");
  const text = await changing(editor, "the hex field", () => press("Enter"));
  check(text.includes('sf:right="#00ff80"'), `the right side has no colour: ${text}`);
  await press("Escape");
  await editor.settled();
  editor.checkQuiet();
  await editor.close();
}

const line = ([x0, y0], [x1, y1], steps = 8) =>
  Array.from({ length: steps + 1 }, (_, k) => [x0 + ((x1 - x0) * k) / steps, y0 + ((y1 - y0) * k) / steps]);

async function testTouch({ browser, address }) {
  const editor = await EditorPage.open(browser, address, { hasTouch: true });
  const { page } = editor;
  await editor.load(drawing);
  const devtools = await page.context().newCDPSession(page);
  const mouse = (type, [x, y], more) =>
    devtools.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: 1, pointerType: "pen", clickCount: 1, ...more });
  const touch = (type, ...points) =>
    devtools.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const at = (x, y) => editor.at(x, y);
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("k");
  await changing(editor, "a finger", async () => {
    const [from, to] = [await at(250, 300), await at(330, 320)];
    await touch("touchStart", from);
    for (const place of line(from, to)) await touch("touchMove", place);
    await touch("touchEnd");
  });
  // A pen draws with its pressure, and the palm soon after it draws nothing.
  const way = line(await at(60, 420), await at(180, 440));
  const pressed = await changing(editor, "the pen", async () => {
    await mouse("mousePressed", way[0], { force: 0.2 });
    for (const [k, place] of way.entries()) await mouse("mouseMoved", place, { force: 0.2 + 0.09 * k });
    await mouse("mouseReleased", way.at(-1), { force: 0.9, buttons: 0 });
  });
  check(/sf:radius="[^"]*,/.test(pressed.replace(/id="brush".*/, "")), `pressure is not the radius: ${pressed}`);
  const curves = count(pressed, /<path /g);
  await atOnce(page, async () => {
    await mouse("mouseMoved", way[0], { buttons: 0, button: "none" });
    await touch("touchStart", await at(300, 200));
    for (const place of line(await at(300, 200), await at(380, 220))) await touch("touchMove", place);
    await touch("touchEnd");
  });
  checkEqual(count(await editor.text, /<path /g), curves, "curves after the palm");
  // From now on one finger moves the picture, and two zoom; neither draws.
  await pass(page, 600);
  const width = async () => (await at(1, 0))[0] - (await at(0, 0))[0];
  const before = { width: await width(), text: await editor.text };
  const [a, b] = [await at(250, 240), await at(350, 240)];
  await touch("touchStart", a);
  await touch("touchMove", [a[0] + 20, a[1]]);
  await touch("touchStart", [a[0] + 20, a[1]], b);
  for (let k = 1; k <= 10; k += 1) await touch("touchMove", [a[0] + 20 - 8 * k, a[1]], [b[0] + 8 * k, b[1]]);
  await touch("touchEnd");
  check((await width()) > before.width * 1.3, "two fingers do not zoom");
  checkEqual(await editor.text, before.text, "the text after a pinch");
  const [from, to] = [await at(250, 300), await at(330, 320)];
  await touch("touchStart", from);
  for (const place of line(from, to)) await touch("touchMove", place);
  await touch("touchEnd");
  const moved = await at(250, 300);
  check(Math.hypot(moved[0] - to[0], moved[1] - to[1]) < 2, `the finger does not move the picture: ${from} to ${moved}, expected ${to}`);
  checkEqual(await editor.text, before.text, "the text after a finger beside the pen");
  editor.checkQuiet();
  await editor.close();
}

const sizes = [[1440, 900], [1024, 768], [390, 844]];

export async function testAccess(tap, given) {
  for (const size of sizes) {
    for (const theme of ["light", "dark"]) {
      await tap.test(`axe finds nothing, ${size.join("×")}, ${theme}`, () => testAxe(given, size, theme));
    }
  }
  await tap.test("a curve is drawn and coloured by the keyboard alone", () => testKeyboard(given));
  await tap.test("pens draw, palms do not, a finger beside a pen moves the picture, two zoom", () => testTouch(given));
}
