// The renderer with changing pictures, as the modules that other programs import.
import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { isDeepStrictEqual } from "node:util";
import { check, documentPath, pathOf } from "./harness.mjs";

const DOCUMENTS = ["tests/viewer/compositing.svg", "tests/viewer/small.svg"];

/** Returns the picture of a page, as base64. */
const payloadOf = (html) => html.match(/id="payload">([^<]*)</)[1];

/** Serves the modules, an empty page and a picture; `body` gets the address. */
export async function withServer(payload, body) {
  const made = {
    "/": ["text/html", "<!DOCTYPE html><title>updates</title><canvas></canvas>"],
    "/favicon.ico": ["image/png", ""],
    "/payload": ["text/plain", payload],
  };
  const server = createServer(({ url }, response) => {
    const [type, content] = made[url] ?? ["text/javascript", readFileSync(pathOf(url.slice(1)))];
    response.writeHead(200, { "content-type": type }).end(content);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  try {
    await body(`http://127.0.0.1:${server.address().port}/`);
  } finally {
    server.close();
  }
}

/** Calls a function of updates_page.js with a document. */
async function run({ command, pages }, document, name) {
  documentPath(document);
  let result = null;
  await withServer(payloadOf(readFileSync(command.html(document), "utf8")), async (address) => {
    await pages.visit(address, {}, async (page) => {
      result = await page.evaluate(async (call) => {
        const module = await import("/tests/viewer/updates_page.js");
        return module[call](await module.open());
      }, name);
    });
  });
  return result;
}

export async function testUpdates(tap, tools) {
  for (const document of DOCUMENTS) {
    const name = document.split("/").at(-1);
    await tap.test(`${name} by updates of other tables has the same pixels`, async () => {
      const { before, after } = await run(tools, document, "byUpdates");
      check(before > 1000, `only ${before} bytes differed before`);
      check(after === 0, `${after} bytes differ`);
    });
  }
  await tap.test("another stack keeps tables, and shows nothing of the one before", async () => {
    const { states, bareMiss } = await run(tools, DOCUMENTS[0], "byStacks");
    check(states.every(({ before }) => before > 1000), "the other stack looks the same");
    check(states.every(({ after }) => after === 0) && bareMiss === 0, "pixels differ");
    check(!states.some(({ isStale }) => isStale), "it would refine a picture that is gone");
    // One layer comes back.
    check(states.every(({ made }) => made > 0 && made <= 8), "tables are made anew");
  });
  await tap.test("changes leave nothing on the GPU, and the end nothing at all", async () => {
    const { begin, first, last, end } = await run(tools, DOCUMENTS[0], "manyChanges");
    check(first.Texture > 10 && first.Program > 3, "too little is counted");
    check(isDeepStrictEqual(last, first), `${JSON.stringify(first)} to ${JSON.stringify(last)}`);
    check(isDeepStrictEqual(end, begin), `${JSON.stringify(end)} is left`);
  });
}
