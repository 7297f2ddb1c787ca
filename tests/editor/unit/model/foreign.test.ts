// Detects files with shapes of another program and without diffusion curves.
import { describe, expect, test } from "vitest";
import { isForeign } from "../../../../web/editor/src/files/foreign.js";
import { blankText } from "../../../../web/editor/src/model/drawing.js";
import { SAMPLES } from "../drawings.js";

const svg = (inner: string, more = "") => `<svg xmlns="http://www.w3.org/2000/svg"${more} viewBox="0 0 9 9">${inner}</svg>`;
const SF = ' xmlns:sf="urn:sfumato:1"';
const path = '<path d="M0 0H9V9Z" fill="red"/>';

/** Longer than what is parsed to find out. */
const long = "\n".repeat(4e6);

describe("a file is of another program", () => {
  test.each([
    ["with a shape", svg(path)],
    ["with a shape in a group", svg(`<g><g>${path}</g></g>`)],
    ["with text alone", svg("<text>a</text>")],
    ["with a namespace of Sfumato's that nothing uses", svg(path, SF)],
    ["with a prefix that is not Sfumato's", svg(path.replace("fill", "sf:left"), ' xmlns:sf="urn:other"')],
    ["with Sfumato's version alone", svg(path, `${SF} sf:version="1"`)],
    ["with a prefix for SVG", '<s:svg xmlns:s="http://www.w3.org/2000/svg"><s:rect width="1" height="1"/></s:svg>'],
    ["where it is long", svg(long + path)],
    ["where it is long and has a prefix for SVG", `<s:svg xmlns:s="http://www.w3.org/2000/svg">${long}<s:rect width="1" height="1"/></s:svg>`],
    ["without a namespace", "<svg><circle r='2'/></svg>"],
  ])("%s", (_, text) => expect(isForeign(text)).toBe(true));
});

describe("a file is not", () => {
  test.each([
    ["where a curve has a side", svg(path.replace("fill", "sf:left"), SF)],
    ["where any attribute is Sfumato's, by any prefix", svg(path, ' xmlns:x="urn:sfumato:1" x:background="#fff"')],
    ["where it is empty", svg("")],
    ["where it shows nothing", svg('<defs><linearGradient id="g"/></defs><title>a</title>')],
    ["where it shows what is not SVG's", svg('<a:path xmlns:a="urn:a"/>')],
    ["where it cannot be read", svg("<g>")],
    ["where it is long and a curve has a side", svg(long + path.replace("fill", "sf:left"), SF)],
    ["where it is long and shows nothing", svg(`${long}<defs/><pathology/>`)],
    ["where it is ours", blankText(9, 9, "#fff")],
  ])("%s", (_, text) => expect(isForeign(text)).toBe(false));

  test.each(SAMPLES.map(({ text }, k) => [k, text] as const))("where it is sample %i", (_, text) => expect(isForeign(text)).toBe(false));
});
