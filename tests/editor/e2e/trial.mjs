// Faults that an illustrator found in a trial of the editor, each tested with pointer and keys only.
import { readFileSync } from "node:fs";
import { drop } from "./disk.mjs";
import { changing, startBlank } from "./draw.mjs";
import { check, checkEqual, EditorPage, packageOf, pathOf, until } from "./harness.mjs";
import { askedAgain, atOnce, callsOf, idleMoments } from "./hooks.mjs";
import { decode } from "./pixels.mjs";
import { said, shows } from "./words.mjs";

const open = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:version="1"';
const frame = '<path d="M-90 -90H800V700H-90Z" sf:left="#eee" sf:right="#eee"/>';
const line = '<path id="line" d="M60 112L580 112" sf:left="#e33" sf:right="#36c"/>';
const text = (inner, outer = "", more = ' sf:background="#fff"') =>
  `${open}${more}>\n  <g id="layer" sf:diffuse="true">\n    ${inner}\n  </g>${outer}\n</svg>\n`;
const blank = text("");

const stage = (page) => page.locator(".canvas-stage");
const undoButton = (page) => page.getByRole("button", { name: /^Undo/ });
const redoButton = (page) => page.getByRole("button", { name: /^Redo/ });

async function loaded(editor, drawing) {
  await editor.load(drawing);
  await stage(editor.page).focus();
}

const shapes = (svg) => [...svg.matchAll(/<path[^>]*? d="([^"]*)"/g)].map(([, data]) => data);
const nodes = (data) => data.match(/[MLCHVZ]/gi).length;

// Undo while a tool draws.

async function testPenUndo(editor) {
  const { page } = editor;
  await loaded(editor, blank);
  await editor.key("p");
  await editor.click(100, 100);
  await editor.click(300, 100);
  const first = await changing(editor, "Enter", () => editor.key("Enter"));
  for (const [x, y] of [[100, 300], [300, 300], [500, 420]]) await editor.click(x, y);
  checkEqual(await undoButton(page).getAttribute("aria-label"), "Undo: set node (Ctrl Z)", "the button");
  check(await redoButton(page).isDisabled(), "there is something to do again");
  await editor.key("Control+z");
  checkEqual(await editor.text, first, "the text after Ctrl Z");
  await undoButton(page).click();
  checkEqual(await editor.text, first, "the text after the button");
  await redoButton(page).click();
  await stage(page).focus();
  await editor.key("Control+Shift+z");
  await editor.shot("pen-undo");
  await editor.key("Control+z");
  const both = await changing(editor, "Enter", () => editor.key("Enter"));
  checkEqual(shapes(both).map(nodes), [2, 2], "nodes of both curves");
  // Undo continues with whole curves; redo still has its steps.
  await editor.key("Control+z");
  await shows(page, first);
  await editor.key("Control+z");
  await shows(page, blank);
  await editor.key("Control+y", "Control+y");
  await shows(page, both);
}

/** With no node left, undo goes on to the drawing, and waits for the curve in progress. */
async function testPenUndoThrough(editor) {
  const { page } = editor;
  await loaded(editor, text(line));
  await editor.key("p");
  await editor.click(100, 300);
  await editor.click(300, 300);
  const drawn = await changing(editor, "Enter", () => editor.key("Enter"));
  await editor.click(100, 400);
  await editor.key("Control+z", "Control+z");
  await shows(page, text(line));
  await editor.key("Control+Shift+z");
  await shows(page, drawn);
  await editor.click(100, 400);
  await editor.click(300, 420);
  await editor.key("Enter", "Control+z");
  await editor.settled();
  await until("there is something to do again", () => redoButton(page).isEnabled());
  checkEqual(await editor.text, drawn, "the text after Enter and Ctrl Z");
}

