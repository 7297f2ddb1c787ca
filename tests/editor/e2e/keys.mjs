// Every key of the table runs its command; none is active while the user types; keys can be changed.
import { readFileSync } from "node:fs";
import { check, checkEqual, pathOf, until } from "./harness.mjs";
import { changing, openWithoutPickers } from "./draw.mjs";
import { said } from "./words.mjs";

/** Returns the table of keys.ts, read from its text: [group, command, keys]. */
function bindings() {
  const source = readFileSync(pathOf("web/editor/src/app/keys.ts"), "utf8");
  const rows = [...source.matchAll(/^ {2}binding\((.*)\),$/gm)];
  return rows.map(([, row]) => {
    const [group, command, ...keys] = JSON.parse(`[${row}]`);
    return { group, command, keys };
  });
}

const head = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">';
const text = `${head}
  <g id="back" sf:diffuse="true">
    <path id="low" d="M100 300C200 250 300 350 400 300" sf:left="#e33" sf:right="#36c"/>
    <path id="high" d="M100 120L300 100L500 140" sf:left="#fe8" sf:right="#284" sf:left-blur="4"/>
    <path id="mid" d="M420 305C450 330 480 330 520 320" sf:left="#fff, #ccc" sf:right="#000"/>
  </g>
  <g id="front" sf:diffuse="true"><path id="own" d="M200 400L440 420" sf:left="#fff" sf:left-opacity="0" sf:right="#fff" sf:right-opacity=".5"/></g>
</svg>
`;

/** A point of each curve. */
const places = { low: [100, 300], high: [300, 100], mid: [520, 320], own: [200, 400] };

/** Returns the name for keyboard.press. */
const pressName = (key) => key.replace("Ctrl", "Control").replace(/\+\+$/, "+Shift+Equal").replace(/\+([A-Z])$/, (_, letter) => `+${letter.toLowerCase()}`);
const single = (key) => (/^[A-Z]$/.test(key) ? key.toLowerCase() : pressName(key));

class Keys {
  constructor(editor) {
    this.editor = editor;
    this.page = editor.page;
  }

  /** Opens a fresh drawing, selects objects by name, and puts the focus on the stage. */
  async fresh(...names) {
    await this.editor.load(text);
    await this.page.locator(".canvas-stage").focus();
    await this.tool("v", "select");
    for (const [k, name] of names.entries()) {
      if (k > 0) await this.page.keyboard.down("Shift");
      if (name === "front") await this.page.getByRole("treeitem", { name }).click();
      else await this.editor.click(...places[name]);
      if (k > 0) await this.page.keyboard.up("Shift");
    }
    if (names.length > 0) await until(`${names} is selected`, async () => (await this.selected()).join() === names.join());
    await this.page.locator(".canvas-stage").focus();
  }

  async press(key) {
    await this.page.keyboard.press(key);
  }

  async text(key, pattern) {
    const now = await changing(this.editor, key, () => this.press(key));
    check(pattern.test(now), `${key} gives ${now}`);
    return now;
  }

  selected() {
    return this.page.evaluate(() => window.sfumatoEditor.selection.map(({ name }) => name));
  }

  zoom() {
    return this.page.evaluate(() => {
      const [a, b] = [window.sfumatoEditor.place(0, 0), window.sfumatoEditor.place(1, 0)];
      return b[0] - a[0];
    });
  }

  async zooms(key, test) {
    const before = await this.zoom();
    await this.press(key);
    await until(`${key} zooms`, async () => test(await this.zoom(), before));
  }

  /** Expects that an element is pressed or shown, before and after. */
  async toggles(key, state) {
    const before = await state();
    await this.press(key);
    await until(`${key} changes`, async () => (await state()) !== before);
    await this.press(key);
    await until(`${key} again changes back`, async () => (await state()) === before);
  }

  isShown(locator) {
    return this.page.locator(locator).first().isVisible();
  }

  async dialog(key, title) {
    await this.press(key);
    await this.page.getByRole("dialog", { name: title }).waitFor();
    await this.page.keyboard.press("Escape");
    await this.page.getByRole("dialog").waitFor({ state: "detached" });
  }

