// Filled shapes: rectangle, ellipse and polygon, closed curves on empty layers, gradients, and the words for sides.
import { EditorPage, check, checkEqual, until } from "./harness.mjs";
import { changing, count, startBlank } from "./draw.mjs";
import { said } from "./words.mjs";

/** Counts what a person does: keys, clicks and drags. */
class Actions {
  constructor(editor) {
    this.editor = editor;
    this.page = editor.page;
    this.count = 0;
  }

  async key(name) {
    this.count += 1;
    await this.page.keyboard.press(name);
  }

  async drag(...points) {
    this.count += 1;
    await this.editor.drag(points);
  }

  async click(role, name) {
    this.count += 1;
    await this.page.getByRole(role, { name, exact: true }).click();
  }

  expect(most) {
    check(this.count <= most, `${this.count} actions, at most ${most} were expected`);
  }
}

const filled = (local) => new RegExp(`<${local} [^>]*sf:right="#[0-9a-f]+" sf:left-opacity="0" sf:right-opacity="1"`);

async function blank({ browser, address }, options) {
  const editor = await EditorPage.open(browser, address, options);
  await startBlank(editor);
  return editor;
}

/** Returns the colour of a point of the artboard on the stage. */
async function colorAt(editor, x, y) {
  const [left, top] = await editor.at(x, y);
  const png = await editor.page.screenshot({ clip: { x: left, y: top, width: 1, height: 1 }, caret: "initial" });
  return editor.page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(bytes)]));
    const context = new OffscreenCanvas(1, 1).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    return [...context.getImageData(0, 0, 1, 1).data.subarray(0, 3)];
  }, [...png]);
}

async function near(editor, [x, y], wanted, what) {
  await editor.settled();
  const found = await colorAt(editor, x, y);
  check(found.every((value, k) => Math.abs(value - wanted[k]) < 8), `${what} is ${found}, expected ${wanted}`);
}

/** A filled ellipse takes a key and a drag, and is one step of undo. */
async function testEllipse(given) {
  const editor = await blank(given, { isDrawn: true, ratio: 1 });
  const start = await editor.text;
  const actions = new Actions(editor);
  const drawn = await changing(editor, "an ellipse", async () => {
    await actions.key("l");
    await actions.drag([100, 100], [400, 300]);
  });
  actions.expect(2);
  check(filled("ellipse").test(drawn), `no filled ellipse: ${drawn}`);
  check(drawn.includes('cx="250" cy="200" rx="150" ry="100"'), "it is elsewhere");
  await near(editor, [250, 200], [224, 110, 78], "the inside");
  await near(editor, [110, 110], [255, 255, 255], "the outside");
  checkEqual(await changing(editor, "undo", () => editor.key("Control+z")), start, "the text after undo");
  editor.checkQuiet();
  await editor.close();
}

/** A second shape lies on the first, on its own layer, in the colour that the options bar shows. */
async function testColor(given) {
  const editor = await blank(given, { isDrawn: true, ratio: 1 });
  const { page } = editor;
  await editor.key("r");
  await editor.drag([[100, 100], [300, 300]]);
  const options = page.getByRole("group", { name: "Tool options" });
  const field = options.getByLabel("Fill of new shapes, hex");
  await field.fill("2050a0");
  await field.press("Enter");
  checkEqual(await options.getByLabel("Fill of new shapes", { exact: true }).inputValue(), "#2050a0", "the swatch");
  await page.locator(".canvas-stage").focus();
  const drawn = await changing(editor, "a second rectangle", () => editor.drag([[200, 200], [400, 400]]));
  checkEqual(count(drawn, /sf:diffuse/g), 2, "layers");
  check(/<rect [^>]*sf:right="#2050a0"/.test(drawn), `another colour: ${drawn}`);
  await near(editor, [250, 250], [32, 80, 160], "where both are");
  await near(editor, [150, 150], [224, 110, 78], "the first one");
  const inspector = page.locator(".inspector");
  await inspector.getByLabel("Colour of the whole inside, hex").fill("gold");
  const gold = await changing(editor, "a colour", () => inspector.getByLabel("Colour of the whole inside, hex").press("Enter"));
  check(/sf:right="(#ffd700|gold)"/.test(gold), `not gold: ${gold}`);
  check(/<rect [^>]*sf:right="#e06e4e"/.test(gold), "the first one changed, too");
  editor.checkQuiet();
  await editor.close();
}

