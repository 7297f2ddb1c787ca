// The tools' further gestures.
import { readFileSync } from "node:fs";
import { check, checkEqual, EditorPage, packageOf, pathOf, until } from "./harness.mjs";
import { changing } from "./draw.mjs";
import { atOnce } from "./hooks.mjs";
import { one, photo, Tools, withTools } from "./tools.mjs";

const { decode } = packageOf("fast-png");

/** Returns the name of the element with the focus. */
const focused = (page) => page.evaluate(() => document.activeElement?.getAttribute("aria-label"));

async function goToGrip(page, name) {
  for (let k = 0; k < 12 && (await focused(page)) !== name; k += 1) {
    await page.keyboard.press(k === 0 ? "Shift+Enter" : "Tab");
    // The focus moves when the next frame is drawn.
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }
  checkEqual(await focused(page), name, "the focus");
}

async function testGrips(t) {
  const { editor, page } = t;
  await t.fresh("v", [200, 300]);
  await goToGrip(page, "Scale, bottom right");
  const zoom = (await editor.at(1, 0))[0] - (await editor.at(0, 0))[0];
  // Arrow keys in quick succession are one step.
  const text = await atOnce(page, async () => {
    for (let k = 0; k < 5; k += 1) await page.keyboard.press("Shift+ArrowLeft");
    return changing(editor, "an arrow", () => page.keyboard.press("ArrowLeft"));
  });
  t.near(t.path(text).slice(-2), [500 - 51 / zoom, 300], "the end that was scaled", 0.01);
  t.near(t.path(text).slice(0, 2), [100, 300], "the end that stays", 0.01);
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), one, "after one undo");
  await goToGrip(page, "Rotate");
  await editor.shot("grip");
  const turned = await changing(editor, "a turn", () => page.keyboard.press("Shift+ArrowRight"));
  const [x0, y0, , , x1, y1] = t.path(turned);
  check(Math.abs(Math.atan2(y1 - y0, x1 - x0) - Math.PI / 12) < 1e-3, `turned: ${t.path(turned)}`);
  await page.keyboard.press("Escape");
  t.near(t.path(await changing(editor, "an arrow", () => page.keyboard.press("ArrowDown"))).slice(0, 2), [x0, y0 + 1 / zoom], "moved", 0.01);
}

/** Opens the drawing with another first curve, and selects it with the node tool. */
async function withCurve(t, curve, at) {
  await t.editor.load(one.replace(/<path id="c"[^>]*>/, curve));
  await t.page.locator(".canvas-stage").focus();
  await t.page.keyboard.press("v");
  await t.editor.click(...at);
  await t.apart();
  await t.page.keyboard.press("a");
  return t.editor.text;
}

async function testSubpaths(t) {
  const { editor, page } = t;
  const two = '<path id="c" d="M100 200L300 200L500 200M100 300L300 300L500 300" sf:left="#e33" sf:right="#36c"/>';
  const before = await withCurve(t, two, [200, 300]);
  await editor.drag([[260, 170], [340, 340]]);
  await page.getByText("2 of 6 nodes").waitFor();
  await editor.shot("subpaths");
  const moved = await t.drag("a node of each subpath", [[300, 300], [310, 330]], ["Control"]);
  t.near(t.path(moved), [100, 200, 310, 230, 500, 200, 100, 300, 310, 330, 500, 300], "both moved");
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), before, "after undo");
  await editor.drag([[260, 170], [340, 340]]);
  const gone = await changing(editor, "Delete", () => page.keyboard.press("Delete"));
  t.near(t.path(gone), [100, 200, 500, 200, 100, 300, 500, 300], "without both");
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), before, "after undo");
  const closed = await changing(editor, "closing", () => page.keyboard.press("Control+Shift+j"));
  checkEqual(/id="c" d="([^"]*)"/.exec(closed)[1].match(/z/gi).length, 2, "closed subpaths");
}