/** A drawing that is opened while a curve is on its way has nothing of it. */
async function testPenLeft(editor) {
  const { page } = editor;
  await loaded(editor, blank);
  await editor.key("p");
  for (const [x, y] of [[100, 300], [300, 300], [500, 420]]) await editor.click(x, y);
  await drop(page, [{ name: "other.svg", bytes: Buffer.from(text(line)) }]);
  await shows(page, text(line));
  await editor.settled();
  checkEqual(await editor.text, text(line), "the drawing that was opened");
  await menu(page, "File", "Recover…");
  await page.getByRole("dialog").getByText("1 curve").first().waitFor();
  await page.keyboard.press("Escape");
}

async function testPencilUndo(editor) {
  const { page } = editor;
  await loaded(editor, text(line));
  await editor.key("b");
  const places = await editor.all([[100, 300], [200, 340], [300, 300], [400, 340]]);
  await page.mouse.move(...places[0]);
  await page.mouse.down();
  await page.mouse.move(...places[1], { steps: 4 });
  await editor.key("Control+z");
  await page.mouse.move(...places[2], { steps: 4 });
  await page.mouse.up();
  checkEqual(await editor.text, text(line), "the text after Ctrl Z within the line");
}

// Lines that snap.

async function testSnappedEnds(editor) {
  const { page } = editor;
  const ends = async (tool, from, to) => {
    await loaded(editor, text(line));
    await editor.key(tool);
    const drawn = await changing(editor, tool, () => editor.drag([from, to], { steps: 40 }));
    const [data] = shapes(drawn).filter((one) => one !== "M60 112L580 112");
    return data.match(/-?[\d.]+/g).map(Number);
  };
  for (const tool of ["b", "k"]) {
    for (const [from, to] of [[[400, 300], [400, 109]], [[400, 300], [400, 114]], [[400, 115], [400, 300]], [[400, 110], [400, 300]]]) {
      const numbers = await ends(tool, from, to);
      const ys = numbers.filter((_, k) => k % 2 === 1);
      checkEqual(numbers.length, 4, `${tool} from ${from} to ${to}: ${numbers}`);
      check(ys.some((y) => Math.abs(y - 112) < 1e-3), `${tool} does not end on the line: ${numbers}`);
    }
  }
  await page.keyboard.press("v");
}

// Hints.

async function hintsOf(editor, drawing) {
  const looks = await callsOf(editor.page, "lint");
  await loaded(editor, drawing);
  await askedAgain(editor.page, "lint", looks);
}

const ring = "M200 100C300 100 300 300 200 300C100 300 100 100 200 100Z";

async function testSeam(editor) {
  const { page } = editor;
  const colors = "#c33, #fa8 40%, #612 70%, #00f 85%";
  await hintsOf(editor, text(`${frame}<path id="ring" d="${ring}" sf:left="#eee" sf:right="${colors}"/>`));
  await editor.key("F8");
  const repaired = await changing(editor, "the repair", () => page.getByRole("button", { name: "End with first colour" }).click());
  check(repaired.includes(`sf:right="${colors}, #c33"`), `after the repair: ${repaired}`);
  await editor.key("F8");
}

/** A stop on the ribbon of a closed curve gets another colour: the curve still ends with its first colour. */
async function testClosedRibbon(editor) {
  const { page } = editor;
  await loaded(editor, text(`${frame}<path id="ring" d="${ring}" sf:left="#eee" sf:right="#c33"/>`));
  await editor.key("v");
  await editor.click(200, 100);
  const side = page.getByRole("group", { name: "Inside", exact: true }).first();
  await changing(editor, "a click on the ribbon", () => side.locator(".band").click());
  const field = page.locator(".inspector").getByLabel("Colour, hex", { exact: true }).first();
  const colored = await changing(editor, "a colour", async () => {
    await field.fill("0000ff");
    await field.press("Enter");
  });
  check(/sf:right="#c33, #00f 50%, #c33"/.test(colored), `a seam: ${colored}`);
  await editor.shot("closed-ribbon");
  checkEqual(await side.locator(".stop").count(), 2, "stops: that at the end is the one at the start");
  // Without the stop at the start, the one that closes the ring goes too.
  const deleted = await changing(editor, "Delete", () => side.locator(".stop").first().press("Delete"));
  check(/sf:right="#00f"/.test(deleted), `after Delete: ${deleted}`);
  checkEqual(await side.locator(".stop[aria-pressed=true]").count(), 1, "a stop that is chosen");
}