  async node(key, pattern) {
    await this.fresh("high");
    await this.press("a");
    await this.press("Enter");
    await this.press("Tab");
    await until("a node is chosen", () =>
      this.page.evaluate(() => window.sfumatoEditor.selection[0]?.part.kind !== "whole"),
    );
    await this.text(key, pattern);
  }

  async tool(key, name) {
    await this.press(key);
    await this.page.locator(`[data-tool=${name}][aria-checked=true]`).waitFor();
  }

  async attribute(key, name) {
    await this.tool("a", "nodes");
    await this.press(key);
    await this.page.getByRole("radio", { name: new RegExp(`^${name}`), checked: true }).waitFor();
  }
}

const order = (now) => [...now.matchAll(/id="(\w+)"/g)].map(([, id]) => id).join(" ");

/** Combines two squares. @param count of curves afterwards */
const combines = (pattern, count) => async (keys, key) => {
  const square = (id, from, to) =>
    `<g sf:diffuse="true"><path id="${id}" d="M${from} ${from}H${to}V${to}H${from}Z" sf:right="#e33" sf:left-opacity="0"/></g>`;
  await keys.editor.load(`${head}${square("p", 100, 150)}${square("q", 120, 200)}</svg>`);
  await keys.page.locator(".canvas-stage").focus();
  await keys.press("Control+a");
  const now = await keys.text(key, pattern);
  checkEqual(now.match(/<path /g).length, count, "curves");
};

/** Keys for photos; tests/editor/e2e/photo.mjs tests them with a photo. */
async function wantsPhoto(keys, key) {
  await keys.fresh("low");
  await keys.press(key);
  await said(keys.page, /There is no photo to compare with/);
  await keys.page.locator(".toast button").click();
}

