// SVG of other programs: opened, dropped and pasted, it becomes curves.
import { drop, paste } from "./disk.mjs";
import { changing, count } from "./draw.mjs";
import { check, checkEqual, EditorPage } from "./harness.mjs";
import { said, shows, textAfter } from "./words.mjs";

const drawing = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:version="1" sf:background="#fff">
  <g id="layer" sf:diffuse="true">
    <path id="line" d="M60 112L580 112" sf:left="#e33" sf:right="#36c"/>
  </g>
</svg>
`;
const icon = `<svg xmlns="http://www.w3.org/2000/svg" width="24" height="24" viewBox="0 0 24 24">
  <path fill="#e33" d="M2 2H22V12H2Z"/><circle cx="12" cy="18" r="4" fill="#36c"/>
</svg>
`;
const withWords = icon.replace("</svg>", '<text x="2" y="9">Words</text></svg>');
const wordsAlone = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><text x="2" y="9">Words</text></svg>';

const question = (page) => page.getByRole("dialog", { name: /has no diffusion curves/ });
const choose = (page, name) => question(page).getByRole("button", { name }).click();

async function dropped(page, name, svg) {
  await drop(page, [{ name, bytes: Buffer.from(svg) }]);
  await question(page).waitFor();
}

/** Checks that a text has one curve of each colour of the icon. */
function checkIcon(text) {
  checkEqual([count(text, /sf:right="#ee3333/g), count(text, /sf:right="#3366cc/g)], [1, 1], "sides of the shapes' colours");
}

async function testQuestion(editor) {
  const { page } = editor;
  await editor.load(drawing);
  await dropped(page, "icon.svg", icon);
  checkEqual(await editor.text, drawing, "the text while it is asked");
  await editor.shot("foreign");
  await page.keyboard.press("Escape");
  await question(page).waitFor({ state: "detached" });
  checkEqual(await editor.text, drawing, "the text after Escape");
  await dropped(page, "icon.svg", icon);
  await choose(page, "Open as it is");
  await shows(page, icon);
}

async function testConverted(editor) {
  const { page } = editor;
  await editor.load(drawing);
  await dropped(page, "icon.svg", icon);
  await choose(page, "Convert");
  checkIcon(await textAfter(page, drawing));
  await said(page, /“icon\.svg” was converted to 2 curves\./);
  await editor.settled();
  checkEqual((await page.evaluate(() => window.sfumatoEditor.status)).kind, "exact", "the picture");
}

async function testLeftOut(editor) {
  const { page } = editor;
  await editor.load(drawing);
  await dropped(page, "words.svg", withWords);
  await choose(page, "Convert");
  await said(page, /2 curves; some parts were left out/);
  await page.getByRole("button", { name: "Show", exact: true }).click();
  await said(page, /Left out of “words\.svg”.*Line 3, column 1: the text/s, "dialog");
  await editor.shot("foreign-left-out");
  await page.keyboard.press("Escape");
  await dropped(page, "alone.svg", wordsAlone);
  await choose(page, "Convert");
  await said(page, /Nothing in this SVG can be converted to curves.*text/s, "dialog [role=alert]");
  await editor.shot("foreign-nothing");
  await choose(page, "Open as it is");
  await shows(page, wordsAlone);
}

async function testInserted(editor) {
  const { page } = editor;
  await editor.load(drawing);
  await dropped(page, "icon.svg", icon);
  const inserted = await changing(editor, "Insert", () => choose(page, "Insert as layers"));
  await said(page, /“icon\.svg” was converted to 2 curves\./);
  check(inserted.includes('<path id="line" d="M60 112L580 112" sf:left="#e33" sf:right="#36c"/>'), "the drawing lost its curve");
  checkIcon(inserted);
  checkEqual(await page.getByRole("treeitem", { selected: true }).count(), 1, "the new layer is selected");
  await editor.shot("foreign-inserted");
  await page.locator(".canvas-stage").focus();
  await editor.key("Control+z");
  await shows(page, drawing);
}

/** On the first page no drawing is there to insert into. */
async function testFirst(editor) {
  const { page } = editor;
  await dropped(page, "icon.svg", icon);
  checkEqual(await question(page).getByRole("button", { name: "Insert as layers" }).count(), 0, "a choice without effect");
  await choose(page, "Convert");
  await said(page, /converted to 2 curves/);
}

async function testPasted(editor) {
  const { page } = editor;
  await editor.load(drawing);
  await page.locator(".canvas-stage").focus();
  await paste(page, { text: withWords });
  checkIcon(await textAfter(page, drawing));
  await said(page, /“pasted\.svg” was converted to 2 curves; some parts were left out/);
  await page.getByRole("button", { name: "Show", exact: true }).click();
  await said(page, /Line 3, column 1: the text/, "dialog");
  await page.keyboard.press("Escape");
  await page.locator(".canvas-stage").focus();
  await editor.key("Control+z");
  await shows(page, drawing);
  await paste(page, { text: wordsAlone });
  await said(page, /Nothing was pasted.*text/s, "dialog");
  checkEqual(await editor.text, drawing, "the text after words were pasted");
  await page.keyboard.press("Escape");
}

const MEGABYTES = 60;

/** Drops or pastes 60 MB of SVG, which the page itself puts together. */
function giveLarge(page, how) {
  return page.locator(".canvas-stage").evaluate(
    (stage, [way, megabytes]) => {
      const shape = `<path fill="#e33" d="M9 9${"l3 4-2 1".repeat(600)}z"/>\n`;
      const chunk = shape.repeat(Math.floor(2 ** 20 / shape.length));
      const parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 480">', ...Array(megabytes).fill(chunk), "</svg>"];
      const data = new DataTransfer();
      if (way === "drop") data.items.add(new File(parts, "large.svg", { type: "image/svg+xml" }));
      else data.setData("text/plain", parts.join(""));
      stage.focus();
      const more = { bubbles: true, cancelable: true };
      if (way === "drop") stage.dispatchEvent(new DragEvent("drop", { dataTransfer: data, ...more }));
      else stage.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, ...more }));
    },
    [how, MEGABYTES],
  );
}

/** The answer names the limit; both ways can be cancelled, and nothing is lost. */
async function testLarge(editor) {
  const { page } = editor;
  await editor.load(drawing);
  await giveLarge(page, "drop");
  await question(page).waitFor();
  await choose(page, "Convert");
  await choose(page, "Cancel");
  await choose(page, "Convert");
  await said(page, /more than the limit of 4000000 control points/, "dialog [role=alert]");
  checkEqual(await editor.text, drawing, "the text after a large file");
  await page.keyboard.press("Escape");
  await question(page).waitFor({ state: "detached" });
  await giveLarge(page, "paste");
  await page.getByRole("status").getByRole("button", { name: "Stop" }).click();
  await page.getByText("Converting SVG…").waitFor({ state: "detached" });
  checkEqual(await page.getByRole("dialog").count(), 0, "complaints after Stop");
  // The page works on.
  await page.locator(".canvas-stage").focus();
  await editor.key("Control+a");
  await changing(editor, "an arrow", () => editor.key("ArrowRight"));
}

export async function testForeign(tap, { browser, address }) {
  const editor = await EditorPage.open(browser, address);
  await tap.test("foreign: on the first page a file becomes a drawing", () => testFirst(editor));
  await tap.test("foreign: nothing is opened until the person has chosen", () => testQuestion(editor));
  await tap.test("foreign: a file becomes a drawing", () => testConverted(editor));
  await tap.test("foreign: the omitted parts are listed", () => testLeftOut(editor));
  await tap.test("foreign: a file becomes layers of the drawing, in one step of undo", () => testInserted(editor));
  await tap.test("foreign: pasted SVG becomes layers, and the omitted parts are listed", () => testPasted(editor));
  await tap.test("foreign: 60 MB of SVG get an answer, can be stopped, and lose nothing", () => testLarge(editor));
  await tap.test("foreign: nothing was complained of", () => editor.checkQuiet());
  await editor.close();
}