const colorsOf = async (editor) => /id="ring"[^>]* sf:right="([^"]*)"/.exec(await editor.text)[1];

/** Stops of a closed curve are moved, on the ribbon and on the stage: the colours still meet where it begins. */
async function testRingOfStops(editor) {
  const { page } = editor;
  await loaded(editor, text(`${frame}<path id="ring" d="${ring}" sf:left="#eee" sf:right="#c33, #0a0 30%, #00f 60%, #c33"/>`));
  await editor.key("a");
  await editor.click(200, 100);
  const side = page.getByRole("group", { name: "Inside", exact: true }).first();
  const band = await side.locator(".band").boundingBox();
  const drag = async (from, to) => {
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 3 });
    await page.mouse.move(...to, { steps: 3 });
    await page.mouse.up();
  };
  const middle = async (index) => {
    const { x, y, width, height } = await side.locator(".stop").nth(index).boundingBox();
    return [x + width / 2, y + height / 2];
  };
  const right = [band.x + band.width + 30, band.y + band.height / 2];
  await changing(editor, "a drag beyond the end", async () => drag(await middle(2), right));
  checkEqual(await colorsOf(editor), "#c33, #0a0 30%, #00f 100%, #c33", "a hard step at the end");
  await editor.shot("ring-hard-step");
  await changing(editor, "undo", () => editor.key("Control+z"));
  await changing(editor, "the first stop past another", async () => drag(await middle(0), [placeOn(band, 0.45), right[1]]));
  checkEqual(await colorsOf(editor), "#0a0 30%, #c33 45%, #00f 60%, #0a0", "the other one is the first");
  await changing(editor, "undo", () => editor.key("Control+z"));
  // On the stage: the stop at the start, beside the curve's first node, follows the pointer to both sides of it.
  const [x, y] = await editor.at(200, 100);
  await changing(editor, "a drag on the stage", () => drag([x, y + 18], [x + 40, y + 24]));
  const moved = /^#c33 (\d+\.?\d*)%, #0a0 30%, #00f 60%, #c33$/.exec(await colorsOf(editor));
  check(moved && moved[1] > 2 && moved[1] < 15, `on the stage: ${await colorsOf(editor)}`);
  await editor.shot("ring-stage");
  await changing(editor, "back past the start", () => drag([x + 40, y + 24], [x - 60, y + 30]));
  checkEqual(await colorsOf(editor), "#c33, #0a0 30%, #00f 60%, #c33", "it waits at the start");
}

const placeOn = ({ x, width }, share) => x + 7 + (width - 14) * share;

/** The side's menu distributes its stops and reverses them, each in one step of undo. */
async function testOrderOfStops(editor) {
  const { page } = editor;
  const before = "#c33, #0a0 10%, #00f 20%, #c33";
  await loaded(editor, text(`${frame}<path id="ring" d="${ring}" sf:left="#eee" sf:right="${before}"/>`));
  await editor.key("v");
  await editor.click(200, 100);
  const choose = (name) =>
    changing(editor, name, async () => {
      await page.getByRole("button", { name: "Type of the inside" }).click();
      await page.getByRole("menuitem", { name }).click();
    });
  await choose("Distribute stops evenly");
  checkEqual(await colorsOf(editor), "#c33, #0a0 33.33%, #00f 66.67%, #c33", "distributed");
  await choose("Reverse colours");
  checkEqual(await colorsOf(editor), "#c33, #00f 33.33%, #0a0 66.67%, #c33", "reversed");
  for (let step = 0; step < 2; step += 1) await changing(editor, "undo", () => editor.key("Control+z"));
  checkEqual(await colorsOf(editor), before, "after two steps of undo");
}

