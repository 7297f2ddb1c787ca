// Gradients and textures on the canvas: their grips by the pointer and by keys; gradients as opacity.
import { changing } from "./draw.mjs";
import { Disk, giveDisk } from "./disk.mjs";
import { check, checkEqual, EditorPage, newContext, packageOf } from "./harness.mjs";
import { said } from "./words.mjs";

const { encode } = packageOf("fast-png");

const drawing = `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 640 480" sf:background="#fff">
  <defs>
    <linearGradient id="sky" gradientUnits="userSpaceOnUse" x1="100" y1="100" x2="500" y2="100">
      <stop offset="0" stop-color="#ff0000"/>
      <stop offset="1" stop-color="#0000ff"/>
    </linearGradient>
    <radialGradient id="sun" gradientUnits="userSpaceOnUse" cx="300" cy="300" r="80">
      <stop offset="0" stop-color="#fff"/>
      <stop offset="1" stop-color="#fff" stop-opacity="0"/>
    </radialGradient>
  </defs>
  <g id="back" sf:diffuse="true">
    <path id="low" d="M40 240C200 180 400 180 600 240" sf:left="url(#sky)" sf:right="url(#sun)" stroke="url(#sky)"/>
  </g>
</svg>
`;

async function open(given) {
  const editor = await EditorPage.open(given.browser, given.address);
  await editor.load(drawing);
  await editor.click(320, 195);
  await editor.page.locator(".inspector .ribbon").first().waitFor();
  await editor.page.keyboard.press("a");
  await editor.page.getByRole("button", { name: "End of the gradient, left side" }).waitFor();
  return editor;
}

const drag = (editor, from, to, ...keys) => editor.drag([from, to], { steps: 6, keys });

/** Returns the numbers of an attribute of the element with an id. */
function numberOf(text, id, name) {
  const tag = new RegExp(`<[^>]*id="${id}"[^>]*>`).exec(text)?.[0] ?? "";
  return Number(new RegExp(` ${name}="([^"]*)"`).exec(tag)?.[1]);
}

const near = (value, wanted, what) => check(Math.abs(value - wanted) < 1.5, `${what}: ${value}, not ${wanted}`);

async function testPointer(given) {
  const editor = await open(given);
  const { page } = editor;
  const line = await changing(editor, "a drag of an end", () => drag(editor, [500, 100], [420, 150]));
  near(numberOf(line, "sky", "x2"), 420, "x2");
  near(numberOf(line, "sky", "y2"), 150, "y2");
  checkEqual(numberOf(line, "sky", "x1"), 100, "x1");
  const straight = await changing(editor, "a drag with Shift", () => drag(editor, [420, 150], [400, 110], "Shift"));
  near(numberOf(straight, "sky", "y2"), 100, "y2 with Shift");
  const circle = await changing(editor, "a drag of the radius", () => drag(editor, [380, 300], [420, 300]));
  near(numberOf(circle, "sun", "r"), 120, "r");
  const focus = await changing(editor, "a drag with Alt", () => drag(editor, [300, 300], [340, 320], "Alt"));
  near(numberOf(focus, "sun", "fx"), 340, "fx");
  await page.getByRole("button", { name: "Focus of the gradient, right side" }).waitFor();
  await drag(editor, [300, 300], [200, 100]);
  await page.keyboard.press("Escape");
  for (let k = 0; k < 5; k += 1) await page.keyboard.press("Control+z");
  checkEqual(await editor.text, drawing, "the text after all undone");
  editor.checkQuiet();
  await editor.close();
}

async function testKeys(given) {
  const editor = await open(given);
  const { page } = editor;
  await editor.click(500, 100);
  const moved = await changing(editor, "an arrow", () => page.keyboard.press("Shift+ArrowDown"));
  check(numberOf(moved, "sky", "y2") > 105, `not moved: ${moved}`);
  await page.waitForFunction(() => document.querySelector(".mark.on")?.getAttribute("aria-label") === "End of the gradient, left side");
  // A grip cannot be deleted, and Delete must not delete the curve either.
  await page.keyboard.press("Delete");
  checkEqual(await editor.text, moved, "the text after Delete");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => document.querySelector(".mark.on")?.getAttribute("aria-label") === "Centre of the gradient, right side");
  editor.checkQuiet();
  await editor.close();
}

