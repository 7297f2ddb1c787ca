// Tests of the editor in Chromium: node run.mjs BUILD_FOLDER [ONLY]. BUILD_FOLDER holds editor/ and editor.html.
import { resolve } from "node:path";
import { launch, serve, Tap } from "./harness.mjs";
import { testDraw } from "./draw.mjs";

const themes = [testDraw];

const [folder = "build", only = ""] = process.argv.slice(2);
const tap = new Tap(only);
const server = await serve(resolve(folder, "editor"));
const browser = await launch();
try {
  const given = { browser, address: server.address, oneFile: resolve(folder, "editor.html") };
  for (const test of themes) await test(tap, given);
} finally {
  await browser.close();
  server.close();
}
process.exitCode = tap.failures > 0 ? 1 : 0;
