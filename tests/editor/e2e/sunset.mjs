// Draws a picture from nothing with a person's means: pointer, pen, keys and panels. Each stage begins with the
// text of the previous stage: sunset/*.svg, and examples/sunset.svg at the end. SFUMATO_WRITE_STAGES=1 writes the
// texts in between.
import { readFileSync, writeFileSync } from "node:fs";
import { Artist } from "./artist.mjs";
import { checkAlike } from "./draw.mjs";
import { EditorPage, checkEqual, pathOf, until } from "./harness.mjs";

const BLUR = "Blur, radius of point 1";

/** Returns nodes of a circle for the pen, clockwise from an angle, degrees. */
function circle(x, y, radius, from) {
  return [0, 90, 180, 270].map((more) => {
    const angle = ((from + more) * Math.PI) / 180;
    const [dx, dy] = [radius * Math.cos(angle), radius * Math.sin(angle)];
    return [x + dx, y + dy, x + dx - 0.5523 * dy, y + dy + 0.5523 * dx];
  });
}

/** Draws all curves that need only two colours; later curves take the colours that they find. */
async function sketch(artist) {
  await artist.curve([[-150, 272], [1110, 272]]);
  await artist.curve(circle(330, 214, 44, 180), { closes: true });
  await artist.curve([[-150, 580, -40, 576], [360, 486, 450, 466], [690, 436, 770, 412],
    [1110, 330]]);
  await artist.curve([[-150, 622, -40, 620], [380, 526, 470, 502], [710, 470, 790, 446],
    [1110, 360]]);
  await artist.curve([[-150, 730], [1110, 630]]);
  await artist.curve([[-150, -30], [1110, -30]]);
  await artist.curve([[-150, 160, 0, 164], [230, 118, 335, 116], [540, 150, 640, 148],
    [800, 100, 880, 88], [1110, 110]]);
  await artist.deselect();
  const foam = [[-20, 556, 0.5], [60, 549, 0.9], [150, 531, 0.6], [260, 509, 1], [360, 487, 0.7],
    [450, 472, 0.4], [560, 461, 0.8], [690, 436, 0.5], [800, 404, 0.8], [980, 360, 0.4]];
  await artist.stroke(foam, { radius: 8, smoothing: 2, color: "ffffff" });
}

/** Sand, wet sand and sea. */
async function shore(artist) {
  await artist.select(900, 646.7);
  await artist.color("Left", 0, "a06a55");
  await artist.select(380, 526);
  await artist.color("Left", 0, "8a6460");
  await artist.color("Right", 0, "ecc08e");
  await artist.field(BLUR, 12);
  await artist.select(360, 486);
  await artist.color("Left", 0, "29697c");
  await artist.color("Right", 0, "a87d78");
  await artist.field(BLUR, 3);
}

/** Gives one colour to both ends, and another one where the sun is. 4 steps. */
async function glowing(artist, side, end, middle) {
  await artist.color(side, 0, end);
  await artist.copyStop(side, 0, 1);
  await artist.addStop(side, 0.38);
  await artist.pick(side, 1, middle);
}

/** Draws the clouds above the horizon. */
async function clouds(artist) {
  await artist.select(540, 150);
  await glowing(artist, "Left", "5b4182", "96608f");
  await glowing(artist, "Right", "cf6680", "ffab78");
  await artist.field(BLUR, 26);
}

/** Draws the horizon, and the light above it and on the water. */
async function horizon(artist) {
  await artist.select(800, 272);
  await glowing(artist, "Right", "75476f", "ffb676");
  await glowing(artist, "Left", "d4636a", "ffe0a0");
  await artist.field(BLUR, 5);
  await artist.deselect();
  await artist.stroke([[330, 214, 1], [330, 330, 1]], { radius: 200 });
  await artist.blend("Screen");
  await artist.deselect();
  await artist.stroke(glitter(), { radius: 7, smoothing: 0.5, isStraight: true });
}

/** Returns the sun on the water: dashes with pointed ends. */
function glitter() {
  const turns = [[282, 279], [384, 285], [270, 293], [372, 301], [290, 309], [378, 318],
    [300, 328], [362, 339], [286, 350], [352, 362], [312, 374], [356, 388], [318, 402],
    [340, 416]];
  return turns.flatMap(([x, y], k) => {
    const [nextX, nextY] = turns[k + 1] ?? [x, y];
    const at = (share, force) => [x + share * (nextX - x), y + share * (nextY - y), force];
    return k + 1 < turns.length ? [at(0, 0.02), at(0.25, 0.6), at(0.5, 0.8), at(0.75, 0.6)] : [at(0, 0.02)];
  });
}

/** Draws the sky's edge, whose colour shadow and gulls take. */
async function shades(artist) {
  await artist.select(480, -30);
  await artist.pick("Right", 0, "382a5c");
  await artist.deselect();
  await artist.stroke([[640, 512, 0.6], [700, 524, 0.9], [780, 542, 1],
    [860, 568, 0.35]], { radius: 36 });
  await artist.deselect();
  await artist.stroke([[520, 192, 0.1], [532, 181, 0.7], [546, 182, 0.8], [555, 191, 1],
    [565, 181, 0.8], [580, 179, 0.7], [594, 189, 0.1]], { radius: 3.6 });
  await artist.deselect();
  await artist.stroke([[612, 158, 0.1], [620, 151, 0.7], [629, 152, 0.8], [634, 158, 1],
    [641, 151, 0.8], [650, 150, 0.7], [659, 157, 0.1]], { radius: 2.6 });
}

