import { gzipSync } from "node:zlib";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { openPieces } from "../../../../web/editor/src/files/drop.js";
import type { Opened } from "../../../../web/editor/src/files/open.js";
import { mostFileBytes, openFile, rootName } from "../../../../web/editor/src/files/open.js";
import { piecesOf } from "../../../../web/editor/src/files/pieces.js";
import { bytesOf, textOf } from "../../../../web/editor/src/files/text.js";
import * as en from "../../../../web/editor/src/strings/en.js";

const words = en.files;
const svg = '<?xml version="1.0"?>\n<!-- é --><svg xmlns="http://www.w3.org/2000/svg"/>\n';
const png = "\x89PNG\r\n\x1a\n";
const latin = (text: string) => Uint8Array.from(text, (c) => c.charCodeAt(0));
const utf8 = (text: string) => new TextEncoder().encode(text);
const file = (bytes: BlobPart, name = "a.svg") => new File([bytes], name, { lastModified: 7 });
const noConvert = () => Promise.reject(new Error("no conversion was expected"));
const open = (bytes: BlobPart, name = "a.svg") => openFile(file(bytes, name), noConvert);
const reason = (opened: Opened) => (opened.kind === "problem" ? opened.reason : opened);

function utf16(text: string, isLittle: boolean): Uint8Array<ArrayBuffer> {
  const view = new DataView(new ArrayBuffer(2 * text.length + 2));
  [..."\ufeff", ...text.split("")].forEach((c, i) => view.setUint16(2 * i, c.charCodeAt(0), isLittle));
  return new Uint8Array(view.buffer);
}

const forms: readonly (readonly [string, Uint8Array<ArrayBuffer>])[] = [
  ["UTF-8", utf8(svg)],
  ["UTF-8 with a mark", utf8(`\ufeff${svg}`)],
  ["UTF-16, little", utf16(svg, true)],
  ["UTF-16, big", utf16(svg, false)],
];

describe("a drawing", () => {
  test.each(forms)("of %s is read, and written as the same bytes", async (_, bytes) => {
    const opened = await open(bytes);
    if (opened.kind !== "drawing") throw new Error(JSON.stringify(opened));
    expect(opened.text).toBe(svg);
    expect(await bytesOf(opened.text, opened.place.form)).toEqual(bytes);
  });

  test.each(forms)("of %s that is packed is read, and packed again", async (_, bytes) => {
    const opened = await open(new Uint8Array(gzipSync(bytes)), "a.svgz");
    if (opened.kind !== "drawing") throw new Error(JSON.stringify(opened));
    expect(opened.text).toBe(svg);
    const again = await textOf(await bytesOf(svg, opened.place.form), "a.svgz");
    expect(again).toEqual({ text: svg, form: opened.place.form });
    expect(opened.place.form.packed).toBe(true);
  });

  test("with a handle is saved to it", async () => {
    const handle = { name: "a.svg" } as FileSystemFileHandle;
    const opened = await openFile(file(svg), noConvert, handle);
    expect(opened).toMatchObject({ place: { name: "a.svg", target: { kind: "handle", handle, modified: 7 } } });
  });

  test("of Orzan becomes an SVG that no file has", async () => {
    const handle = { name: "ball.xml" } as FileSystemFileHandle;
    const xml = '<!DOCTYPE CurveSetXML>\n<curve_set image_width="9"/>';
    const opened = await openFile(file(xml, "ball.xml"), async (text) => `svg of ${text}`, handle);
    expect(opened).toMatchObject({ kind: "drawing", text: `svg of ${xml}`, place: { name: "ball.svg", target: { kind: "none" } } });
  });

  test("that cannot be converted says why", async () => {
    const fail = () => Promise.reject(new Error("Line 1, column 2: no curves"));
    expect(reason(await openFile(file("<curve_set/>", "a.xml"), fail))).toBe("Line 1, column 2: no curves");
  });
});

