// Takes the pictures of docs/editor.md: docs/images/editor*.jpg, of examples/sunset.svg.
// netpbm packs them (`scripts/setup gallery` installs it).
//
//   node tests/editor/e2e/guide.mjs [BUILD_FOLDER [FOLDER [ONLY]]]      default: build docs/images, all
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { MESA } from "../../chromium.mjs";
import { Artist } from "./artist.mjs";
import { drop } from "./disk.mjs";
import { check, EditorPage, launch, pathOf, serve } from "./harness.mjs";

/** Limit for the bytes of a picture in a document. */
const MOST = 200_000;
/** Limit for the bytes of an unpacked picture. */
const MEMORY = 2 ** 26;
const sunset = readFileSync(pathOf("examples/sunset.svg"), "utf8");

/** The artboard's part of the window, for screenshots without panels. */
const stageOf = (page) => page.locator(".canvas-stage").boundingBox();

const pictures = {
  async "editor-welcome"(editor) {
    return editor.page.screenshot();
  },
  async editor(editor, artist) {
    await editor.load(sunset, "sunset.svg");
    await artist.tool("Nodes");
    await editor.click(720, 445);
    await editor.page.mouse.move(...(await editor.at(480, 590)));
    await editor.settled();
    return editor.page.screenshot();
  },
  async "editor-stops"(editor, artist) {
    await editor.load(sunset, "sunset.svg");
    await artist.tool("Nodes");
    await editor.click(640, 272);
    await artist.stop("Right", 1).dblclick();
    return editor.page.screenshot();
  },
  async "editor-blur"(editor, artist) {
    await editor.load(sunset, "sunset.svg");
    await artist.tool("Nodes");
    await editor.click(380, 526);
    await editor.key("3");
    return editor.page.screenshot({ clip: await stageOf(editor.page) });
  },
  async "editor-layers"(editor, artist) {
    await editor.load(sunset, "sunset.svg");
    await artist.select(876, 443);
    await editor.settled();
    return editor.page.screenshot();
  },
  async "editor-mesh"(editor, artist) {
    await editor.load(sunset, "sunset.svg");
    await artist.menu("View", "Mesh");
    const [[x, y], [right, bottom]] = [await editor.at(480, 300), await editor.at(960, 600)];
    await editor.settled();
    return editor.page.screenshot({ clip: { x, y, width: right - x, height: bottom - y } });
  },
  async "editor-export"(editor) {
    await editor.load(sunset, "sunset.svg");
    await editor.page.getByRole("button", { name: "Export", exact: true }).click();
    await editor.page.getByRole("dialog").getByRole("img").first().waitFor();
    return editor.page.screenshot();
  },
  async "editor-trace"(editor, artist) {
    const { page } = editor;
    await editor.load(sunset, "sunset.svg");
    await artist.menu("File", "Trace photo…");
    const bytes = readFileSync(pathOf("examples/photos/lake.jpg"));
    await drop(page, [{ name: "lake.jpg", bytes, type: "image/jpeg" }], "dialog");
    await page.getByRole("status").filter({ hasText: /Round 3/ }).waitFor();
    // The picture of a round comes after its numbers.
    await page.waitForTimeout(3000);
    return page.screenshot();
  },
  async "editor-keys"(editor) {
    await editor.load(sunset, "sunset.svg");
    await editor.key("?");
    await editor.page.getByRole("dialog").waitFor();
    return editor.page.screenshot();
  },
};

function pack(png, path) {
  const folder = mkdtempSync(join(tmpdir(), "sfumato-guide-"));
  try {
    writeFileSync(join(folder, "picture.png"), png);
    const input = execFileSync("pngtopnm", [join(folder, "picture.png")], { maxBuffer: MEMORY });
    const options = ["-quality=86", "-optimize", "-sample=1x1"];
    const packed = execFileSync("pnmtojpeg", options, { input, maxBuffer: MEMORY });
    writeFileSync(path, packed);
  } finally {
    rmSync(folder, { recursive: true });
  }
  const { size } = statSync(path);
  console.log(`${path}: ${size} bytes`);
  check(size <= MOST, `${path} is larger than ${MOST} bytes`);
}

const [build = "build", folder = pathOf("docs/images"), only = ""] = process.argv.slice(2);
const server = await serve(resolve(build, "editor"));
const browser = await launch(MESA);
try {
  for (const [name, take] of Object.entries(pictures)) {
    if (only !== "" && name !== only) continue;
    // The first page in the light theme, the others in the dark one, as most people draw.
    const colorScheme = name === "editor-welcome" ? "light" : "dark";
    const editor = await EditorPage.open(browser, server.address, { ratio: 1, isDrawn: true, colorScheme, reducedMotion: "reduce" });
    await editor.settled();
    const png = await take(editor, new Artist(editor));
    pack(png, join(folder, `${name}.jpg`));
    await editor.close();
  }
} finally {
  await browser.close();
  server.close();
}
