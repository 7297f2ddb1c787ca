// Rulers and guides: dragged from a ruler, moved, snapped to, removed; and all of it by keys alone.
import { check, checkEqual, EditorPage, until } from "./harness.mjs";
import { changing } from "./draw.mjs";

const start = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="-20 10 640 480" sf:background="#fff">
  <g id="back" sf:diffuse="true">
    <path id="box" d="M100 300L200 300L200 360L100 360Z" sf:left="#e33" sf:right="#36c"/>
  </g>
</svg>
`;

/** The width of a ruler, CSS pixels. */
const RULER = 18;

class Guides {
  constructor(editor) {
    this.editor = editor;
    this.page = editor.page;
  }

  async fresh(text = start) {
    await this.editor.load(text);
    await this.page.locator(".canvas-stage").focus();
    await this.page.keyboard.press("v");
    await this.page.keyboard.press("Escape");
  }

  async rulers(isShown) {
    const rulers = this.page.locator(".rulers");
    if ((await rulers.count()) > 0 !== isShown) await this.page.keyboard.press("Alt+r");
    await rulers.waitFor({ state: isShown ? "visible" : "detached" });
  }

  /** Drags from a ruler to a point of the artboard. */
  async fromRuler(side, [x, y], keys = []) {
    const { page } = this;
    const stage = await page.locator(".canvas-stage").boundingBox();
    const to = await this.editor.at(x, y);
    const from = side === "top" ? [to[0] + 40, stage.y + RULER / 2] : [stage.x + RULER / 2, to[1] + 40];
    for (const key of keys) await page.keyboard.down(key);
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(...to, { steps: 5 });
    await page.mouse.up();
    for (const key of keys) await page.keyboard.up(key);
  }

  /** Returns the guides of the file: "x 12", "y 30", on the artboard of `start`. */
  async places() {
    const found = [...(await this.editor.text).matchAll(/<sodipodi:guide position="([^,]+),([^"]+)" orientation="(\d),/g)];
    return found.map(([, x, y, isVertical]) => (isVertical === "1" ? `x ${Number(x) - 20}` : `y ${490 - Number(y)}`));
  }
}

async function testFromRulers(g) {
  const { editor, page } = g;
  await g.fresh();
  await g.rulers(true);
  const one = await changing(editor, "a vertical guide", () => g.fromRuler("left", [150.2, 100]));
  const half = one.match(/position="([^,]+),0" orientation="1,0"/)?.[1];
  check(half !== undefined && Number.isInteger(Number(half) * 10), `no round place: ${one}`);
  // The middle of the box is nearer than 8 pixels.
  checkEqual(await g.places(), ["x 150"], "the guide");
  await changing(editor, "a horizontal guide", () => g.fromRuler("top", [300, 200], ["Control"]));
  const [, free] = await g.places();
  check(Math.abs(Number(free.slice(2)) - 200) < 1e-5, `the guide is at ${free}`);
  const two = await editor.text;
  checkEqual(two.replace(/ {2}<sodipodi:namedview>.*<\/sodipodi:namedview>\n| xmlns:sodipodi="[^"]*"/g, ""), start, "the rest of the file");
  await editor.shot("guides");
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), one, "after one undo");
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), start, "after two");
  await changing(editor, "redo", () => page.keyboard.press("Control+Shift+z"));
  checkEqual(await changing(editor, "redo", () => page.keyboard.press("Control+Shift+z")), two, "after redo");
  // A drag that ends on the ruler, and Escape within one, add nothing.
  const stage = await page.locator(".canvas-stage").boundingBox();
  await page.mouse.move(stage.x + 300, stage.y + 9);
  await page.mouse.down();
  await page.mouse.move(stage.x + 300, stage.y + 200, { steps: 3 });
  await page.mouse.move(stage.x + 300, stage.y + 5, { steps: 3 });
  await page.mouse.up();
  await page.mouse.move(stage.x + 9, stage.y + 300);
  await page.mouse.down();
  await page.mouse.move(stage.x + 200, stage.y + 300, { steps: 3 });
  await page.keyboard.press("Escape");
  await page.mouse.up();
  // The corner has no guides.
  await page.mouse.move(stage.x + 9, stage.y + 9);
  await page.mouse.down();
  await page.mouse.move(stage.x + 200, stage.y + 300, { steps: 3 });
  await page.mouse.up();
  checkEqual(await editor.text, two, "the text");
  await g.rulers(false);
}

async function testMoving(g) {
  const { editor, page } = g;
  await g.fresh();
  await g.rulers(true);
  await changing(editor, "a guide", () => g.fromRuler("left", [400, 100]));
  const before = await editor.text;
  const [x] = (await g.places())[0].match(/[\d.]+/).map(Number);
  await changing(editor, "moved", () => editor.drag([[x, 240], [450, 260]]));
  const moved = Number((await g.places())[0].slice(2));
  check(Math.abs(moved - 450) < 1, `moved to ${moved}`);
  // It has the keys: arrows are one step of undo.
  const zoom = (await editor.at(1, 0))[0] - (await editor.at(0, 0))[0];
  await changing(editor, "an arrow", () => page.keyboard.press("Shift+ArrowLeft"));
  check(Math.abs(Number((await g.places())[0].slice(2)) - (moved - 10 / zoom)) < 1e-3, `nudged to ${await g.places()}`);
  await changing(editor, "undo", () => page.keyboard.press("Control+z"));
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), before, "after two undos");
  // A click chooses, Delete removes.
  await editor.click(x, 300);
  const none = await changing(editor, "Delete", () => page.keyboard.press("Delete"));
  check(!none.includes("guide"), `still there: ${none}`);
  await changing(editor, "undo", () => page.keyboard.press("Control+z"));
  // With a selection the keys are the selection's again.
  await editor.click(x, 420);
  await editor.click(100, 330);
  await until("the box is selected", () => page.evaluate(() => window.sfumatoEditor.selection.length === 1));
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Delete");
  checkEqual(await g.places(), [`x ${x}`], "guides after Delete without a choice");
  // Back to the ruler.
  const stage = await page.locator(".canvas-stage").boundingBox();
  const at = await editor.at(x, 240);
  await changing(editor, "back to the ruler", async () => {
    await page.mouse.move(...at);
    await page.mouse.down();
    await page.mouse.move(stage.x + 100, at[1], { steps: 3 });
    await page.mouse.move(stage.x + 5, at[1], { steps: 3 });
    await page.mouse.up();
  });
  checkEqual(await g.places(), [], "guides");
  // A double click shows the numbers.
  await changing(editor, "undo", () => page.keyboard.press("Control+z"));
  await editor.click(x, 240, { clickCount: 2 });
  await page.getByRole("dialog", { name: "Guides" }).waitFor();
  await page.keyboard.press("Escape");
  await g.rulers(false);
}

async function testSnapping(g) {
  const { editor, page } = g;
  const guides =
    '<sodipodi:namedview xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"><sodipodi:guide position="323.25,0" orientation="1,0"/><sodipodi:guide position="0,369.5" orientation="0,1"/><sodipodi:guide position="0,0" orientation="1,1"/></sodipodi:namedview>';
  const text = start.replace("<g ", `${guides}\n  <g `);
  await g.fresh(text);
  checkEqual(await g.places(), ["x 303.25", "y 120.5", "x -20"], "guides of the file");
  await page.keyboard.press("p");
  await editor.click(302, 123);
  await editor.click(450, 119);
  const drawn = await changing(editor, "the pen", () => page.keyboard.press("Enter"));
  const [x0, y0, x1, y1] = drawn.match(/d="M([\d.]+) ([\d.]+) L([\d.]+) ([\d.]+)"/)?.slice(1).map(Number) ?? [];
  checkEqual([x0, y0, y1], [303.25, 120.5, 120.5], "places of the pen's nodes");
  check(Math.abs(x1 - 450) < 1, `the other coordinate is free: ${x1}`);
  await page.keyboard.press("Control+z");
  // A moved shape: its right edge at the vertical guide.
  await page.keyboard.press("v");
  await editor.click(100, 330);
  const moved = await changing(editor, "a move", () => editor.drag([[100, 330], [202.7, 400]]));
  const d = moved.match(/id="box" d="M([\d.]+) ([\d.]+)/).slice(1).map(Number);
  check(Math.abs(d[0] - 203.25) < 2e-3, `its edge is not at the guide: ${d}`);
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), text, "after undo");
  const free = await changing(editor, "a free move", () => editor.drag([[100, 330], [202.7, 400]], { keys: ["Control"] }));
  check(Math.abs(Number(free.match(/id="box" d="M([\d.]+)/)[1]) - 203.25) > 0.01, "Ctrl does not prevent it");
  await changing(editor, "undo", () => page.keyboard.press("Control+z"));
  // Hidden guides attract nothing.
  await page.keyboard.press("Control+;");
  await until("the guides are hidden", async () => (await editor.text).includes('showguides="false"'));
  const apart = await changing(editor, "a move", () => editor.drag([[100, 330], [202.7, 400]]));
  check(Math.abs(Number(apart.match(/id="box" d="M([\d.]+)/)[1]) - 203.25) > 0.01, "a hidden guide attracts");
}

async function testWithoutPointer(g) {
  const { editor, page } = g;
  await g.fresh();
  await page.keyboard.press("Alt+g");
  const dialog = page.getByRole("dialog", { name: "Guides" });
  await dialog.waitFor();
  const button = (name) => dialog.getByRole("button", { name });
  await button("Add a vertical guide").focus();
  await changing(editor, "a guide", () => page.keyboard.press("Enter"));
  checkEqual(await g.places(), ["x 300"], "in the middle");
  await button("Add a horizontal guide").focus();
  await changing(editor, "another", () => page.keyboard.press("Enter"));
  await dialog.getByLabel("Vertical guide, x").focus();
  await page.keyboard.type("640/4+0.5");
  await changing(editor, "a sum", () => page.keyboard.press("Enter"));
  checkEqual(await g.places(), ["x 160.5", "y 250"], "the guides");
  await changing(editor, "an arrow", () => page.keyboard.press("ArrowUp"));
  checkEqual(await g.places(), ["x 161.5", "y 250"], "the guides");
  await editor.shot("guides-dialog");
  await button("Remove guide").first().focus();
  await changing(editor, "removed", () => page.keyboard.press("Enter"));
  checkEqual(await g.places(), ["y 250"], "the guides");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+k");
  await page.keyboard.type("lock gui");
  await changing(editor, "locked", () => page.keyboard.press("Enter"));
  await page.keyboard.press("Alt+g");
  check(await dialog.getByLabel("Horizontal guide, y").isDisabled(), "a locked guide can be moved");
  await page.keyboard.press("Escape");
  // A locked guide is no obstacle for the pointer.
  const locked = await editor.text;
  await editor.drag([[400, 250], [420, 300]]);
  checkEqual(await editor.text, locked, "the text");
  await page.keyboard.press("Alt+g");
  await button("Remove all guides").focus();
  const none = await changing(editor, "all are removed", () => page.keyboard.press("Enter"));
  check(!/guide position/.test(none), `still there: ${none}`);
  check(await button("Remove all guides").isDisabled(), "there is nothing to remove");
  await page.keyboard.press("Escape");
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), locked, "after undo");
}

/** A pen's draft stays while a guide is added, and odd files neither break nor change. */
async function testOdd(g) {
  const { editor, page } = g;
  await g.fresh();
  await g.rulers(true);
  await page.keyboard.press("p");
  await editor.click(300, 100);
  await editor.click(400, 150);
  await changing(editor, "a guide", () => g.fromRuler("top", [300, 240]));
  await editor.click(500, 100);
  const drawn = await changing(editor, "the curve", () => page.keyboard.press("Enter"));
  check(/d="M300[^"]*L400[^"]*L500/.test(drawn), `the draft is gone: ${drawn}`);
  const many = Array.from({ length: 20000 }, (_, k) => `<s:guide position="${k % 700},${k % 500}" orientation="${k % 3},1"/>`).join("");
  const odd = '<s:guide position="NaN,1"/><s:guide position="1e999,0" orientation="1,0"/><s:guide/><s:guide position="5,5" orientation="0,0"/>';
  const text = start.replace("<g ", `<s:namedview xmlns:s="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">${odd}${many}</s:namedview><g `);
  await g.fresh(text);
  await page.keyboard.press("+");
  await page.mouse.move(...(await editor.at(200, 200)));
  await page.keyboard.press("Alt+g");
  await page.getByRole("dialog", { name: "Guides" }).waitFor();
  await page.keyboard.press("Escape");
  checkEqual(await editor.text, text, "the text");
  await g.rulers(false);
}

async function withGuides({ browser, address }, test) {
  const editor = await EditorPage.open(browser, address, { reducedMotion: "reduce" });
  await test(new Guides(editor));
  editor.checkQuiet();
  await editor.close();
}

export async function testGuides(tap, given) {
  await tap.test("guides come from the rulers, and undo takes each away", () => withGuides(given, testFromRulers));
  await tap.test("guides are moved, nudged and removed", () => withGuides(given, testMoving));
  await tap.test("the pen and moved shapes snap to guides", () => withGuides(given, testSnapping));
  await tap.test("guides are made, placed and locked by keys alone", () => withGuides(given, testWithoutPointer));
  await tap.test("guides leave a draft alone, and thousands of them or odd ones do no harm", () => withGuides(given, testOdd));
}
