// The editor's tests in Chromium, printed as TAP.
//
//   node tests/editor/e2e/run.mjs BUILD_FOLDER [ONLY]
//
// BUILD_FOLDER has editor/ and editor.html from `make editor`; ONLY: run tests whose names contain it.
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { launch, serve, Tap } from "./harness.mjs";
import { testAccess } from "./access.mjs";
import { testCurves } from "./curves.mjs";
import { testDraw } from "./draw.mjs";
import { testExact } from "./exact.mjs";
import { testExporting } from "./exporting.mjs";
import { testFiles } from "./files.mjs";
import { testFocus } from "./focus.mjs";
import { testForeign } from "./foreign.mjs";
import { testGradients } from "./gradients.mjs";
import { testPaints } from "./paints.mjs";
import { testGestures } from "./gestures.mjs";
import { testGuides } from "./guides.mjs";
import { testIsolation } from "./isolation.mjs";
import { testKeys } from "./keys.mjs";
import { testLayers } from "./layers.mjs";
import { testPanels } from "./panels.mjs";
import { testPhoto } from "./photo.mjs";
import { testPictures } from "./pictures.mjs";
import { testRecover } from "./recover.mjs";
import { testReturns } from "./returns.mjs";
import { testRobust } from "./robust.mjs";
import { testSaving } from "./saving.mjs";
import { testServedDrawing } from "./served.mjs";
import { testShapes } from "./shapes.mjs";
import { testSunset } from "./sunset.mjs";
import { testTools } from "./tools.mjs";
import { testTrace } from "./trace.mjs";
import { testTrial } from "./trial.mjs";

const themes = [
  testSunset,
  testPictures,
  testTools,
  testCurves,
  testGestures,
  testGuides,
  testKeys,
  testAccess,
  testSaving,
  testPanels,
  testExporting,
  testFiles,
  testFocus,
  testForeign,
  testLayers,
  testIsolation,
  testGradients,
  testShapes,
  testPaints,
  testTrace,
  testPhoto,
  testRobust,
  testRecover,
  testReturns,
  testDraw,
  testExact,
  testServedDrawing,
  testTrial,
];

const [folder = "build", only = ""] = process.argv.slice(2);
const tap = new Tap({ only, prefix: "editor: " });
const server = await serve(resolve(folder, "editor"));
const browser = await launch();
const given = {
  browser,
  address: server.address,
  folder: resolve(folder),
  oneFile: pathToFileURL(join(resolve(folder), "editor.html")).href,
};
try {
  for (const test of themes) await test(tap, given);
} finally {
  await browser.close();
  server.close();
}
process.exitCode = tap.failures > 0 ? 1 : 0;