async function testRing(editor) {
  const { page } = editor;
  const seam = text(`${frame}<path id="ring" d="${ring}" sf:left="#eee" sf:right="#c33, #00f"/>`);
  const over = async () => {
    await editor.key("F8");
    await page.locator(".hints .hint").filter({ hasText: "seam" }).hover();
    await page.locator(".leak").waitFor();
  };
  const isGone = (what) =>
    page.locator(".leak").waitFor({ state: "detached" }).catch(() => check(false, `the ring stays after ${what}`));
  await hintsOf(editor, seam);
  await over();
  await editor.key("F8");
  await isGone("F8");
  await over();
  await page.locator(".hints .hint").filter({ hasText: "seam" }).getByRole("button", { name: "End with first colour" }).click();
  await isGone("the repair");
  await editor.key("F8");
  await hintsOf(editor, seam);
  await over();
  await editor.load(blank);
  await isGone("another drawing");
  await editor.key("F8");
}

/** Before the search for hints, the page does not claim that there are none. */
async function testHintsLooking(editor) {
  const { page } = editor;
  const button = (name) => page.getByRole("button", { name });
  await loaded(editor, blank);
  await page.evaluate(() => {
    window.said = [];
    const note = () => window.said.push(document.querySelector(".hints-button")?.textContent.trim() ?? "");
    new MutationObserver(note).observe(document.querySelector(".status"), { subtree: true, childList: true, characterData: true });
  });
  const looks = await callsOf(page, "lint");
  await loaded(editor, text(`${frame}<path id="ring" d="${ring}" sf:left="#eee" sf:right="#c33, #00f"/>`));
  await askedAgain(page, "lint", looks);
  await button(/^\d+ hint/).waitFor();
  const all = await page.evaluate(() => window.said);
  check(!all.includes("No hints"), `there were said to be none: ${all}`);
  const again = await callsOf(page, "lint");
  await editor.load(blank);
  await askedAgain(page, "lint", again);
  await button("No hints").waitFor();
  checkEqual((await page.evaluate(() => window.said)).slice(-2), ["Hints…", "No hints"], "what is said of a drawing without hints");
}

/** A new layer is no hint until something is drawn in another one. */
async function testNewLayer(editor) {
  const { page } = editor;
  const button = (name) => page.getByRole("button", { name });
  const afterLint = async (action) => {
    const looks = await callsOf(page, "lint");
    await action();
    await askedAgain(page, "lint", looks);
  };
  await hintsOf(editor, text(`<path id="ring" d="${ring}" sf:left="#eee" sf:right="#c33"/>`));
  await button("No hints").waitFor();
  await afterLint(() => button("New layer").click());
  await button("No hints").waitFor();
  await afterLint(async () => {
    await editor.key("v");
    await editor.click(200, 100);
    await editor.key("Shift+v");
  });
  await button("1 hint").waitFor();
}

// Pictures of an earlier drawing.

async function pixelAt(editor, x, y) {
  const png = decode(await editor.picture());
  const box = await editor.page.locator(".canvas-stage > canvas").boundingBox();
  const [px, py] = await editor.at(x, y);
  const scale = png.width / box.width;
  const at = png.channels * (Math.floor((py - box.y) * scale) * png.width + Math.floor((px - box.x) * scale));
  return [...png.data.slice(at, at + 3)];
}

const many = (layers) => {
  const one = (k) => `<g sf:diffuse="true"><path d="M${k % 600} 9V470" sf:left="#${(k % 900) + 100}" sf:right="#36c"/></g>`;
  return `${open}>${Array.from({ length: layers }, (_, k) => one(k)).join("\n")}</svg>`;
};

async function testStale(editor) {
  const { page } = editor;
  await loaded(editor, text(line));
  check((await pixelAt(editor, 320, 300))[2] > 150, "the first drawing is not there");
  await drop(page, [{ name: "many.svg", bytes: Buffer.from(many(4097)) }]);
  await said(page, /cannot be shown.*more than the limit of 4096 layers/s, "dialog");
  check((await page.locator("dialog").textContent()).includes("open it again"), "nobody says what can be done");
  await editor.shot("cannot-be-shown");
  await page.keyboard.press("Escape");
  await page.mouse.move(3, 3);
  const [red, green, blue] = await pixelAt(editor, 320, 300);
  check(red === green && green === blue, `the picture of the drawing before: ${[red, green, blue]}`);
  checkEqual(await page.locator(".tree-row img.thumb").count(), 0, "thumbs of the drawing before");
  await editor.shot("cannot-be-shown-stage");
}

