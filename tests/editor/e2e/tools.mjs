// Every tool with its gestures, on the stage.
import { check, checkEqual, EditorPage, until } from "./harness.mjs";
import { changing, count } from "./draw.mjs";
import { atOnce, pass } from "./hooks.mjs";
import { largestDifference } from "./pixels.mjs";

const open = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">';
export const one = `${open}
  <g id="layer" sf:diffuse="true">
    <path id="c" d="M100 300L300 300L500 300" sf:left="#e33" sf:right="#36c"/>
    <path id="d" d="M100 100L500 100" sf:left="#fe8" sf:right="#284"/>
  </g>
</svg>
`;

/** Uses the tools on a drawing of two curves. */
export class Tools {
  constructor(editor) {
    this.editor = editor;
    this.page = editor.page;
  }

  async fresh(tool, ...selected) {
    await this.editor.load(one);
    await this.page.locator(".canvas-stage").focus();
    await this.page.keyboard.press("v");
    for (const at of selected) await this.editor.click(...at);
    await this.apart();
    await this.page.keyboard.press(tool);
  }

  /** Makes the next click at the same place a single click. */
  apart() {
    return pass(this.page, 450);
  }

  /** Drags, and does something before the pointer is released. */
  async held(points, during) {
    const places = await this.editor.all(points);
    await this.page.mouse.move(...places[0]);
    await this.page.mouse.down();
    for (const place of places.slice(1)) await this.page.mouse.move(...place, { steps: 6 });
    await during();
    await this.page.mouse.up();
  }

  drag(what, points, keys = []) {
    return changing(this.editor, what, () => this.editor.drag(points, { keys }));
  }

  path(text, id = "c") {
    return new RegExp(`id="${id}"[^>]*? d="([^"]*)"`).exec(text)[1].match(/-?[\d.]+/g).map(Number);
  }

  async nothing(what, act) {
    const before = await this.editor.text;
    await act();
    await this.editor.settled();
    checkEqual(await this.editor.text, before, `the text after ${what}`);
  }

  near(numbers, expected, what, tolerance = 0.6) {
    const isNear = numbers.length === expected.length && numbers.every((value, k) => Math.abs(value - expected[k]) <= tolerance);
    check(isNear, `${what}: ${numbers}, expected ${expected}`);
  }
}

async function testSelect(t) {
  const { editor, page } = t;
  const onC = [200, 300];
  await t.fresh("v");
  let text = await t.drag("a move", [onC, [230, 340]], ["Control"]);
  t.near(t.path(text), [130, 340, 330, 340, 530, 340], "moved");
  await t.fresh("v");
  text = await t.drag("a copy", [onC, [230, 340]], ["Alt"]);
  checkEqual(count(text, /<path /g), 3, "curves after Alt");
  await t.fresh("v");
  text = await t.drag("a straight move", [onC, [260, 310]], ["Shift"]);
  t.near(t.path(text), [160, 300, 360, 300, 560, 300], "moved with Shift");
  await t.fresh("v", onC, [560, 400]);
  await editor.drag([[60, 60], [560, 340]]);
  checkEqual(await page.evaluate(() => window.sfumatoEditor.selection.length), 2, "in the rectangle");
  const grip = await page.getByRole("button", { name: "Scale, bottom right" }).boundingBox();
  const corner = [grip.x + grip.width / 2, grip.y + grip.height / 2];
  text = await changing(editor, "a scale", async () => {
    await page.mouse.move(...corner);
    await page.mouse.down();
    await page.mouse.move(corner[0] - 60, corner[1] - 40, { steps: 6 });
    await page.mouse.up();
  });
  check(t.path(text)[4] < 480 && t.path(text)[1] < 290, `scaled: ${t.path(text)}`);
  const turn = await page.getByRole("button", { name: "Rotate" }).boundingBox();
  text = await changing(editor, "a turn", async () => {
    await page.mouse.move(turn.x + turn.width / 2, turn.y + turn.height / 2);
    await page.mouse.down();
    await page.mouse.move(turn.x + 90, turn.y + 40, { steps: 6 });
    await page.mouse.up();
  });
  const [, y0, , , , y2] = t.path(text);
  check(Math.abs(y0 - y2) > 10, `turned: ${t.path(text)}`);
  await t.fresh("v");
  await t.nothing("Esc in the middle", () => t.held([onC, [250, 360]], () => page.keyboard.press("Escape")));
  await t.nothing("a click", () => editor.click(...onC));
}

async function testFollowing(t) {
  const { editor } = t;
  await t.fresh("v");
  const before = await editor.picture();
  let during;
  await t.held([[200, 300], [220, 360]], async () => {
    await until("the picture follows the pointer", async () => {
      during = await editor.picture();
      return largestDifference(before, during) > 20;
    });
  });
  checkEqual(largestDifference(during, await editor.picture()), 0, "what was shown while dragging and what is kept");
}

