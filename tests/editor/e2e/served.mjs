// `sfumato edit`: the page that the command serves, with a drawing of the disk. SFUMATO names the command.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { copyFileSync, existsSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { checkEqual, EditorPage, Skip } from "./harness.mjs";
import { example, small } from "./texts.mjs";
import { edit, said, shows } from "./words.mjs";

/** Starts the command beside the built page, where it looks for it. */
export async function startEdit(drawing, { command, page, folder }) {
  const here = join(folder, "sfumato");
  if (!existsSync(here)) {
    copyFileSync(command, here);
    symlinkSync(page, join(folder, "editor.html"));
  }
  const child = spawn(here, ["edit", drawing, "--no-browser"]);
  const [line] = await once(child.stdout, "data");
  return { child, address: String(line).trim() };
}

export const endEdit = async (child) => {
  if (child.exitCode !== null) return;
  child.kill("SIGINT");
  await once(child, "exit");
};

async function testServed(browser, where) {
  const drawing = join(where.folder, "mine.svg");
  const mark = "\ufeff";
  writeFileSync(drawing, mark + small.replaceAll("\n", "\r\n"));
  const { child, address } = await startEdit(drawing, where);
  const editor = await EditorPage.open(browser, address, { size: [900, 600] });
  const { page } = editor;
  try {
    await shows(page, small.replaceAll("\n", "\r\n"));
    checkEqual(await page.locator(".file-name").textContent(), "mine.svg", "the drawing's name");
    await page.keyboard.press("Control+s");
    await said(page, /mine\.svg.* saved/);
    checkEqual(readFileSync(drawing, "utf8"), mark + small.replaceAll("\n", "\r\n"), "the file that was not edited");
    const edited = await edit(editor);
    await page.keyboard.press("Control+s");
    await page.waitForFunction(() => document.querySelector(".saved").textContent === "Saved");
    checkEqual(readFileSync(drawing, "utf8"), mark + edited, "the file after the edit");
    // One drawing in two tabs of one address.
    const second = await EditorPage.within(editor.context, address);
    await said(second.page, /This drawing is open in another tab of this browser/);
    await second.page.close();
    await page.bringToFront();
    writeFileSync(drawing, example("blur.svg"));
    await edit(editor);
    await page.keyboard.press("Control+s");
    await said(page, /changed or removed/);
    checkEqual(readFileSync(drawing, "utf8"), example("blur.svg"), "what somebody else wrote");
    await page.getByRole("button", { name: "Save anyway" }).click();
    await said(page, /saved/);
    checkEqual(readFileSync(drawing, "utf8"), mark + (await editor.text), "the file that was saved anyway");
    // The refused save is on the browser's console.
    checkEqual(editor.requests, [], "requests to elsewhere");
    await edit(editor);
    await endEdit(child);
    await page.keyboard.press("Control+s");
    await said(page, /“sfumato edit” has ended and cannot save/);
  } finally {
    await endEdit(child);
    await editor.close();
  }
}

/** The command serves pictures beside the drawing. */
async function testTextures(browser, where) {
  for (const name of ["textures.svg", "wood.png", "waves.png", "hemp.png"]) {
    writeFileSync(join(where.folder, name), readFileSync(join(where.examples, name)));
  }
  const { child, address } = await startEdit(join(where.folder, "textures.svg"), where);
  const editor = await EditorPage.open(browser, address, { size: [900, 600] });
  try {
    await shows(editor.page, example("textures.svg"));
    await editor.page.waitForFunction(() => window.sfumatoEditor.status.kind === "exact");
    editor.checkQuiet();
  } finally {
    await endEdit(child);
    await editor.close();
  }
}

export async function testServedDrawing(tap, { browser, folder }) {
  const command = process.env.SFUMATO;
  const own = mkdtempSync(join(tmpdir(), "sfumato-edit-"));
  const where = { command, page: join(folder, "editor.html"), folder: own, examples: new URL("../../../examples", import.meta.url).pathname };
  const run = (test) => () => {
    if (!command) throw new Skip("SFUMATO names no command");
    return test(browser, where);
  };
  await tap.test("served: the command's drawing is edited, saved and guarded", run(testServed));
  await tap.test("served: the command gives the drawing's textures", run(testTextures));
  rmSync(own, { recursive: true, force: true });
}
