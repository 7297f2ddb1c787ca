// Lost graphics, browsers without a feature, damaged files, pictures with little content.
import { writeFileSync } from "node:fs";
import { check, difference, pictureOf, rangeOf, settled } from "./harness.mjs";

const DOCUMENT = "tests/wasm/controls.svg";

const payloadOf = (text) => text.match(/id="payload">([^<]*)</)[1];

async function testContext(tap, { pages, command, PNG }) {
  await tap.test("a context that is lost and comes back shows the picture again", () =>
    pages.open(command.html(DOCUMENT), {}, async (page) => {
      await settled(page);
      const before = await pictureOf(page);
      await page.evaluate(() => {
        window.lose = document
          .getElementById("canvas")
          .getContext("webgl2")
          .getExtension("WEBGL_lose_context");
        window.lose.loseContext();
      });
      await page.waitForFunction(() => !document.getElementById("message").hidden);
      check(await page.isVisible("#message"), "nothing is said");
      await page.evaluate(() => window.lose.restoreContext());
      await page.waitForFunction(() => document.getElementById("message").hidden);
      await settled(page);
      check(difference(PNG, before, await pictureOf(page)).mean === 0, "it looks different");
    }),
  );
}

async function saysInstead({ pages }, path, before, words) {
  await pages.open(path, { before, broken: true }, async (page) => {
    await page.waitForFunction(() => document.getElementById("message").textContent.length > 30);
    const said = await page.textContent("#message");
    check(said.includes(words), `it says: ${said}`);
    check(await page.isVisible("#message"), "the words are hidden");
    const fallback = await page.$("#fallback");
    check(fallback && (await fallback.isVisible()), "there is no still picture");
    check(
      await fallback.evaluate((image) => image.complete && image.naturalWidth > 0),
      "it is empty",
    );
    check(!(await page.isVisible("#tools")), "there are buttons without a use");
  });
}

async function testBrowsers(tap, tools) {
  const html = tools.command.html(DOCUMENT);
  await tap.test("without WebGL 2 the still picture is shown", () =>
    saysInstead(tools, html, "HTMLCanvasElement.prototype.getContext = () => null", "no WebGL 2"),
  );
  await tap.test("a driver that refuses the shaders is spoken of", () => {
    const path = tools.command.changed(DOCUMENT, "refused", (page) =>
      page.replaceAll("void main()", "void main("),
    );
    return saysInstead(tools, path, undefined, "refuses a shader");
  });
  await tap.test("without DecompressionStream the still picture is shown", () =>
    saysInstead(tools, html, "delete window.DecompressionStream", "DecompressionStream"),
  );
}

async function testDamage(tap, tools) {
  const damages = {
    "a byte that was changed": (payload) =>
      payload.slice(0, 400) + (payload[400] === "A" ? "B" : "A") + payload.slice(401),
    "an end that was cut off": (payload) => payload.slice(0, payload.length / 2),
    "text that is not base64": () => "%%%",
    "no payload at all": () => "",
  };
  for (const [name, damage] of Object.entries(damages)) {
    await tap.test(`a damaged file is spoken of: ${name}`, () => {
      const change = (text) => text.replace(payloadOf(text), () => damage(payloadOf(text)));
      const path = tools.command.changed(DOCUMENT, `damaged_${name.replace(/\W/g, "_")}`, change);
      return saysInstead(tools, path, undefined, "damaged");
    });
  }
}

async function testSmall(tap, { pages, command, PNG }) {
  const write = (name, content) => {
    const path = command.file(`${name}.svg`);
    const head =
      '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" ' +
      'viewBox="0 0 40 30" sf:version="1">';
    writeFileSync(path, `${head}${content}</svg>`);
    const html = command.file(`${name}.html`);
    command.run("render", path, "-o", html, "--quiet", "--title", '</script><b>&"');
    return html;
  };
  await tap.test("an empty picture is an empty page", () =>
    pages.open(write("empty", ""), { size: [200, 150] }, async (page) => {
      await page.evaluate(() => {
        window.sfumatoViewer.view = { x: 20, y: 15, zoom: 20 };
      });
      await settled(page);
      check(rangeOf(PNG, await pictureOf(page)) === 0, "there is something");
    }),
  );
  await tap.test("a title with markup stays a title", () =>
    pages.open(
      write(
        "title",
        '<g sf:diffuse="true"><path d="M0 15 H40" sf:left="red" sf:right="blue"/></g>',
      ),
      {},
      async (page) => {
        check((await page.title()) === '</script><b>&"', `the title is ${await page.title()}`);
        check((await page.$("b")) === null, "the markup became an element");
      },
    ),
  );
}

export async function testRobustness(tap, tools) {
  await testContext(tap, tools);
  await testBrowsers(tap, tools);
  await testDamage(tap, tools);
  await testSmall(tap, tools);
}