async function testNodes(t) {
  const { editor, page } = t;
  const middle = [300, 300];
  const begin = async () => {
    await t.fresh("a", [420, 300]);
    await editor.click(...middle);
    await t.apart();
    checkEqual((await page.evaluate(() => window.sfumatoEditor.selection))[0]?.part, { kind: "node", path: 0, index: 1 }, "the node");
  };
  await begin();
  t.near(t.path(await t.drag("a node", [middle, [310, 350]], ["Control"])), [100, 300, 310, 350, 500, 300], "a node moved");
  await begin();
  t.near(t.path(await t.drag("a node with Shift", [middle, [320, 350]], ["Shift"])), [100, 300, 300, 350, 500, 300], "a node moved with Shift");
  await begin();
  check((await t.drag("Alt on a node", [middle, [340, 340]], ["Alt"])).includes("C"), "Alt pulls no handle");
  for (const [key, pattern] of [["s", /C/], ["y", /C/]]) {
    await begin();
    await t.drag(`a node, for ${key}`, [middle, [310, 350]], ["Control"]);
    const smooth = await changing(editor, key, () => page.keyboard.press(key));
    check(pattern.test(/id="c" d="([^"]*)"/.exec(smooth)[1]), `${key} makes no handles`);
    if (key === "s") await changing(editor, "c", () => page.keyboard.press("c"));
  }
  await begin();
  t.near(t.path(await changing(editor, "Del", () => page.keyboard.press("Delete"))), [100, 300, 500, 300], "without its middle");
  await t.fresh("a", [420, 300]);
  const place = await editor.at(200, 300);
  const more = await changing(editor, "a double click", () =>
    atOnce(page, () => page.mouse.dblclick(...place)),
  );
  checkEqual(t.path(more).length, 8, "numbers after a double click");
  await t.fresh("a", [420, 300]);
  check((await t.drag("the curve", [[200, 300], [200, 340]])).includes("C"), "the curve is not bent");
  await t.fresh("a", [420, 300]);
  const added = await changing(editor, "a click beside the curve", () => editor.click(400, 289));
  check(/sf:left="#e33, #e33 7\d/.test(added), `no stop: ${added}`);
  await changing(editor, "a dragged stop", async () => {
    const mark = await page.getByRole("button", { name: /^Left stop 2 of 2/ }).last().boundingBox();
    const at = [mark.x + mark.width / 2, mark.y + mark.height / 2];
    await page.mouse.move(...at);
    await page.mouse.down();
    await page.mouse.move(at[0] - 80, at[1], { steps: 6 });
    await page.mouse.up();
  });
  const gone = await changing(editor, "Del on a stop", async () => {
    await page.locator(".canvas-stage").focus();
    await page.keyboard.press("Delete");
  });
  check(/sf:left="#e33"/.test(gone), `the stop is there: ${gone}`);
  await begin();
  await t.nothing("Esc in the middle", () => t.held([middle, [350, 400]], () => page.keyboard.press("Escape")));
}

async function testPen(t) {
  const { editor, page } = t;
  const drawn = (text) => /<path d="([^"]*)"/.exec(text.replace(/id="[cd]" d=/g, ""))[1];
  await t.fresh("p");
  await editor.click(200, 200);
  await page.keyboard.down("Shift");
  await editor.click(300, 215);
  await page.keyboard.up("Shift");
  await editor.click(280, 250);
  let text = await changing(editor, "a click on the first node", () => editor.click(200, 200));
  check(/Z$/i.test(drawn(text)), `not closed: ${drawn(text)}`);
  const [, , x, y] = drawn(text).match(/-?[\d.]+/g).map(Number);
  const angle = (Math.atan2(y - 200, x - 200) * 180) / Math.PI;
  check(Math.abs(angle / 15 - Math.round(angle / 15)) < 0.02, `Shift gives ${angle}°`);
  await t.fresh("p");
  await editor.click(200, 200);
  await t.held([[300, 220], [330, 240]], async () => {
    await page.keyboard.down("Space");
    await page.mouse.move(...(await editor.at(330, 270)), { steps: 4 });
    await page.keyboard.up("Space");
  });
  text = await changing(editor, "Enter", () => page.keyboard.press("Enter"));
  const numbers = drawn(text).match(/-?[\d.]+/g).map(Number);
  t.near(numbers.slice(-2), [300, 250], "the node that Space moved");
  await t.fresh("p");
  await editor.click(200, 200);
  await editor.click(300, 220);
  await page.keyboard.press("Backspace");
  await editor.click(320, 250);
  text = await changing(editor, "Esc", () => page.keyboard.press("Escape"));
  t.near(drawn(text).match(/-?[\d.]+/g).map(Number), [200, 200, 320, 250], "after Backspace");
  await t.fresh("p", [200, 300]);
  const more = await changing(editor, "Alt on the curve", async () => {
    await page.keyboard.down("Alt");
    await editor.click(200, 300);
    await page.keyboard.up("Alt");
  });
  checkEqual(t.path(more).length, 8, "numbers after Alt on the curve");
}