async function testManyLayers(editor) {
  const { page } = editor;
  await drop(page, [{ name: "500.svg", bytes: Buffer.from(many(500)) }]);
  await shows(page, many(500));
  await editor.settled();
  checkEqual((await page.evaluate(() => window.sfumatoEditor.status)).kind, "exact", "what becomes of 500 layers");
  checkEqual(await page.locator("dialog[open]").count(), 0, "dialogs");
}

async function testThumbs(editor) {
  const { page } = editor;
  const second = `\n  <g id="second" sf:diffuse="true"><path d="${ring}" sf:left="#fff" sf:left-opacity="0" sf:right="#c33" sf:right-opacity="1"/></g>`;
  await loaded(editor, text(line, second));
  /** Returns the addresses of thumbnails, by the names of their layers. */
  const thumbs = () =>
    page.locator(".tree-row:has(img.thumb)").evaluateAll((rows) =>
      Object.fromEntries(rows.map((row) => [row.querySelector(".name").textContent, row.querySelector("img.thumb").src])));
  const names = async () => Object.keys(await thumbs()).sort().join();
  await until("there are thumbs", async () => (await names()) === "layer,second");
  const before = await thumbs();
  await page.getByRole("button", { name: "New layer" }).click();
  await page.getByRole("treeitem").nth(2).waitFor();
  await editor.settled();
  await idleMoments(page);
  await until("the new layer has a thumb", async () => (await names()) === "Layer 3,layer,second");
  const added = await thumbs();
  checkEqual([added.layer, added.second], [before.layer, before.second], "thumbs of the layers that did not change");
  await editor.shot("thumbs");
  // A layer without its curve no longer shows it.
  await stage(page).focus();
  await editor.key("p");
  await editor.click(100, 400);
  await editor.click(300, 420);
  await changing(editor, "Enter", () => editor.key("Enter"));
  await until("the new layer has another thumb", async () => (await thumbs())["Layer 3"] !== added["Layer 3"]);
  const drawn = await thumbs();
  await changing(editor, "undo", () => editor.key("Control+z"));
  await until("the empty layer shows no curve", async () => (await thumbs())["Layer 3"] !== drawn["Layer 3"]);
  const undone = await thumbs();
  checkEqual([undone.layer, undone.second], [before.layer, before.second], "thumbs after undo");
}

// Further faults.

const menu = async (page, ...labels) => {
  await page.getByRole("button", { name: "Menu", exact: true }).click();
  for (const label of labels) await page.getByRole("menuitem", { name: label }).click();
};

async function testOpenCurve(editor) {
  const { page } = editor;
  await loaded(editor, text(`${frame}<path id="ring" d="${ring}" sf:left="#eee" sf:right="#c33"/>`));
  await editor.key("v");
  await editor.click(200, 100);
  await menu(page, "Object");
  checkEqual(await page.getByRole("menuitem", { name: "Close curve" }).count(), 0, "closed curves that can be closed");
  const opened = await changing(editor, "Open", () => page.getByRole("menuitem", { name: "Open curve" }).click());
  check(!/id="ring" d="[^"]*Z"/.test(opened), `still closed: ${opened}`);
  const closed = await changing(editor, "Close", () => menu(page, "Object", "Close curve"));
  check(/id="ring" d="[^"]*Z"/.test(closed), `not closed: ${closed}`);
}

