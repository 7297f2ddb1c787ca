// The tree of layers: thumbnails and when they change, names for a screen reader, rows under the mouse.
import { check, checkEqual, EditorPage } from "./harness.mjs";
import { changing } from "./draw.mjs";
import { askedAgain, callsOf, idleMoments, pass } from "./hooks.mjs";

const drawing = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <defs><path id="shape" d="M300 100C420 100 420 300 300 300S180 110 300 100" sf:left="#e33" sf:right="#36c" sf:left-opacity="0" sf:right-opacity="1"/></defs>
  <g id="back" sf:diffuse="true">
    <path id="low" d="M-10 300L650 300" sf:left="#f00" sf:right="#00f"/>
    <path id="high" d="M-10 100L650 100" sf:left="#f00" sf:right="#f00"/>
  </g>
  <g id="copies" sf:diffuse="true"><use href="#shape"/></g>
  <g id="set"><g id="ball" sf:diffuse="true"><path id="ring" d="M50 50h80v80h-80z" sf:left="#0f0" sf:right="#0f0" sf:right-opacity="1" sf:left-opacity="0"/></g></g>
</svg>
`;

const row = (page, name) => page.locator("[role=treeitem]", { has: page.locator(`.name:text-is("${name}")`) });
const thumb = (page, name) => row(page, name).locator("img.thumb");

/** Returns red, green, blue, alpha at a place of a thumbnail, given as shares of its sides. */
const pixelOf = (image, x, y) =>
  image.evaluate(
    async (img, [u, v]) => {
      await img.decode();
      const canvas = new OffscreenCanvas(img.naturalWidth, img.naturalHeight);
      const context = canvas.getContext("2d");
      context.drawImage(img, 0, 0);
      return [...context.getImageData(Math.floor(u * canvas.width), Math.floor(v * canvas.height), 1, 1).data];
    },
    [x, y],
  );

const isNear = (a, b) => a.every((value, k) => Math.abs(value - b[k]) <= 12);

async function testThumbs({ browser, address }) {
  const editor = await EditorPage.open(browser, address, { isDrawn: true });
  const { page } = editor;
  await editor.load(drawing);
  for (const name of ["back", "copies", "set"]) await thumb(page, name).waitFor();
  const [above, below] = [await pixelOf(thumb(page, "back"), 0.5, 0.35), await pixelOf(thumb(page, "back"), 0.5, 0.9)];
  check(isNear(above, [255, 0, 0, 255]) && isNear(below, [0, 0, 255, 255]), `back shows ${above} and ${below}`);
  const ball = await pixelOf(thumb(page, "set"), 0.5, 0.5);
  check(isNear(ball, [0, 255, 0, 255]), `the ball is not as large as its thumb: ${ball}`);
  checkEqual((await pixelOf(thumb(page, "set"), 0.05, 0.05))[3], 0, "alpha beside the ball");
  check((await pixelOf(thumb(page, "copies"), 0.5, 0.4))[3] > 200, "the thumb of copies is empty");
  const addresses = () => page.locator(".tree-row img.thumb").evaluateAll((all) => all.map(({ src }) => src));
  const before = await addresses();
  // While the pointer moves, nothing is drawn in the tree.
  await editor.click(320, 300);
  const place = await editor.at(320, 300);
  // Without the pause this would be a double click.
  await pass(page, 700);
  await page.mouse.move(...place);
  await page.mouse.down();
  await page.mouse.move(place[0], place[1] - 40, { steps: 8 });
  await rests(editor);
  checkEqual(await addresses(), before, "thumbs while a curve is dragged");
  await page.mouse.up();
  await page.waitForFunction((now) => [...document.querySelectorAll(".tree-row img.thumb")].some((img, k) => img.src !== now[k]), before);
  await rests(editor);
  const after = await addresses();
  const names = await page.locator(".tree-row:has(img.thumb) .name").allTextContents();
  checkEqual(names.filter((_, k) => after[k] !== before[k]), ["back"], "thumbs that are new");
  // A hidden layer keeps its thumbnail.
  await changing(editor, "an eye", () => row(page, "back").getByRole("button", { name: /^Hide/ }).click());
  await rests(editor);
  check(await thumb(page, "back").isVisible(), "the thumb of what is hidden is gone");
  await checkThumbsNearBy(editor, addresses);
  editor.checkQuiet();
  await editor.close();
}

/** Resolves when the exact picture and the thumbnails made from it are ready. */
async function rests(editor) {
  await editor.page.waitForFunction(() => window.sfumatoEditor.status.kind === "exact");
  await editor.settled();
  await idleMoments(editor.page);
}

/** Zoomed in, where only a part of the picture is made, thumbnails still show their whole layers. */
async function checkThumbsNearBy(editor, addresses) {
  const { page } = editor;
  const before = await addresses();
  const solves = await callsOf(page, "solve");
  for (let i = 0; i < 9; ++i) await editor.key("+");
  await askedAgain(page, "solve", solves);
  await rests(editor);
  const [ball, beside] = [await pixelOf(thumb(page, "set"), 0.5, 0.5), await pixelOf(thumb(page, "set"), 0.05, 0.05)];
  check(isNear(ball, [0, 255, 0, 255]) && beside[3] === 0, `near by the ball's thumb shows ${ball}`);
  checkEqual(await addresses(), before, "thumbs near by");
}