/** Draws a layer of one circle: a filled shape, because the layer is empty. */
async function ball(artist) {
  const { page } = artist;
  await artist.deselect();
  await page.getByRole("button", { name: "New layer" }).click();
  await artist.curve(circle(640, 445, 80, 72), { closes: true });
  await artist.color("Inside", 0, "4a1038");
  await artist.copyStop("Inside", 0, 1);
  await artist.addStop("Inside", 0.45, "ffa868");
  await artist.addStop("Inside", 0.22, "d8353a");
  await artist.copyStop("Inside", 1, 0.68);
  await artist.field(BLUR, 1);
}

/** Draws the sun, whose colour the ball's highlight takes; and ball, highlight and shadow again. */
async function light(artist) {
  await artist.select(330, 170);
  await artist.color("Outside", 0, "ffdc8c");
  await artist.pick("Inside", 0, "fffbe6");
  await artist.field(BLUR, 4);
  await artist.deselect();
  await artist.stroke([[592, 420, 0.2], [600, 402, 0.9], [612, 391, 1],
    [632, 383, 0.2]], { radius: 14 });
  await artist.choose("Stroke 4");
  await artist.choose("Layer 2", { modifiers: ["Control"] });
  await artist.choose("Stroke 7", { modifiers: ["Control"] });
  await artist.tool("Select");
  await artist.editor.key("Control+G", "Control+Alt+D");
  await artist.scale("bottom right", 0.38);
  await artist.move([613, 419], [876, 418]);
}

/** steps: undo steps. text: the text at the end. */
const stages = [
  { name: "lines and foam", steps: 8, draw: sketch, text: "tests/editor/e2e/sunset/1-lines.svg" },
  { name: "the shore", steps: 7, draw: shore, text: "tests/editor/e2e/sunset/2-shore.svg" },
  { name: "the clouds", steps: 9, draw: clouds, text: "tests/editor/e2e/sunset/3-clouds.svg" },
  { name: "the horizon", steps: 12, draw: horizon, text: "tests/editor/e2e/sunset/4-horizon.svg" },
  { name: "shadow and gulls", steps: 4, draw: shades, text: "tests/editor/e2e/sunset/5-shades.svg" },
  { name: "a ball", steps: 10, draw: ball, text: "tests/editor/e2e/sunset/6-ball.svg" },
  { name: "the sun, and another ball", steps: 8, draw: light, text: "examples/sunset.svg" },
];
const STEPS = 58;

const textOf = ({ text }) => readFileSync(pathOf(text), "utf8");

/** Opens an empty page, or the result of the previous stage, with room around it for curves that run beyond. */
async function begin(artist, before) {
  if (!before) {
    await artist.blank(960, 600, "232a58");
  } else {
    await artist.editor.load(textOf(before));
    await artist.makeRoom();
  }
  await artist.menu("View", "Snap");
  return artist.editor.text;
}

/** Presses a key so often, while its button is enabled; then the button must be disabled. */
async function every(editor, key, name, times) {
  await editor.page.locator(".canvas-stage").focus();
  const button = editor.page.getByRole("button", { name });
  for (let step = 0; step < times; step += 1) {
    await until(`${key} has more than ${step} steps`, () => button.isEnabled());
    await editor.key(key);
  }
  await until(`${key} has ${times} steps`, () => button.isDisabled());
}

async function testStage({ browser, address }, { steps, draw, text }, before) {
  // This test checks the text, not the picture.
  const editor = await EditorPage.open(browser, address);
  try {
    const artist = new Artist(editor);
    const start = await begin(artist, before);
    await draw(artist);
    const drawn = await editor.text;
    const isWritten = process.env.SFUMATO_WRITE_STAGES && text.startsWith("tests/");
    if (isWritten) writeFileSync(pathOf(text), drawn);
    checkAlike(drawn, textOf({ text }), "what was drawn");
    await every(editor, "Control+z", /^Undo/, steps);
    checkEqual(await editor.text, start, "the text after all steps were undone");
    await every(editor, "Control+Shift+z", /^Redo/, steps);
    checkEqual(await editor.text, drawn, "the text after all steps were redone");
    editor.checkQuiet();
  } finally {
    await editor.close();
  }
}

export async function testSunset(tap, given) {
  for (const [k, stage] of stages.entries()) {
    const name = `a sunset is drawn, and its steps lead back: ${stage.name}`;
    await tap.test(name, () => testStage(given, stage, stages[k - 1]));
  }
  await tap.test(`the sunset takes ${STEPS} steps`, () =>
    checkEqual(stages.reduce((sum, { steps }) => sum + steps, 0), STEPS, "steps of all stages"));
}