/** A shape with a gradient takes four actions; the gradient goes from edge to edge, to the same hue. */
async function testGradient(given) {
  const editor = await blank(given);
  const actions = new Actions(editor);
  await changing(editor, "a rectangle", async () => {
    await actions.key("r");
    await actions.drag([100, 100], [400, 300]);
  });
  const drawn = await changing(editor, "a gradient", async () => {
    await actions.click("button", "Type of the inside");
    await actions.click("menuitem", "Linear gradient");
  });
  actions.expect(5);
  check(/<linearGradient [^>]*x1="100" y1="200" x2="400" y2="200"/.test(drawn), `not from edge to edge: ${drawn}`);
  check(/stop-color="#e06e4e"\/>[^<]*<stop offset="1" stop-color="#(?!fff)/.test(drawn), `other colours: ${drawn}`);
  check(/<rect [^>]*sf:right="url\(#gradient\)"/.test(drawn), "the inside shows no gradient");
  await editor.page.getByRole("group", { name: "Inside, linear gradient “gradient”" }).waitFor();
  await editor.key("a");
  await editor.page.getByRole("button", { name: "Start of the gradient, inside" }).waitFor();
  editor.checkQuiet();
  await editor.close();
}

/** A gradient's ends do not lie on the nodes of an ellipse, which could not be dragged then. */
async function testGradientEnds(given) {
  const editor = await blank(given);
  await editor.key("l");
  await changing(editor, "an ellipse", () => editor.drag([[100, 100], [400, 300]]));
  const drawn = await changing(editor, "a gradient", async () => {
    await editor.page.getByRole("button", { name: "Type of the inside" }).click();
    await editor.page.getByRole("menuitem", { name: "Linear gradient" }).click();
  });
  check(/<linearGradient [^>]*x1="100" y1="175" x2="400" y2="175"/.test(drawn), `on a node: ${drawn}`);
  await editor.close();
}

/** The pen closes a curve on an empty layer; on the same layer a second one is a plain curve. */
async function testPen(given) {
  const editor = await blank(given);
  await editor.key("p");
  const drawn = await changing(editor, "a closed curve", async () => {
    for (const [x, y] of [[100, 100], [100, 300], [300, 300], [100, 100]]) await editor.click(x, y);
  });
  check(/<path d="[^"]*Z" sf:left="#e06e4e" sf:left-opacity="1" sf:right-opacity="0"/.test(drawn), `no shape: ${drawn}`);
  await editor.page.getByRole("button", { name: "Type of the outside" }).waitFor();
  const more = await changing(editor, "a second one", async () => {
    for (const [x, y] of [[400, 100], [500, 300], [400, 300], [400, 100]]) await editor.click(x, y);
  });
  checkEqual(count(more, /-opacity="0"/g), 1, "shapes");
  await changing(editor, "undo", () => editor.key("Control+z"));
  const empty = await changing(editor, "undo", () => editor.key("Control+z"));
  checkEqual(count(empty, /<path/g), 0, "curves after undo");
  await editor.key("b");
  const pencil = await changing(editor, "a loop of the pencil", () =>
    editor.drag([[300, 200], [350, 250], [300, 300], [250, 250], [299, 201]], { steps: 8 }));
  check(/<path d="[^"]*Z"[^>]*-opacity="0"/i.test(pencil), `no shape: ${pencil}`);
  editor.checkQuiet();
  await editor.close();
}

const scene = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <!-- two curves -->
  <g id="l" sf:diffuse="true">
    <path id="line" d="M50 400L600 420" sf:left="#dde" sf:right="#785"/>
    <path id="ring" d="M200 100H400V300H200Z" sf:left="#dde"  sf:right='#c33'/>
  </g>
</svg>
`;

/** By key and by menu a closed curve becomes a shape of its own; an open curve is refused. */
async function testOwnShape(given) {
  const editor = await EditorPage.open(given.browser, given.address);
  const { page } = editor;
  await editor.load(scene);
  await editor.key("v");
  await editor.click(200, 200);
  const moved = await changing(editor, "Shift S", () => editor.key("Shift+S"));
  const own = `<path id="ring" d="M200 100H400V300H200Z" sf:left="#dde"  sf:right='#c33' sf:left-opacity='0' sf:right-opacity='1'/>`;
  const layer = `\n  <g sf:diffuse="true">\n    ${own}\n  </g>`;
  checkEqual(moved.replace(layer, ""), scene.replace(/\n *<path id="ring".*/, ""), "the rest of the text");
  check(moved.includes(`</g>${layer}`), `not above its layer: ${moved}`);
  checkEqual(await page.evaluate(() => window.sfumatoEditor.selection.map(({ name }) => name)), ["ring"], "the selection");
  await editor.key("Shift+S");
  await said(page, /already a shape of its own/);
  checkEqual(await changing(editor, "undo", () => editor.key("Control+z")), scene, "the text after undo");
  await editor.click(200, 200, { button: "right" });
  await changing(editor, "the menu", () => page.getByRole("menuitem", { name: "Make a shape of its own" }).click());
  await editor.click(50, 400);
  await editor.key("Shift+S");
  await said(page, /Select a closed curve first/);
  editor.checkQuiet();
  await editor.close();
}

/** Panel, menus and handles name the sides of closed curves, the inside first; also in a mirrored frame. */
async function testWords(given) {
  const editor = await EditorPage.open(given.browser, given.address);
  const { page } = editor;
  await editor.load(scene.replace('id="l"', 'id="l" transform="matrix(-1 0 0 1 640 0)"'));
  const names = async () => (await page.locator(".inspector .side-name").allTextContents()).map((name) => name.trim());
  await editor.key("v");
  await editor.click(240, 200);
  await until("the sides are inside and outside", async () => (await names()).join(" ") === "Inside Outside Inside Outside");
  await page.getByRole("group", { name: "Inside", exact: true }).waitFor();
  await page.getByLabel("Opacity, inside").waitFor();
  await page.getByRole("button", { name: "Inside stop 1 of 1, #cc3333, at 0 %" }).waitFor();
  await editor.key("a");
  await page.locator('.mark[aria-label^="Outside stop 1 of 1, #ddddee"]').waitFor();
  await editor.click(590, 400);
  await until("the sides are left and right", async () => (await names()).join(" ") === "Left Right Left Right");
  await page.getByRole("group", { name: "Left side" }).waitFor();
  editor.checkQuiet();
  await editor.close();
}

/** Arrow keys change the sides while a polygon is drawn, and the options bar before; Shift makes it regular. */
async function testPolygon(given) {
  const editor = await blank(given);
  const { page } = editor;
  await editor.key("n");
  const [from, to] = await editor.all([[100, 100], [300, 300]]);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 4 });
  for (const key of ["ArrowDown", "ArrowDown", "ArrowUp"]) await editor.key(key);
  const drawn = await changing(editor, "a polygon", () => page.mouse.up());
  checkEqual(/points="([^"]*)"/.exec(drawn)[1].split(" ").length, 5, "corners");
  const sides = page.getByRole("group", { name: "Tool options" }).getByLabel("Sides");
  checkEqual(await sides.inputValue(), "5", "sides in the options bar");
  await sides.fill("4");
  await sides.press("Enter");
  await page.locator(".canvas-stage").focus();
  const other = await changing(editor, "a second one", () => editor.drag([[350, 100], [450, 120]], { keys: ["Shift"] }));
  check(other.includes('points="400,100 450,150 400,200 350,150"'), `not regular: ${other}`);
  await sides.fill("2");
  await sides.press("Enter");
  await said(page, /Must be 3 or more/, ".options");
  editor.checkQuiet();
  await editor.close();
}

/** Arrow keys move the corner, Enter and Space set it; Shift makes a square while it is held. */
async function testKeysAlone(given) {
  const editor = await blank(given);
  const { page } = editor;
  const tag = () => page.locator(".canvas-tag-line").textContent();
  await page.locator(".canvas-stage").focus();
  const before = await editor.text;
  await editor.key("r", "ArrowLeft", "Enter", "Shift+ArrowRight", "Shift+ArrowRight", "ArrowDown");
  const [width, height] = (await tag()).split(" × ").map(Number);
  check(Math.abs(width / height - 10) < 0.2, `100 by 10 pixels are ${width} by ${height}`);
  await page.keyboard.down("Shift");
  await until("a square is shown", async () => (await tag()) === `${width} × ${width}`);
  await page.keyboard.up("Shift");
  await until("the shape is as before", async () => (await tag()) === `${width} × ${height}`);
  await said(page, new RegExp(`Rectangle, ${width} × ${height}`), "[role=status].visually-hidden");
  await editor.key("Escape");
  checkEqual(await editor.text, before, "the text after Escape");
  checkEqual(await page.locator(".canvas-tag-line").count(), 0, "tags after Escape");
  await editor.key("ArrowLeft", " ", "Shift+ArrowRight", "Shift+ArrowDown");
  const drawn = await changing(editor, "Space", () => editor.key(" "));
  check(filled("rect").test(drawn), `no filled rectangle: ${drawn}`);
  // The shape is selected: arrows move it. Without a selection they move the corner of the next one.
  await changing(editor, "an arrow", () => editor.key("ArrowLeft"));
  await editor.key("l", "Escape", "Escape", "ArrowUp", "Enter", "ArrowUp", "ArrowLeft");
  const both = await changing(editor, "Enter", () => editor.key("Enter"));
  check(filled("(circle|ellipse)").test(both), `no filled circle: ${both}`);
  editor.checkQuiet();
  await editor.close();
}

/** At the right edge of a phone the size stands before the edge. */
async function testTagAtEdge(given) {
  const editor = await blank(given, { size: [390, 844] });
  const { page } = editor;
  await editor.key("l");
  const stage = await page.locator(".canvas-stage").boundingBox();
  await page.mouse.move(stage.x + 100, stage.y + 100);
  await page.mouse.down();
  await page.mouse.move(stage.x + stage.width - 4, stage.y + 200.5, { steps: 3 });
  const tag = await page.locator(".canvas-tag-line .tag").boundingBox();
  check(tag.x + tag.width <= stage.x + stage.width, `the tag ends at ${tag.x + tag.width} of ${stage.x + stage.width}`);
  check(tag.width > 40, `the tag is ${tag.width} wide`);
  await editor.shot("shapes-tag-phone");
  await page.mouse.up();
  editor.checkQuiet();
  await editor.close();
}

/** Clicks, flat drags, Escape, undo, locked layers, read-only drawings and tiny places: no fault, nothing lost. */
async function testBadInput(given) {
  const editor = await blank(given);
  const { page } = editor;
  const start = await editor.text;
  await editor.key("r");
  await editor.click(100, 100);
  await said(page, /Drag from corner to corner to draw a rectangle/);
  await editor.drag([[100, 100], [300, 100]]);
  const [from, to] = await editor.all([[100, 100], [300, 300]]);
  for (const key of ["Escape", "Control+z"]) {
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(...to, { steps: 3 });
    await editor.key(key);
    await page.mouse.up();
  }
  checkEqual(await editor.text, start, "the text");
  const locked = scene.replace('id="l"', 'id="l" sodipodi:insensitive="true" xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"');
  await editor.load(locked);
  const drawn = await changing(editor, "above a locked layer", () => editor.drag([[10, 10], [90, 90]]));
  check(/<\/g>\s*<g sf:diffuse="true">\s*<rect /.test(drawn), `not above it: ${drawn}`);
  await editor.load(`<!DOCTYPE svg [<!ENTITY a "b">]>${scene}`);
  await editor.drag([[10, 10], [90, 90]]);
  await said(page, /./);
  check(!(await editor.text).includes("<rect"), "a read-only drawing changed");
  await editor.load(scene);
  for (let k = 0; k < 30; k += 1) await editor.key("+");
  const middle = await page.locator(".canvas-stage").boundingBox();
  const [x, y] = [middle.x + middle.width / 2, middle.y + middle.height / 2];
  const tiny = await changing(editor, "a tiny one", async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y + 30, { steps: 3 });
    await page.mouse.up();
  });
  const [, width, height] = /<rect [^>]*width="([^"]*)" height="([^"]*)"/.exec(tiny);
  check(Number(width) > 0 && Math.abs(width / height - 4 / 3) < 0.02, `${width} × ${height}`);
  editor.checkQuiet();
  await editor.close();
}

/** Takes the pictures that people look at. */
async function testLooks(given) {
  for (const [colorScheme, size, name] of [
    ["light", [1440, 900], "wide-light"],
    ["dark", [1440, 900], "wide-dark"],
    ["light", [390, 844], "phone-light"],
    ["dark", [390, 844], "phone-dark"],
  ]) {
    const editor = await blank(given, { isDrawn: true, ratio: 1, colorScheme, size });
    await editor.key("n");
    await changing(editor, "a polygon", () => editor.drag([[80, 80], [340, 360]]));
    const [from, to] = await editor.all([[300, 200], [560, 380]]);
    await editor.key("l");
    await editor.page.mouse.move(...from);
    await editor.page.mouse.down();
    await editor.page.mouse.move(...to, { steps: 4 });
    await editor.shot(`shapes-${name}`);
    await editor.page.mouse.up();
    editor.checkQuiet();
    await editor.close();
  }
}

export async function testShapes(tap, given) {
  const tests = {
    "a filled ellipse takes two actions": testEllipse,
    "a shape covers the shapes below it, in the colour of the options bar": testColor,
    "a shape with a gradient takes five actions at most": testGradient,
    "a gradient's ends do not lie on nodes": testGradientEnds,
    "a curve that is closed on an empty layer is a filled shape": testPen,
    "a closed curve becomes a shape of its own": testOwnShape,
    "the sides of a closed curve are called inside and outside": testWords,
    "the sides of a polygon change while it is drawn": testPolygon,
    "shapes are drawn by keys alone": testKeysAlone,
    "the size of a shape is seen at the edge of a phone": testTagAtEdge,
    "shapes withstand bad input": testBadInput,
    "shapes while they are drawn, in both themes": testLooks,
  };
  for (const [name, test] of Object.entries(tests)) await tap.test(`shapes: ${name}`, () => test(given));
}