async function testPlacedPhoto(editor) {
  const { page } = editor;
  await loaded(editor, text(line));
  await drop(page, [{ name: "hemp.png", bytes: readFileSync(pathOf("examples/hemp.png")), type: "image/png" }]);
  await page.waitForFunction(() => /<image/.test(window.sfumatoEditor.text));
  const placed = await editor.text;
  check(/<image[^>]* opacity="0?\.5"/.test(placed), "the photo hides what is drawn");
  check(await page.getByRole("checkbox", { name: "Locked" }).isChecked(), "the photo is not locked");
  await editor.shot("placed-photo");
  await stage(page).focus();
  await editor.key("v");
  await editor.drag([[320, 300], [360, 340]]);
  await editor.settled();
  checkEqual(await editor.text, placed, "the text after a drag of the photo");
}

async function testTransparent(editor) {
  const { page } = editor;
  const box = page.getByRole("checkbox", { name: "Transparent background" });
  await loaded(editor, text(line, "", ""));
  await editor.key("Control+e");
  await page.getByText("The drawing has no background").waitFor();
  checkEqual([await box.isChecked(), await box.isDisabled()], [true, true], "checked and greyed");
  await page.locator(".export-view img.chequer").waitFor();
  await editor.shot("export-transparent");
  await editor.key("Escape");
  await loaded(editor, text(line));
  await editor.key("Control+e");
  await box.waitFor();
  checkEqual([await box.isChecked(), await box.isDisabled()], [false, false], "checked and greyed, with a background");
  await editor.key("Escape");
}

// One colour dialect, one name, steps, licences.

async function testColors(editor) {
  const { page } = editor;
  const gradient = '<defs><linearGradient id="g"><stop stop-color="#123"/><stop offset="1" stop-color="#456"/></linearGradient></defs>';
  const drawing = text(`${frame}${line}<path id="other" d="M60 300L320 300L580 340" sf:left="#123" sf:right="url(#g)"/>`, gradient);
  const take = async (field, isTaken) => {
    for (const [typed, hex] of [["#ff0000ff", "ff0000"], ["#f00f", "ff0000"], ["oklch(51.975% 0.17686 142.495)", "008000"], ["color(display-p3 0 1 0)", "00fb29"]]) {
      await field.fill(typed);
      await field.press("Enter");
      await until(`${typed} in the field is ${hex}`, async () => (await field.inputValue()) === hex);
      if (isTaken) await isTaken(hex);
    }
  };
  const written = (pattern) => async (hex) => {
    const short = hex.replace(/^(.)\1(.)\2(.)\3$/, "$1$2$3");
    // Colours without exact bytes are written as percentages.
    await until(`${hex} is written`, async () => pattern(`(#${short}|rgb\\([^)]*\\))`).test(await editor.text));
  };
  await loaded(editor, drawing);
  await take(page.getByLabel("Background, hex"), written((color) => new RegExp(`sf:background="${color}"`)));
  await editor.key("a");
  await editor.click(320, 112);
  await take(page.locator(".inspector").getByLabel("Colour of the whole left side, hex"), written((color) => new RegExp(`id="line"[^>]*sf:left="${color}"`)));
  await page.getByRole("group", { name: "Left side" }).first().locator(".stop").first().dblclick();
  await take(page.locator(".picker").getByLabel("Hex"), written((color) => new RegExp(`id="line"[^>]*sf:left="${color}"`)));
  await editor.key("Escape");
  await stage(page).focus();
  await editor.key("Escape");
  await editor.click(320, 300);
  await page.getByRole("group", { name: /^Right side/ }).first().locator(".stop").first().click();
  await take(page.locator(".inspector").getByLabel("Colour, hex", { exact: true }).last(), written((color) => new RegExp(`stop-color="${color}"`)));
  await editor.key("Control+n");
  await take(page.getByRole("dialog").getByLabel("Background, hex"), null);
  await editor.key("Escape");
}

async function testUntitled(editor, fresh) {
  const { page } = editor;
  await startBlank(editor);
  checkEqual(await page.locator(".file-name").textContent(), "untitled.svg", "the name after New");
  const other = await fresh();
  await other.page.getByRole("button", { name: "Try the five steps" }).click();
  await other.page.locator(".file-name").waitFor();
  checkEqual(await other.page.locator(".file-name").textContent(), "untitled.svg", "the name after the tour has begun");
  await other.close();
}