async function testShapes(t) {
  const { editor, page } = t;
  const circle = '<circle id="c" cx="300" cy="300" r="80" sf:left="#e33" sf:right="#36c 10%, #fff 60%"/>';
  const before = await withCurve(t, circle, [300, 380]);
  checkEqual(await page.getByRole("button", { name: /^Node \d of curve/ }).count(), 4, "nodes of a circle");
  await editor.shot("circle");
  const moved = await t.drag("a node of the circle", [[300, 380], [300, 410]], ["Control"]);
  check(/<path id="c" d="M380 300 ?C[^A]*A80 80 0 0 1 300 220 ?A80 80 0 0 1 380 300 ?Z" sf:left="#e33" sf:right="#36c 10%, #fff 60%"\/>/.test(moved), `moved: ${moved}`);
  checkEqual(await page.getByRole("button", { name: /^Node \d of curve/ }).count(), 4, "nodes of the path");
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), before, "after one undo");
  await t.nothing("a click on a node", () => editor.click(300, 380));
}

async function testEnds(t) {
  const { editor, page } = t;
  const open = '<path id="c" d="M100 300L300 400L500 300" sf:left="#e33 @0, #fe8 @2" sf:right="#36c"/>';
  const far = one.replace('d="M100 100L500 100"', 'd="M100 100L500.123456 100.654321"');
  await editor.load(far.replace(/<path id="c"[^>]*>/, open));
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("v");
  await editor.click(200, 350);
  await page.keyboard.press("a");
  const before = await editor.text;
  const closed = await t.drag("an end to the other end", [[500, 300], [103, 302]]);
  check(/id="c" d="M100 300L300 400 ?L100 300 ?Z" sf:left="#e33 @0, #fe8 @2"/.test(closed), `not closed: ${closed}`);
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), before, "after one undo");
  const welded = await t.drag("an end to another curve's end", [[500, 300], [502, 103]]);
  checkEqual(t.path(welded).slice(-2), [500.123456, 100.654321], "the end that was welded");
  await page.keyboard.press("v");
  await editor.click(20, 450);
  await page.keyboard.press("p");
  await editor.click(499, 102);
  await editor.click(560, 180);
  const drawn = await changing(editor, "Enter", () => page.keyboard.press("Enter"));
  check(drawn.includes('d="M500.123456 100.654321 L'), `the pen does not weld: ${drawn}`);
}

/** Makes a photo that turns from red to blue over 6 of its 48 rows on each side of the middle, 10 units each. */
async function softPhoto(page) {
  return page.evaluate(() => {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [64, 48];
    const context = canvas.getContext("2d");
    for (let y = 0; y < 48; y += 1) {
      const t = Math.min(Math.max((y + 0.5 - 24) / 12 + 0.5, 0), 1);
      const share = t * t * (3 - 2 * t);
      context.fillStyle = `rgb(${255 * (1 - share)},0,${255 * share})`;
      context.fillRect(0, y, 64, 1);
    }
    return canvas.toDataURL("image/png");
  });
}

async function testSampledBlur(t) {
  const { editor, page } = t;
  const curve = '<path id="c" d="M100 240L500 240" sf:left="#e33" sf:right="#36c"/>';
  const image = `<image sf:reference="true" href="${await softPhoto(page)}" width="640" height="480"/>`;
  await editor.load(one.replace(/<path id="c"[^>]*>/, curve).replace(/<path id="d"[^>]*>/, "").replace("</svg>", `${image}\n</svg>`));
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("i");
  const before = await editor.text;
  const made = await t.drag("a drag along the curve", [[110, 240], [490, 240]]);
  const radii = /id="c"[^>]*sf:blur="([^"]*)"/.exec(made)?.[1].match(/[\d.]+(?!\d*%)/g)?.map(Number) ?? [];
  check(radii.some((radius) => Math.abs(radius - 60) < 14), `blur: ${made}`);
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), before, "after one undo");
  await page.getByRole("checkbox", { name: "Sample blur" }).uncheck();
  await page.locator(".canvas-stage").focus();
  const without = await t.drag("a drag without blur", [[110, 240], [490, 240]]);
  check(!/id="c"[^>]*sf:(left-|right-)?blur/.test(without), `blur without the option: ${without}`);
}

