// Tests of the HTML viewer, SVG, GLB, PDF and the page of `sfumato watch` in Chromium and programs
// from npm, printed as TAP:
// node run.mjs SFUMATO DUMP_PICTURE OUT_FOLDER
import { execFileSync } from "node:child_process";
import { rmSync } from "node:fs";
import { chromium } from "playwright-core";
import { PNG } from "pngjs";
import { launchWith, MESA, SWIFTSHADER } from "../chromium.mjs";
import { Command, Pages, Tap, pathOf } from "./harness.mjs";
import { testBundle } from "./bundle.mjs";
import { testExact } from "./exact.mjs";
import { testExactHard } from "./exact_hard.mjs";
import { testFramesAndPaper } from "./frames.mjs";
import { testInteraction } from "./interaction.mjs";
import { testGlb, testSvg } from "./outputs.mjs";
import { testPayload } from "./payload.mjs";
import { testPdf, testPdfInChromium } from "./pdf.mjs";
import { testOtherDriver, testPictures } from "./pictures.mjs";
import { testRobustness } from "./robustness.mjs";
import { testTables } from "./tables.mjs";
import { testTiles } from "./tiles.mjs";
import { testUpdates } from "./updates.mjs";
import { testWatch } from "./watch.mjs";

const [program, dump, folder] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });

const tap = new Tap();
const command = new Command(program, folder);
await tap.test("the viewer's types are right", () => {
  const compiler = pathOf("tests/viewer/node_modules/typescript/bin/tsc");
  try {
    execFileSync(process.execPath, [compiler, "-p", pathOf("tests/viewer")]);
  } catch (error) {
    throw new Error(String(error.stdout));
  }
});
await testBundle(tap);
await testPayload(tap, { dump, command });
await testTables(tap);
await testGlb(tap, { command });
await testPdf(tap, { command });

/** Runs `body` with a browser whose graphics follow the flags. */
async function withBrowser(flags, body) {
  const browser = await launchWith(chromium, flags);
  try {
    await body({ PNG, command, pages: new Pages(browser) });
  } finally {
    await browser.close();
  }
}

async function hasWebGl(flags) {
  let found = false;
  await withBrowser(flags, async ({ pages }) => {
    const page = await pages.browser.newPage();
    found = await page.evaluate(
      () => document.createElement("canvas").getContext("webgl2") !== null,
    );
  }).catch(() => {});
  return found;
}

await tap.whole("Chromium starts, and all tests come to their end", async () => {
  const [first, other] = (await hasWebGl(MESA)) ? [MESA, SWIFTSHADER] : [SWIFTSHADER, MESA];
  await withBrowser(first, async (tools) => {
    await testPictures(tap, tools);
    await testUpdates(tap, tools);
    await testInteraction(tap, tools);
    await testRobustness(tap, tools);
    await testFramesAndPaper(tap, tools);
    await testSvg(tap, tools);
    await testPdfInChromium(tap, tools);
    await testWatch(tap, tools);
    await testTiles(tap, tools);
    await testExact(tap, tools);
    await testExactHard(tap, tools);
  });
  await withBrowser(other, (tools) => testOtherDriver(tap, tools));
});
process.exitCode = tap.failures > 0 ? 1 : 0;
