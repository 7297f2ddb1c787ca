// Chromium for the tests: without network access, with software rendering.
import { PATIENCE } from "./tap.mjs";

const quiet = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Mesa's driver, which is several times as fast as Chromium's own. */
export const MESA = [
  "--use-gl=angle",
  "--use-angle=gl-egl",
  "--ignore-gpu-blocklist",
  "--enable-gpu",
];
/** Chromium's own driver. */
export const SWIFTSHADER = ["--disable-gpu"];

/** Starts a browser. @param chromium of the calling folder's playwright-core */
export function launchWith(chromium, flags = MESA) {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  return chromium.launch({ executablePath, args: [...quiet, ...flags], timeout: PATIENCE });
}