/** Rows state their name, kind and state, once; their buttons state their own. */
async function testNames({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(drawing.replace('id="copies"', 'id="copies" style="mix-blend-mode:multiply"'));
  const names = () => page.getByRole("treeitem").evaluateAll((rows) => rows.map((one) => one.getAttribute("aria-label")));
  checkEqual(await names(), ["set, 1 curve, group", "copies, Multiply, 1 curve, layer", "back, 2 curves, layer"], "names of rows");
  const hide = page.getByRole("button", { name: "Hide back", exact: true });
  await changing(editor, "an eye", () => hide.click());
  await changing(editor, "a lock", async () => {
    await row(page, "back").hover();
    await page.getByRole("button", { name: "Lock back", exact: true }).click();
  });
  await page.getByRole("treeitem", { name: "back, 2 curves, layer, hidden, locked", exact: true }).waitFor();
  checkEqual(await hide.getAttribute("aria-pressed"), "true", "the eye is pressed");
  editor.checkQuiet();
  await editor.close();
}

const order = (text) => [...text.matchAll(/<g id="(\w+)"/g)].map(([, id]) => id).join(" ");

/** Drags a row to a share of another one's height. `leave` runs before the button is released. */
async function dragRow(page, from, to, share, leave = () => {}) {
  const [a, b] = [await row(page, from).boundingBox(), await row(page, to).boundingBox()];
  await page.mouse.move(a.x + 60, a.y + a.height / 2);
  await page.mouse.down();
  await page.mouse.move(b.x + 60, b.y + share * b.height, { steps: 8 });
  await page.locator(".drag-ghost").waitFor();
  // The panel above has another height for the present selection.
  checkEqual((await row(page, to).boundingBox()).y, b.y, "where the row is that is dragged to");
  await leave();
  await page.mouse.up();
}

async function undo(editor, before) {
  await editor.page.locator(".canvas-stage").focus();
  await editor.key("Control+z");
  await editor.page.waitForFunction((text) => window.sfumatoEditor.text === text, before);
}

async function testDragged({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  await editor.load(drawing);
  const below = await changing(editor, "a drag below another", () => dragRow(page, "copies", "back", 0.9));
  checkEqual(order(below), "copies back set ball", "layers after a drag below");
  await undo(editor, drawing);
  const above = await changing(editor, "a drag to the top", () => dragRow(page, "back", "set", 0.1));
  checkEqual(order(above), "copies set ball back", "layers after a drag to the top");
  await undo(editor, drawing);
  const within = await changing(editor, "a drag into a group", () =>
    dragRow(page, "copies", "set", 0.5, () => page.locator(".tree-row.target").waitFor()),
  );
  check(/<g id="set">.*<g id="copies".*<\/g>\s*<\/g>/s.test(within), `not in the group: ${within}`);
  await undo(editor, drawing);
  // A curve stays in layers: it may not be dropped on a group or beside layers.
  await row(page, "back").click();
  await editor.key("ArrowRight");
  await row(page, "low").waitFor();
  await dragRow(page, "low", "set", 0.5);
  checkEqual(await editor.text, drawing, "the text after a drop where nothing may go");
  const curve = await changing(editor, "a curve over another", () => dragRow(page, "low", "high", 0.1));
  check(curve.indexOf('id="high"') < curve.indexOf('id="low"'), "the curve is not on top of the other");
  await undo(editor, drawing);
  const moved = await changing(editor, "a curve into another layer", () => dragRow(page, "low", "copies", 0.5));
  check(/<g id="copies"[^>]*>\s*<use[^>]*>\s*<path id="low"/.test(moved), `not in the layer: ${moved}`);
  await undo(editor, drawing);
  await dragRow(page, "copies", "back", 0.9, () => page.keyboard.press("Escape"));
  checkEqual(await editor.text, drawing, "the text after Escape");
  await page.locator(".drag-ghost").waitFor({ state: "detached" });
  editor.checkQuiet();
  await editor.close();
}

/** A curve that is selected in the picture is scrolled into view in the tree, even if its layer was folded. */
async function testRevealed({ browser, address }) {
  const editor = await EditorPage.open(browser, address);
  const { page } = editor;
  const layers = Array.from({ length: 40 }, (_, k) => `<g id="l${k}" sf:diffuse="true"><path id="c${k}" d="M0 ${9 * k}h600" sf:left="red"/></g>`);
  await editor.load(`<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480">${layers.join("\n")}</svg>`);
  await page.locator(".canvas-stage").focus();
  for (const name of ["c0", "c1"]) {
    await editor.key("Tab");
    await row(page, name).waitFor();
    const [line, tree] = [await row(page, name).boundingBox(), await page.locator(".tree").boundingBox()];
    const isInSight = line.y >= tree.y && line.y + line.height <= tree.y + tree.height + 1;
    check(isInSight, `${name} at ${line.y}, the tree from ${tree.y} to ${tree.y + tree.height}`);
  }
  // Unfolding by hand does not scroll.
  const top = await page.locator(".tree").evaluate((tree) => tree.scrollTop);
  await row(page, "l3").locator(".twist").click();
  await row(page, "c3").waitFor();
  checkEqual(await page.locator(".tree").evaluate((tree) => tree.scrollTop), top, "where the tree is scrolled to");
  editor.checkQuiet();
  await editor.close();
}

export async function testLayers(tap, given) {
  await tap.test("layers: thumbs are the picture, of what has changed, at rest", () => testThumbs(given));
  await tap.test("layers: rows have names of their own, with their state", () => testNames(given));
  await tap.test("layers: what is chosen on the picture is in sight", () => testRevealed(given));
  await tap.test("layers: rows are dragged by the mouse", () => testDragged(given));
}