describe("what is no drawing is refused in words", () => {
  const cases: readonly (readonly [string, BlobPart, string])[] = [
    ["nothing", "", words.empty("a.svg")],
    ["text", "hello", words.noDrawing("a.svg")],
    ["blanks", " \n\t", words.noDrawing("a.svg")],
    ["a comment alone", "<!-- <svg/> -->", words.noDrawing("a.svg")],
    ["Latin-1", latin("<svg>\xe9</svg>"), words.notText("a.svg")],
    ["half of UTF-16", utf16("<svg/>\ud800", true), words.notText("a.svg")],
    ["damaged gzip", latin("\x1f\x8b\x08\0garbage"), words.brokenGzip("a.svg")],
    ["half of gzip", new Uint8Array(gzipSync(svg)).slice(0, 40), words.brokenGzip("a.svg")],
    ["a bomb", new Uint8Array(gzipSync(Buffer.alloc(mostFileBytes + 1))), words.unpacksTooLarge("a.svg")],
  ];
  test.each(cases)("%s", async (_, bytes, expected) => {
    expect(reason(await open(bytes))).toBe(expected);
  });

  test("a file of 200 MB, which is not even read", async () => {
    const huge = { name: "a.svg", size: 200e6, arrayBuffer: () => Promise.reject(new Error("was read")) };
    expect(reason(await openFile(huge as unknown as File, noConvert))).toBe(words.tooLarge("a.svg"));
  });

  test("a folder, which a browser cannot read", async () => {
    const folder = { name: "a.svg", size: 4096, arrayBuffer: () => Promise.reject(new DOMException("", "NotFoundError")) };
    expect(reason(await openFile(folder as unknown as File, noConvert))).toBe(words.unreadable("a.svg"));
  });
});

describe("a photo", () => {
  const close = vi.fn();
  beforeEach(() => vi.stubGlobal("createImageBitmap", async () => ({ width: 40, height: 30, close })));
  afterEach(() => vi.unstubAllGlobals());

  test.each([png, "\xff\xd8\xff\xe0", "GIF89a", "RIFF\x10\0\0\0WEBPVP8 ", "\0\0\0\x1cftypavif", "\0\0\0\x1cftypheic"])(
    "shows in its bytes: %j",
    async (begin) => {
      const opened = await open(latin(begin), "photo.svg");
      expect(opened).toMatchObject({ kind: "photo", width: 40, height: 30, name: "photo.svg" });
      expect(close).toHaveBeenCalled();
    },
  );

  test("that no browser decodes is reported", async () => {
    vi.stubGlobal("createImageBitmap", () => Promise.reject(new DOMException("", "InvalidStateError")));
    expect(reason(await open(latin(png), "a.png"))).toBe(words.undecodable("a.png"));
  });

  test("of too many pixels is reported", async () => {
    vi.stubGlobal("createImageBitmap", async () => ({ width: 20000, height: 20000, close }));
    expect(reason(await open(latin(png), "a.png"))).toBe(words.photoTooLarge("a.png"));
  });
});

describe("a drop", () => {
  const item = (name: string, text: string, isDirectory = false) => ({
    kind: "file",
    getAsFile: () => file(text, name),
    webkitGetAsEntry: () => ({ isDirectory }),
  });
  const pieces = (...items: object[]) => piecesOf({ items } as unknown as DataTransfer);
  const drop = (...items: object[]) => openPieces(pieces(...items)!, noConvert);

  test("of a drawing brings what lies beside it", async () => {
    const dropped = await drop(item("t.png", png), item("a.svg", svg), item("u.jpg", "x"));
    expect(dropped.opened.kind).toBe("drawing");
    expect(dropped.beside.map(({ name }) => name)).toEqual(["t.png", "u.jpg"]);
  });

  test("of text brings nothing", () => {
    expect(pieces({ kind: "string" })).toBeNull();
  });

  test.each([
    ["a folder", [item("folder", "", true)], words.folder],
    ["a drawing and a folder", [item("a.svg", svg), item("folder", "", true)], words.folder],
    ["two drawings", [item("a.svg", svg), item("b.xml", svg)], words.several],
    ["two photos", [item("a.png", png), item("b.png", png)], words.several],
  ])("of %s is reported", async (_, items, expected) => {
    expect(reason((await drop(...items)).opened)).toBe(expected);
  });
});

test("the first element shows behind all that may come before it", () => {
  expect(rootName('\ufeff<?xml version="1.0"?><!--<a>--><!DOCTYPE svg [<!ENTITY x "y">]>\n<svg:svg>')).toBe("svg");
  expect(rootName("<!DOCTYPE CurveSetXML><curve_set>")).toBe("curve_set");
  for (const text of ["", "svg", "<", "</svg>", "< svg>", "<?xml", "<!--<svg>"]) expect(rootName(text)).toBe("");
  const slow = "<!DOCTYPE " + "[".repeat(50000) + "<!--".repeat(50000);
  expect(rootName(slow)).toBe("");
});