async function testFree(t) {
  const { editor, page } = t;
  await t.fresh("b");
  await t.nothing("Esc in the pencil's way", () => t.held([[150, 200], [300, 180]], () => page.keyboard.press("Escape")));
  await t.nothing("a dot of the pencil", () => editor.click(300, 200));
  const round = Array.from({ length: 25 }, (_, k) => [300 + 60 * Math.cos(k / 3.82), 200 + 50 * Math.sin(k / 3.82)]);
  const text = await t.drag("a loop", round);
  check(/<path d="[^"]*Z"/i.test(text), "a loop is not closed");
  await t.fresh("k");
  const stroke = await t.drag("a stroke", [[150, 200], [300, 180], [400, 220]]);
  check(/<path d=[^>]*sf:radius="[\d.]+"/.test(stroke), "a stroke has no radius");
  await t.fresh("k");
  await t.nothing("Esc in a stroke", () => t.held([[150, 200], [300, 180]], () => page.keyboard.press("Escape")));
}

async function testBlur(t) {
  await t.fresh("u", [400, 300]);
  const left = await t.drag("blur", [[200, 300], [200, 270]]);
  check(/id="c"[^>]*sf:left-blur="(29|30|31)/.test(left) && !/sf:right-blur/.test(left), `blur: ${left}`);
  await t.fresh("u", [400, 300]);
  const both = await t.drag("blur on both sides", [[200, 300], [200, 270]], ["Shift"]);
  check(/id="c"[^>]*sf:blur="/.test(both), `both: ${both}`);
}

/** Returns a photo: red above y 240, blue below. */
export async function photo(page) {
  return page.evaluate(() => {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [64, 48];
    const context = canvas.getContext("2d");
    context.fillStyle = "#ff0000";
    context.fillRect(0, 0, 64, 30);
    context.fillStyle = "#0000ff";
    context.fillRect(0, 30, 64, 18);
    return canvas.toDataURL("image/png");
  });
}

async function testSample(t) {
  const { editor, page } = t;
  const image = `<image sf:reference="true" href="${await photo(page)}" width="640" height="480"/>`;
  await editor.load(one.replace("</svg>", `${image}\n</svg>`));
  await page.locator(".canvas-stage").focus();
  await page.keyboard.press("i");
  const text = await t.drag("a drag along the curve", [[110, 300], [490, 300]]);
  const sides = /id="c"[^>]*/.exec(text)[0];
  check(/sf:left="[^"]*#f00/.test(sides) && /sf:right="[^"]*#00f/.test(sides), `sampled: ${sides}`);
  await t.fresh("i");
  await editor.click(200, 300);
  await page.locator(".toast").filter({ hasText: "There is no photo to sample" }).waitFor();
}

async function testHand(t) {
  const { editor, page } = t;
  await t.fresh("h");
  const before = await editor.at(100, 100);
  await t.nothing("the hand", () => editor.drag([[300, 200], [340, 230]]));
  const after = await editor.at(100, 100);
  check(after[0] - before[0] > 30 && after[1] - before[1] > 20, "the hand does not move the picture");
  await page.keyboard.press("v");
  await page.keyboard.down("Space");
  await t.nothing("Space", () => editor.drag([[200, 300], [160, 270]]));
  await page.keyboard.up("Space");
  const back = await editor.at(100, 100);
  check(Math.abs(back[0] - before[0]) < 2 && Math.abs(back[1] - before[1]) < 2, "Space does not move the picture");
  const [x, y] = await editor.at(320, 240);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction(([px]) => window.sfumatoEditor.place(320, 240)[0] - window.sfumatoEditor.place(0, 0)[0] > px, [x - back[0] + 200]).catch(() => check(false, "the wheel does not zoom"));
  const [wx, wy] = await editor.at(320, 240);
  check(Math.hypot(wx - x, wy - y) < 1, "the wheel does not keep the point under the pointer");
}

export async function withTools({ browser, address }, body, options) {
  const editor = await EditorPage.open(browser, address, options);
  await body(new Tools(editor));
  editor.checkQuiet();
  await editor.close();
}

export async function testTools(tap, given) {
  const tools = { select: testSelect, nodes: testNodes, pen: testPen, "pencil and stroke": testFree, blur: testBlur, sample: testSample, hand: testHand };
  for (const [name, body] of Object.entries(tools)) {
    // The picture moves smoothly.
    const options = name === "hand" ? { reducedMotion: "no-preference" } : {};
    await tap.test(`the tool ${name} and its gestures`, () => withTools(given, body, options));
  }
  await tap.test("the picture follows a drag exactly", () => withTools(given, testFollowing, { isDrawn: true }));
}
