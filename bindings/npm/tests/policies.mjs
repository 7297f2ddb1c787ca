// Tests the package's files as they are, without a bundler, under policies of pages: Trusted Types, sandboxes, copies.
import { copyFileSync, cpSync, mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { check, checkEqual, PATIENCE, serve } from "./tools.mjs";

const trusted = (names) => `require-trusted-types-for 'script'; trusted-types ${names}`;

/** Returns "ready" or the reason, of the first picture of a page or of its frame. */
const outcome = (frame) =>
  frame.evaluate(async () => {
    await customElements.whenDefined("sfumato-picture");
    return document.querySelector("sfumato-picture").ready.then(() => "ready", (error) => error.message);
  });

const pages = {
  plain: '<script type="module" src="pkg/element.js"></script><sfumato-picture src="halves.svg"></sfumato-picture>',
  given: `<script type="module">
    import { SfumatoPicture } from "./pkg/element.js";
    SfumatoPicture.workerUrl = trustedTypes.createPolicy("page", { createScriptURL: (text) => text }).createScriptURL("pkg/worker.js");
    document.querySelector("p").append(Object.assign(document.createElement("sfumato-picture"), { src: "halves.svg" }));
    </script><p></p>`,
  frame: '<iframe sandbox="allow-scripts" src="plain.html"></iframe>',
  twice: `<script type="module">
    const [one, two] = [await import("./pkg/element.js"), await import("./pkg/element.js?2")];
    window.isOne = one.SfumatoPicture === two.SfumatoPicture && new two.SfumatoPicture() instanceof HTMLElement;
    </script><sfumato-picture src="halves.svg"></sfumato-picture>`,
};

async function visit(browser, folder, name, headers, body) {
  const { address, close } = await serve(folder, { "Access-Control-Allow-Origin": "*", ...headers });
  const context = await browser.newContext();
  context.setDefaultTimeout(PATIENCE);
  try {
    const page = await context.newPage();
    await page.goto(`${address}${name}.html`);
    await body(page);
  } finally {
    await context.close();
    close();
  }
}

export async function testPolicies(tap, browser, project) {
  const folder = join(project, "raw");
  mkdirSync(folder, { recursive: true });
  cpSync(join(project, "node_modules/sfumato"), join(folder, "pkg"), { recursive: true });
  copyFileSync(join(project, "public/halves.svg"), join(folder, "halves.svg"));
  for (const [name, text] of Object.entries(pages)) {
    writeFileSync(join(folder, `${name}.html`), `<!doctype html><html lang="en"><meta charset="utf-8"><title>${name}</title>${text}</html>`);
  }
  await tap.test("npm: Trusted Types take the package's policy or the page's worker, and are named otherwise", async () => {
    for (const [name, policies, expected] of [["plain", "sfumato", /^ready$/], ["given", "page", /^ready$/], ["plain", "page", /Trusted Types refuse .*workerUrl/]]) {
      await visit(browser, folder, name, { "Content-Security-Policy": trusted(policies) }, async (page) => {
        const said = await outcome(page);
        check(expected.test(said), `${name}, ${policies}: ${said}`);
      });
    }
  });
  await tap.test("npm: a sandboxed frame without an origin draws", () =>
    visit(browser, folder, "frame", { "Content-Security-Policy": "default-src * blob: data: 'unsafe-inline' 'wasm-unsafe-eval'" }, async (page) => {
      const frame = page.frames()[1];
      await frame.waitForLoadState();
      checkEqual(await outcome(frame), "ready", "the outcome");
    }));
  await tap.test("npm: a second copy exports the class that the first one registered", () =>
    visit(browser, folder, "twice", { "Content-Security-Policy": "default-src * 'unsafe-inline' 'wasm-unsafe-eval'" }, async (page) => {
      checkEqual(await outcome(page), "ready", "the outcome");
      await page.waitForFunction(() => window.isOne !== undefined);
      checkEqual(await page.evaluate(() => window.isOne), true, "one class");
    }));
}