async function testLoupe(t) {
  const { editor, page } = t;
  const image = `<image sf:reference="true" href="${await photo(page)}" width="640" height="480"/>`;
  await editor.load(one.replace("</svg>", `${image}\n</svg>`));
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("i");
  const loupe = page.locator(".loupe-text");
  const says = async (text, what) => {
    await loupe.filter({ hasText: text }).waitFor().catch(async () => check(false, `${what}: ${await loupe.allTextContents()}`));
  };
  await page.mouse.move(...(await editor.at(300, 200)));
  await says("#ff0000", "over the photo");
  await page.mouse.move(...(await editor.at(300, 300)));
  await says("Left #ff0000 · Right #0000ff", "over the curve");
  await editor.shot("loupe");
  await page.keyboard.press("Shift+R");
  await page.mouse.move(...(await editor.at(301, 350)));
  await loupe.filter({ hasText: /^#[0-9a-f]{6}$/ }).waitFor();
  check(!["#ff0000", "#0000ff"].includes(await loupe.textContent()), "over the picture the loupe shows the photo");
  // Curves are also traced along a hidden photo.
  await page.mouse.move(...(await editor.at(300, 300)));
  await says("Left #ff0000 · Right #0000ff", "over the curve, the photo put away");
  await page.keyboard.press("v");
  await loupe.waitFor({ state: "detached" });
}

/** The stop gets the colour that the loupe shows on release, whatever is on its layer. */
async function testPickAsSeen(t) {
  const { editor, page } = t;
  const veil = '<g sf:diffuse="true" opacity="0.5"><path d="M-90 -90H900V900H-90Z" sf:left="#fff" sf:right="#fff"/></g>';
  await editor.load(one.replace("</svg>", `${veil}\n</svg>`));
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("v");
  await editor.click(200, 300);
  await page.keyboard.press("i");
  const { x, y, width, height } = await page.locator(".mark[aria-label^=\"Left stop 1 of 1\"]").boundingBox();
  const [toX, toY] = await editor.at(300, 420);
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(toX - 30, toY - 30, { steps: 4 });
  await page.mouse.move(toX, toY);
  const seen = await page.locator(".loupe-text").filter({ hasText: /^#[0-9a-f]{6}$/ }).textContent();
  const before = await editor.text;
  await page.mouse.up();
  await editor.settled();
  const now = await editor.text;
  check(seen !== "#3366cc" && now.includes(`sf:left="${seen}"`), `seen ${seen}: ${now}`);
  check(before !== one, "nothing was shown while the pointer moved");
  await page.keyboard.press("Control+z");
  check((await editor.text).includes('id="c" d="M100 300L300 300L500 300" sf:left="#e33"'), "more than one step of undo");
}

/** Returns the colour of the page's pixel at a point of the artboard, bytes. */
async function pixelAt(editor, x, y) {
  const side = 1 / (await editor.page.evaluate(() => devicePixelRatio));
  const [left, top] = (await editor.at(x, y)).map((place) => side * Math.round(place / side));
  const png = await editor.page.screenshot({ clip: { x: left, y: top, width: side, height: side } });
  return [...decode(png).data.slice(0, 3)];
}

async function testPhoto(t) {
  const { editor, page } = t;
  const image = `<image id="shot" sf:reference="true" href="${await photo(page)}" width="640" height="480"/>`;
  // A picture that is transparent below its curve.
  const clear = one
    .replace(/<path id="d"[^>]*>/, "")
    .replace('sf:right="#36c"', 'sf:right="#36c" sf:left-opacity="1" sf:right-opacity="0"');
  await editor.load(clear.replace("</svg>", `  ${image}\n</svg>`));
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("v");
  const start = await editor.text;
  check((await pixelAt(editor, 500, 60))[1] < 20, "the photo is not above the picture");
  await page.getByRole("treeitem", { name: "shot" }).click();
  const below = await changing(editor, "Below", () => page.getByRole("radio", { name: "Below" }).click());
  check(below.indexOf("<image") < below.indexOf('id="layer"'), `not below: ${below}`);
  await editor.settled();
  await until("the picture hides the photo", async () => (await pixelAt(editor, 300, 200))[1] > 30);
  await until("the photo shows through", async () => {
    const [red, , blue] = await pixelAt(editor, 560, 460);
    return blue > 150 && blue > red + 60;
  });
  await editor.shot("photo-below");
  checkEqual(await changing(editor, "undo", () => page.keyboard.press("Control+z")), start, "after undo");
  const moved = await t.drag("the photo", [[560, 400], [580, 420]], ["Control"]);
  check(/<image[^>]*transform="(translate\(20|matrix\(1 0 0 1 20)/.test(moved), `moved: ${moved.slice(-300)}`);
  await changing(editor, "undo", () => page.keyboard.press("Control+z"));
  const width = page.getByRole("textbox", { name: "Width" });
  await width.fill("320");
  const scaled = await changing(editor, "the field", () => width.press("Enter"));
  check(/<image[^>]*transform="(scale\(\.5 1|scale\(0?\.5,? ?1|matrix\(0?\.5 0 0 1)/.test(scaled), `scaled: ${scaled.slice(-300)}`);
  await page.getByRole("checkbox", { name: /Locked/ }).check();
  await page.locator(".canvas-stage").focus();
  await t.nothing("a drag of the locked photo", () => editor.drag([[100, 400], [130, 420]]));
}

async function testTouchLoupe({ browser, address }) {
  const editor = await EditorPage.open(browser, address, { hasTouch: true });
  const t = new Tools(editor);
  await t.fresh("i");
  const session = await editor.context.newCDPSession(editor.page);
  const [x, y] = await editor.at(300, 300);
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  const image = `<image sf:reference="true" href="${await photo(editor.page)}" width="640" height="480"/>`;
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  checkEqual(await editor.page.locator(".loupe").count(), 0, "loupes without a photo, the finger lifted");
  await editor.load(one.replace("</svg>", `${image}\n</svg>`));
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x: x + 40, y }] });
  const box = await editor.page.locator(".loupe").boundingBox();
  check(box.y + box.height < y - 20, `the finger hides the loupe: ${JSON.stringify(box)}, finger at ${y}`);
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await editor.page.locator(".loupe").waitFor({ state: "detached" });
  editor.checkQuiet();
  await editor.close();
}

/** Collects the CSS transforms of the picture from now on. */
const watchTransforms = (page) =>
  page.evaluate(() => {
    const picture = document.querySelector(".canvas-stage > canvas");
    window.seenTransforms = new Set();
    const look = () => {
      window.seenTransforms.add(picture.style.transform);
      requestAnimationFrame(look);
    };
    look();
  });

/** Shows and hides the mesh, which draws the whole picture again. */
async function redraw(page) {
  for (let k = 0; k < 2; k += 1) await page.keyboard.press("m");
}

async function testMovedFrame({ editor, page }) {
  await editor.load(readFileSync(pathOf("examples/portrait.svg"), "utf8"));
  await page.locator(".canvas-stage").focus();
  await watchTransforms(page);
  await page.mouse.move(...(await editor.at(300, 300)));
  for (let k = 0; k < 3; k += 1) await page.mouse.wheel(0, -40);
  const moved = await editor.picture();
  const seen = await page.evaluate(() => [...window.seenTransforms]);
  check(seen.some((transform) => transform.startsWith("matrix(")), `no frame was moved: ${JSON.stringify(seen)}`);
  checkEqual(await page.evaluate(() => document.querySelector(".canvas-stage > canvas").style.transform), "", "the picture at rest");
  await redraw(page);
  const drawn = await editor.picture();
  check(moved.equals(drawn), "the picture at rest differs from a redrawn one");
}

export async function testGestures(tap, given) {
  const gestures = {
    "the box scales and turns by the keyboard": testGrips,
    "nodes of several subpaths are edited at once": testSubpaths,
    "a circle has four nodes and becomes a path when one is moved": testShapes,
    "ends weld, and close their own curve": testEnds,
    "sampling takes the photo's blur, too": testSampledBlur,
    "the photo lies above or below, and is moved when it is not locked": testPhoto,
    "the loupe shows what is sampled": testLoupe,
    "a stop takes the colour that is seen": testPickAsSeen,
    "slow frames are moved until the view rests": testMovedFrame,
  };
  const looks = [testPhoto, testLoupe, testPickAsSeen, testMovedFrame];
  for (const [name, body] of Object.entries(gestures)) {
    // Numbers are as exact as the pixels of the screen.
    const options = body === testGrips ? { ratio: 1 } : { isDrawn: looks.includes(body) };
    if (body === testMovedFrame) options.size = [800, 600];
    await tap.test(name, () => withTools(given, body, options));
  }
  await tap.test("the loupe stands above the finger", () => testTouchLoupe(given));
}
