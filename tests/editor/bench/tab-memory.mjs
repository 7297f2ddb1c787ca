// The memory of a tab, as Linux reports it: its heaps, the modules of its workers, and Chromium's own part.
import { readFileSync } from "node:fs";

/** Returns the processes that show pages. */
async function renderers(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  return processInfo.filter(({ type }) => type === "renderer").map(({ id }) => id);
}

function privateBytes(pid) {
  const text = readFileSync(`/proc/${pid}/smaps_rollup`, "utf8");
  const lines = [...text.matchAll(/^Private_\w+:\s+(\d+) kB$/gm)];
  return lines.reduce((sum, [, kilobytes]) => sum + 1024 * Number(kilobytes), 0);
}

/** Returns the private memory of the largest process after garbage collection, MB. */
export async function tabMegabytes(browser, page) {
  const session = await page.context().newCDPSession(page);
  await session.send("HeapProfiler.collectGarbage");
  await session.send("Performance.enable");
  const { metrics } = await session.send("Performance.getMetrics");
  await session.detach();
  const heap = metrics.find(({ name }) => name === "JSHeapUsedSize").value / 1e6;
  const pids = await renderers(browser);
  return { heap, whole: Math.max(...pids.map(privateBytes)) / 1e6 };
}