async function testNudges(editor) {
  const { page } = editor;
  const two = text(`${line}<path id="other" d="M60 300L580 300" sf:left="#123" sf:right="#456"/>`);
  await loaded(editor, two);
  await editor.key("v");
  let first;
  await atOnce(page, async () => {
    await editor.click(320, 112);
    first = await changing(editor, "an arrow", () => editor.key("ArrowDown"));
    await editor.click(320, 300);
    await changing(editor, "an arrow", () => editor.key("ArrowDown"));
    await editor.key("ArrowDown", "ArrowDown");
  });
  await editor.key("Control+z");
  await shows(page, first);
  await editor.key("Control+z");
  await shows(page, two);
}

async function testLicences(editor) {
  const { page } = editor;
  await loaded(editor, blank);
  await menu(page, "About Sfumato");
  const { dependencies } = packageOf("./package.json");
  const dialog = page.getByRole("dialog");
  const names = [...Object.keys(dependencies), "fflate", "iobuffer", "pugixml", "wasi-libc", "libc++"];
  await dialog.getByText(/Includes work by others/).waitFor();
  await dialog.getByText("Full licence texts").click();
  await dialog.locator(".licence-texts").waitFor();
  const words = await dialog.textContent();
  for (const name of names) check(words.includes(name), `${name} is not named`);
  const sections = await dialog.locator(".licence-texts section").evaluateAll((all) =>
    all.map((one) => [one.querySelector("h3").textContent, one.querySelector("pre").textContent.length]));
  for (const name of [...names, "Sfumato"]) check((sections.find(([of]) => of === name)?.[1] ?? 0) > 300, `${name} has no licence: ${JSON.stringify(sections)}`);
  await editor.shot("licences");
  await page.keyboard.press("Escape");
}

export async function testTrial(tap, { browser, address, oneFile }) {
  const quick = {
    "undo within the pen takes nodes back, and no edit before them": testPenUndo,
    "undo without a node left goes on to the drawing": testPenUndoThrough,
    "a curve that the pen draws stays in its drawing when another one is opened": testPenLeft,
    "undo within the pencil's line takes the line": testPencilUndo,
    "pencil and stroke end where they snap, without a spike": testSnappedEnds,
    "the repair of a seam keeps every colour": testSeam,
    "a closed curve stays without a seam when a stop gets another colour": testClosedRibbon,
    "the stops of a closed curve are a ring": testRingOfStops,
    "the stops of a side are distributed and reversed": testOrderOfStops,
    "a hint's ring goes with the hint": testRing,
    "no hints are said to be only where they were looked for": testHintsLooking,
    "a new layer is no hint until another one is edited": testNewLayer,
    "500 layers are drawn": testManyLayers,
    "a closed curve can be opened, and says so": testOpenCurve,
    "a placed photo is locked, and lets the drawing show": testPlacedPhoto,
    "a drawing without a background is exported clear, and says so": testTransparent,
    "each colour field takes what files take": testColors,
    "nudges of two curves are two steps": testNudges,
    "the licences of all that is bundled are in the site": testLicences,
  };
  const editor = await EditorPage.open(browser, address);
  for (const [name, body] of Object.entries(quick)) await tap.test(`trial: ${name}`, () => body(editor));
  await tap.test("trial: nothing was complained of", () => editor.checkQuiet());
  await editor.close();
  const once = async (body, at, options) => {
    const fresh = () => EditorPage.open(browser, at, options);
    const own = await fresh();
    await body(own, fresh);
    own.checkQuiet();
    await own.close();
  };
  await tap.test("trial: an untitled drawing has one name", () => once(testUntitled, address));
  await tap.test("trial: the licences of all that is bundled are in the one file", () => once(testLicences, oneFile));
  await tap.test("trial: what cannot be drawn does not show the drawing before", () => once(testStale, address, { isDrawn: true, ratio: 0.5 }));
  await tap.test("trial: thumbs of layers that did not change stay", () => once(testThumbs, address, { isDrawn: true, ratio: 0.5 }));
}