/** The evidence that a command was done, by its name. */
const shows = {
  "zoom-in": (keys, key) => keys.zooms(key, (now, before) => now > before * 1.2),
  "zoom-out": (keys, key) => keys.zooms(key, (now, before) => now < before / 1.2),
  "zoom-fit": async (keys, key) => {
    await keys.fresh();
    const whole = await keys.zoom();
    await keys.zooms("+", (now, before) => now > before);
    await keys.zooms(key, (now) => Math.abs(now - whole) < 1e-6);
  },
  "zoom-selection": async (keys, key) => {
    await keys.fresh("mid");
    await keys.zooms(key, (now, before) => now > before * 2);
  },
  "zoom-actual": (keys, key) => keys.zooms(key, (now) => now === 1),
  mesh: async (keys, key) => {
    await keys.fresh();
    const before = await keys.editor.picture();
    await keys.press(key);
    await until("the mesh shows", async () => !before.equals(await keys.editor.picture()));
    await keys.press(key);
    await until("the mesh goes", async () => before.equals(await keys.editor.picture()));
  },
  "exact-pixels": async (keys, key) => {
    await keys.fresh();
    await keys.toggles(key, () => keys.page.evaluate(() => window.sfumatoEditor.exactPixels.kind === "off"));
  },
  outlines: async (keys, key) => {
    await keys.fresh();
    await keys.toggles(key, () => keys.page.locator(".canvas-overlay path").count());
  },
  isolate: (keys, key) => keys.fresh("low").then(() => keys.toggles(key, () => keys.isShown(".isolation"))),
  reference: (keys, key) => keys.tool("b", "pencil").then(() =>
    keys.toggles(key, () => keys.page.getByRole("button", { name: /^Reference photo/ }).getAttribute("aria-pressed"))),
  rulers: (keys, key) => keys.toggles(key, () => keys.isShown(".rulers")),
  guides: (keys, key) => keys.dialog(key, "Guides"),
  "show-guides": async (keys, key) => {
    const guide = '<s:namedview xmlns:s="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"><s:guide position="9,9"/></s:namedview>';
    await keys.editor.load(text.replace("</svg>", `${guide}</svg>`));
    await keys.page.locator(".canvas-stage").focus();
    await keys.text(key, /showguides="false"/);
    await keys.text(key, /showguides="true"/);
  },
  keys: (keys, key) => keys.dialog(key, "Keyboard shortcuts"),
  commands: (keys, key) => keys.dialog(key, "Find a command"),
  hints: (keys, key) => keys.toggles(key, () => keys.isShown(".hints")),
  undo: async (keys, key) => {
    await keys.fresh("low");
    await keys.text("x", /.*/);
    checkEqual(await changing(keys.editor, key, () => keys.press(key)), text, "the text after undo");
  },
  redo: async (keys, key) => {
    await keys.fresh("low");
    const done = await keys.text("x", /.*/);
    await keys.text("Control+z", /.*/);
    checkEqual(await changing(keys.editor, key, () => keys.press(key)), done, "the text after redo");
  },
  cut: async (keys, key) => {
    await keys.fresh("low");
    const now = await keys.text(key, /id="high"/);
    check(!now.includes('id="low"'), "it is still there");
  },
  copy: async (keys, key) => {
    await keys.fresh("low");
    await keys.press(key);
    await keys.text("Control+v", /#e33[^]*#e33/);
  },
  paste: (keys) => shows.copy(keys, "Control+c"),
  duplicate: async (keys, key) => {
    await keys.fresh("low");
    await keys.text(key, /#e33[^]*#e33/);
  },
  delete: (keys, key) => shows.cut(keys, key),
  "select-all": async (keys, key) => {
    await keys.fresh("low");
    await keys.press(key);
    await until("three are selected", async () => (await keys.selected()).length === 3);
  },
  deselect: async (keys, key) => {
    await keys.fresh("low");
    await keys.press(key);
    await until("nothing is selected", async () => (await keys.selected()).length === 0);
  },
  "show-opacity": (keys, key) => keys.fresh("high").then(() => keys.attribute(key, "Opacity")),
  "show-blur": (keys, key) => keys.fresh("high").then(() => keys.attribute(key, "Blur")),
  "show-color": async (keys, key) => {
    await keys.fresh("high");
    await keys.attribute("3", "Blur");
    await keys.attribute(key, "Colour");
  },
  difference: wantsPhoto,
  "colors-from-photo": wantsPhoto,
  "blur-from-photo": wantsPhoto,
  "snap-to-photo": wantsPhoto,
  "one-color": (keys, key) => keys.fresh("mid").then(() => keys.text(key, /id="mid"[^>]*sf:left="#fff" sf:right="#000"/)),
  "own-shape": async (keys, key) => {
    await keys.fresh("high");
    await keys.text("Control+Shift+j", /Z/);
    await keys.text(key, /<g sf:diffuse="true">\s*<path id="high"[^>]*sf:(left|right)-opacity="0"/);
  },
  "swap-sides": (keys, key) => keys.fresh("low").then(() => keys.text(key, /id="low"(?=[^>]*sf:left="#36c")[^>]*sf:right="#e33"/)),
  reverse: (keys, key) => keys.fresh("low").then(() => keys.text(key, /d="M400 300/)),
  join: async (keys, key) => {
    await keys.fresh("low", "mid");
    const now = await keys.text(key, /.*/);
    checkEqual(now.match(/<path /g).length, 3, "curves");
  },
  "close-curve": (keys, key) => keys.fresh("high").then(() => keys.text(key, /id="high" d="[^"]*Z/i)),
  "cut-curve": async (keys, key) => {
    await keys.fresh("high");
    await keys.press("a");
    await keys.editor.click(300, 100);
    await keys.text(key, /id="high" d="M100 120 L300 100"[^]*id="high-2" d="M300 100 L500 140"/);
  },
  simplify: async (keys, key) => {
    await keys.fresh("low");
    await keys.press("a");
    await changing(keys.editor, "a node", () => keys.editor.click(250, 300, { clickCount: 2 }));
    await keys.text(key, /id="low" d="M100 300 ?C[^CL"]* 400 300"/);
  },
  "add-to-palette": (keys, key) => keys.fresh("low").then(() => keys.text(key, /<defs>[^]*swatch="solid"[^]*#e33[^]*#36c[^]*<\/defs>/)),
  "copy-style": async (keys, key) => {
    await keys.fresh("low");
    await keys.press(key);
    await keys.editor.click(...places.high);
    await keys.text("Control+Alt+v", /id="high"[^>]*sf:left="#e33" sf:right="#36c"/);
  },
  "paste-style": (keys) => shows["copy-style"](keys, "Control+Alt+c"),
  corner: async (keys, key) => {
    await keys.node("s", /C/);
    await keys.text(key, /.*/);
  },
  smooth: (keys, key) => keys.node(key, /id="high" d="M[^"]*C/),
  symmetric: (keys, key) => keys.node(key, /id="high" d="M[^"]*C/),
  "send-down": (keys, key) => keys.fresh("high").then(async () => checkEqual(order(await keys.text(key, /.*/)), "back high low mid front own", "order")),
  "bring-up": (keys, key) => keys.fresh("low").then(async () => checkEqual(order(await keys.text(key, /.*/)), "back high low mid front own", "order")),
  "to-bottom": (keys, key) => keys.fresh("mid").then(async () => checkEqual(order(await keys.text(key, /.*/)), "back mid low high front own", "order")),
  "to-top": (keys, key) => keys.fresh("low").then(async () => checkEqual(order(await keys.text(key, /.*/)), "back high mid low front own", "order")),
  group: (keys, key) => keys.fresh("low", "high").then(() => keys.text(key, /<g[^>]*>\s*<path id="low"/)),
  ungroup: async (keys, key) => {
    await keys.fresh("low", "high");
    const grouped = await keys.text("Control+g", /<g/);
    const now = await keys.text(key, /.*/);
    checkEqual(now.match(/<g/g).length, grouped.match(/<g/g).length - 1, "groups");
  },
  "make-instance": (keys, key) => keys.fresh("front").then(() => keys.text(key, /<use [^>]*href="#front"/)),
  "shapes-unite": combines(/id="p" d="[^"]*200/, 1),
  "shapes-subtract": combines(/id="p" d="[^"]*150/, 1),
  "shapes-intersect": combines(/id="p" d="(?![^"]*200)[^"]*Z"/, 1),
  "shapes-exclude": combines(/id="p" d="[^"]*200/, 1),
  "align-left": (keys, key) => keys.fresh("low", "own").then(() => keys.text(key, /id="own" d="M100 400/)),
  "align-center": (keys, key) => keys.fresh("low", "own").then(() => keys.text(key, /id="low" d="M120 300/)),
  "align-right": (keys, key) => keys.fresh("low", "own").then(() => keys.text(key, /id="low" d="M140 300/)),
  "align-top": (keys, key) => keys.fresh("high", "own").then(() => keys.text(key, /id="own" d="M200 100/)),
  "align-middle": (keys, key) => keys.fresh("high", "own").then(() => keys.text(key, /id="high" d="M100 260/)),
  "align-bottom": (keys, key) => keys.fresh("high", "own").then(() => keys.text(key, /id="high" d="M100 400/)),
  "align-to-artboard": (keys, key) => keys.fresh("low").then(() =>
    keys.toggles(key, () => keys.page.getByRole("button", { name: /^Align to the artboard/ }).getAttribute("aria-pressed"))),
  "distribute-horizontally": (keys, key) => keys.fresh("low", "mid", "own").then(() => keys.text(key, /id="own" d="M290 400/)),
  "distribute-vertically": (keys, key) => keys.fresh("high", "low", "own").then(() => keys.text(key, /id="low" d="M100 270/)),
  "flip-horizontal": (keys, key) => keys.fresh("own").then(() => keys.text(key, /id="own" d="M440 400/)),
  "flip-vertical": (keys, key) => keys.fresh("own").then(() => keys.text(key, /id="own" d="M200 420/)),
  new: (keys, key) => keys.dialog(key, "New drawing"),
  open: async (keys, key) => {
    const chooser = keys.page.waitForEvent("filechooser");
    await keys.press(key);
    await chooser;
  },
  save: async (keys, key) => {
    await keys.fresh();
    const download = keys.page.waitForEvent("download");
    await keys.press(key);
    checkEqual((await download).suggestedFilename(), "drawing.svg", "the name");
  },
  "save-as": (keys, key) => shows.save(keys, key),
  export: (keys, key) => keys.dialog(key, "Export"),
};

async function openKeys({ browser, address }, options) {
  // Views arrive at once.
  const asked = { permissions: ["clipboard-read", "clipboard-write"], reducedMotion: "reduce" };
  const editor = await openWithoutPickers(browser, address, { ...asked, ...options });
  const keys = new Keys(editor);
  await keys.fresh();
  return keys;
}

async function testGroup(given, group) {
  const keys = await openKeys(given, group === "view" ? { isDrawn: true } : {});
  const failed = [];
  for (const { command, keys: all } of bindings().filter((one) => one.group === group)) {
    for (const key of all) {
      // The browser opens a new window before the page receives the key.
      if (key === "Ctrl+N") continue;
      await keys.page.locator(".canvas-stage").focus();
      const show = command.startsWith("tool-") ? (k, name) => k.tool(name, command.slice(5)) : shows[command];
      try {
        await show(keys, single(key));
      } catch (error) {
        failed.push(`${key}, ${command}: ${String(error).split("\n")[0]}`);
        await keys.page.keyboard.press("Escape");
      }
    }
  }
  checkEqual(failed, [], "keys that do not what they say");
  keys.editor.checkQuiet();
  await keys.editor.close();
}

/** In a field keys type letters; only the keys for files still work. */
async function testTyping(given) {
  const keys = await openKeys(given);
  const { page, editor } = keys;
  await keys.fresh("low");
  const field = page.locator(".inspector").getByLabel("Blur, radius of point 1");
  await field.focus();
  for (const { group, keys: all } of bindings()) {
    if (group === "file") continue;
    for (const key of all) await page.keyboard.press(single(key));
  }
  checkEqual(await editor.text, text, "the text");
  checkEqual(await keys.selected(), ["low"], "what is selected");
  check(!(await page.locator("dialog[open]").count()), "a dialog opened");
  check(await field.evaluate((input) => input === document.activeElement), "the field lost the focus");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await keys.tool("p", "pen");
  await editor.close();
}

async function testChanging(given) {
  const keys = await openKeys(given);
  const { page } = keys;
  await keys.press("?");
  const dialog = page.getByRole("dialog", { name: "Keyboard shortcuts" });
  await dialog.getByRole("button", { name: "Change shortcuts" }).click();
  await dialog.getByRole("button", { name: /^Change the shortcut of “Pen”/ }).click();
  await page.keyboard.press("b");
  await dialog.getByRole("status").filter({ hasText: "“Pencil” already has this shortcut" }).waitFor();
  await dialog.getByRole("button", { name: /^Change the shortcut of “Pen”/ }).click();
  await page.keyboard.press("w");
  await dialog.getByRole("status").filter({ hasText: "“Pen” is now W." }).waitFor();
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" });
  await page.locator(".canvas-stage").focus();
  await keys.tool("b", "pencil");
  await keys.tool("w", "pen");
  await keys.press("v");
  await keys.press("p");
  await page.locator("[data-tool=select][aria-checked=true]").waitFor();
  await page.reload();
  await page.waitForFunction(() => window.sfumatoEditor !== undefined);
  await keys.fresh();
  await keys.tool("w", "pen");
  await keys.press("?");
  await dialog.getByRole("button", { name: "Change shortcuts" }).click();
  await dialog.getByRole("button", { name: "Reset all" }).click();
  await page.keyboard.press("Escape");
  await page.locator(".canvas-stage").focus();
  await keys.tool("v", "select");
  await keys.tool("p", "pen");
  keys.editor.checkQuiet();
  await keys.editor.close();
}

export async function testKeys(tap, given) {
  const table = bindings();
  const groups = [...new Set(table.map(({ group }) => group))];
  await tap.test("the table of keys is read", () => check(table.length > 40, "the table was not read"));
  for (const group of groups) {
    await tap.test(`each key of the table does its command: ${group}`, () => testGroup(given, group));
  }
  await tap.test("no key is a command while somebody types", () => testTyping(given));
  await tap.test("keys can be changed, stay changed, and be as at first", () => testChanging(given));
}