async function testOpacity(given) {
  const editor = await open(given);
  const { page } = editor;
  const kinds = page.getByRole("button", { name: "Opacity type of each side" });
  const choose = async (side, kind) => {
    await kinds.click();
    await page.getByRole("menuitem", { name: `${side} side` }).click();
    await page.getByRole("menuitem", { name: kind }).or(page.getByRole("menuitemcheckbox", { name: kind })).first().click();
  };
  const made = await changing(editor, "a gradient as opacity", () => choose("Left", "Linear gradient"));
  check(/sf:left-opacity="url\(#gradient\)"/.test(made) && /sf:right-opacity="1"/.test(made), `no gradient as opacity: ${made}`);
  await page.keyboard.press("2");
  await page.getByRole("button", { name: "End of the gradient, left side" }).waitFor();
  const alpha = page.locator(".inspector").getByRole("textbox", { name: "Alpha of the opacity's left stop 1" });
  const faint = await changing(editor, "an alpha", async () => {
    await alpha.fill("40");
    await alpha.press("Enter");
  });
  check(faint.includes('stop-opacity="0.4"'), `no alpha: ${faint}`);
  const barrier = await changing(editor, "a barrier", () => choose("Right", "Barrier: opacity stops here"));
  check(barrier.includes('sf:right-opacity="none"'), `no barrier: ${barrier}`);
  const number = await changing(editor, "a number again", () => page.locator(".inspector").getByRole("button", { name: "Set value of the opacity" }).click());
  check(number.includes('sf:right-opacity="1"'), `no number: ${number}`);
  await editor.settled();
  editor.checkQuiet();
  await editor.close();
}

/** A picture file becomes a side's opacity: one step, or nothing if no picture was chosen. */
async function testTextureAsOpacity(given) {
  const context = await newContext(given.browser, { isDrawn: true });
  await giveDisk(context);
  const editor = await EditorPage.within(context, given.address);
  const { page } = editor;
  const disk = new Disk(page);
  await editor.load(drawing);
  await editor.click(320, 195);
  const choose = async () => {
    await page.getByRole("button", { name: "Opacity type of each side" }).click();
    await page.getByRole("menuitem", { name: "Right side" }).click();
    await page.getByRole("menuitem", { name: "Texture…" }).click();
  };
  const data = Uint8Array.from({ length: 16 * 8 * 3 }, (_, i) => (37 * i) % 256);
  await disk.write("veil.png", encode({ width: 16, height: 8, data, channels: 3, depth: 8 }));
  await disk.write("words.png", Buffer.from("no picture"));
  await disk.set({ chosen: "" });
  await choose();
  await disk.set({ chosen: "words.png" });
  await choose();
  await said(page, /words\.png/);
  checkEqual(await editor.text, drawing, "the text before a picture was chosen");
  await editor.settled();
  const before = await editor.picture();
  await disk.set({ chosen: "veil.png" });
  const made = await changing(editor, "a texture as opacity", choose);
  check(/sf:right-opacity="url\(#texture\)"/.test(made), `no texture as opacity: ${made.slice(0, 2000)}`);
  check(/<pattern id="texture"[^>]*width="16" height="8"><image href="data:image\/png/.test(made), "no pattern of the picture");
  check(/sf:left-opacity="1"/.test(made), "the other side is not opaque");
  await editor.settled();
  check(Buffer.compare(before, await editor.picture()) !== 0, "the picture shows no texture");
  await page.keyboard.press("Control+z");
  checkEqual(await editor.text, drawing, "the text after one step back");
  editor.checkQuiet();
  await context.close();
}

export async function testPaints(tap, given) {
  await tap.test("paints: grips of gradients by the pointer", () => testPointer(given));
  await tap.test("paints: grips by keys alone", () => testKeys(given));
  await tap.test("paints: a side's opacity is a gradient, a barrier, a number", () => testOpacity(given));
  await tap.test("paints: a picture file becomes a side's opacity", () => testTextureAsOpacity(given));
}
