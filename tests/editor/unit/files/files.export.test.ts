import { decode } from "fast-png";
import { inflateSync } from "node:zlib";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { packPng } from "../../../../web/editor/src/engine/pack-png.js";
import type { PngPixels } from "../../../../web/editor/src/engine/png.js";
import type { ExportSource, ExportWish } from "../../../../web/editor/src/files/export.js";
import { complaintAboutSize, copyPng, estimateSize, exportDrawing, exportName, mostSide, nameOfSize, withoutReference } from "../../../../web/editor/src/files/export.js";
import { pageOf } from "../../../../web/editor/src/files/page.js";
import * as en from "../../../../web/editor/src/strings/en.js";

const words = en.files;

/** A worker that answers like png.worker.ts, unless it is held. */
const workers = vi.hoisted(() => ({ isHeld: false, ended: 0 }));
vi.mock("../../../../web/editor/src/engine/host.js", () => ({
  createPngWorker: () => {
    const worker = {
      onmessage: (_: { data: object }): void => undefined,
      postMessage: (pixels: PngPixels) => {
        if (!workers.isHeld) queueMicrotask(() => worker.onmessage({ data: { png: packPng(pixels) } }));
      },
      terminate: () => void (workers.ended += 1),
    };
    return worker;
  },
}));

/** The part of FileReader that the page needs; Node has none. */
class Reader {
  result: string | null = null;
  onload = (): void => undefined;
  async readAsDataURL(blob: Blob): Promise<void> {
    this.result = `data:;base64,${Buffer.from(await blob.arrayBuffer()).toString("base64")}`;
    this.onload();
  }
}

beforeEach(() => {
  workers.isHeld = false;
  workers.ended = 0;
  vi.stubGlobal("FileReader", Reader);
});
afterEach(() => vi.unstubAllGlobals());

const wish: ExportWish = {
  format: "png",
  width: 3,
  height: 2,
  viewport: [0, 0, 3, 2],
  transparent: false,
  keepReference: false,
};

/** Returns an engine whose pixels encode their positions. */
function source(alpha = 255): ExportSource & { asked: object[] } {
  const asked: object[] = [];
  const raster = async (asks: { width: number; height: number; depth: 8 | 16 }) => {
    asked.push(asks);
    const count = 4 * asks.width * asks.height;
    const value = (i: number) => (i % 4 === 3 ? alpha : i % 251);
    return asks.depth === 16
      ? Uint16Array.from({ length: count }, (_, i) => 257 * value(i))
      : Uint8ClampedArray.from({ length: count }, (_, i) => value(i));
  };
  const payload = async () => new Uint8Array([1, 2, 3]);
  const write = async (asks: object) => {
    asked.push(asks);
    return { bytes: new Uint8Array([37, 80]), warnings: ["a note"] };
  };
  const engine = { raster, payload, write } as ExportSource["engine"];
  return { engine, text: "<svg/>", name: "a <b>.svg", artboard: [0, 0, 30, 20], asked };
}

const bytesOf = async (blob: Blob) => new Uint8Array(await blob.arrayBuffer());

describe("a PNG has the engine's pixels", () => {
  test.each([8, 16] as const)("of %i bits, without alpha where all is opaque", async (depth) => {
    const from = source();
    const image = decode(await bytesOf(await exportDrawing({ ...wish, depth }, from)));
    expect(image).toMatchObject({ width: 3, height: 2, depth, channels: 3 });
    const one = depth === 16 ? 257 : 1;
    expect([...image.data.slice(0, 6)]).toEqual([0, 1, 2, 4, 5, 6].map((value) => one * value));
    expect(from.asked).toEqual([{ width: 3, height: 2, viewport: wish.viewport, background: null, depth }]);
  });

  test.each([8, 16] as const)("of %i bits, also where they can be seen through", async (depth) => {
    const from = source(7);
    const image = decode(await bytesOf(await exportDrawing({ ...wish, depth, transparent: true }, from)));
    expect(image.channels).toBe(4);
    expect([...image.data]).toEqual([...(await from.engine.raster({ ...wish, background: null, depth }))]);
    expect(from.asked[0]).toMatchObject({ background: "none" });
  });
});

describe("a size", () => {
  test.each([
    [0, 1, words.badSize],
    [1.5, 1, words.badSize],
    [NaN, 1, words.badSize],
    [1, Infinity, words.badSize],
    [mostSide + 1, 1, words.sideTooLong(mostSide)],
    [mostSide, mostSide, words.pictureTooLarge],
    [mostSide, 8192, null],
    [1, 1, null],
  ])("of %d × %d: %s", async (width, height, expected) => {
    expect(complaintAboutSize({ ...wish, width, height })).toBe(expected);
  });

  test("that is too large asks nothing of the engine", async () => {
    const from = source();
    await expect(exportDrawing({ ...wish, width: 1e6 }, from)).rejects.toThrow(words.sideTooLong(mostSide));
    expect(complaintAboutSize({ ...wish, width: mostSide, height: 8192, depth: 16 })).toBe(words.pictureTooLarge);
    expect(await estimateSize({ ...wish, width: 1e6 }, from)).toBeNull();
    expect(from.asked).toEqual([]);
  });
});

describe("an export that is cancelled", () => {
  test("while the engine draws ends at once", async () => {
    const cancel = new AbortController();
    const from = source();
    from.engine.raster = () => new Promise(() => undefined);
    const exported = exportDrawing(wish, from, { signal: cancel.signal });
    cancel.abort("enough");
    await expect(exported).rejects.toBe("enough");
  });

  test("while it is packed ends the worker", async () => {
    const cancel = new AbortController();
    workers.isHeld = true;
    const stages: string[] = [];
    const exported = exportDrawing(wish, source(), {
      signal: cancel.signal,
      onStage: (stage) => {
        stages.push(stage);
        if (stage === "pack") setTimeout(() => cancel.abort("enough"));
      },
    });
    await expect(exported).rejects.toBe("enough");
    expect(stages).toEqual(["draw", "pack"]);
    expect(workers.ended).toBe(1);
  });
});

describe("an SVG", () => {
  const sf = 'xmlns:f="urn:sfumato:1"';

  test("is the text itself where the photo stays", async () => {
    const from = { ...source(), text: "<svg >\r\n broken" };
    expect(await (await exportDrawing({ ...wish, format: "svg", keepReference: true }, from)).text()).toBe(from.text);
  });

  test("loses the photo that is traced over, and nothing else", () => {
    const photo = '<image f:reference="true" href="data:,x"/>';
    const keeps = [`<image href="a.png"/>`, '<image f:reference="false"/>', '<image reference="true"/>', `<!-- ${photo} -->`];
    const text = `<svg ${sf}>\n  <g>\n    ${photo}\n    <g/>${photo}<g/>\n  </g>\n${keeps.join("\n")}\n</svg>\n`;
    const without = `<svg ${sf}>\n  <g>\n    <g/><g/>\n  </g>\n${keeps.join("\n")}\n</svg>\n`;
    expect(withoutReference(text)).toBe(without);
    expect(withoutReference(without)).toBe(without);
  });

  test("that is broken is a promise's affair", async () => {
    const exported = exportDrawing({ ...wish, format: "svg" }, { ...source(), text: "<svg" });
    await expect(exported).rejects.toThrow();
  });
});

describe("the viewer's page", () => {
  const template = "<title>{{title}}</title>{{fallback}}<i>{{payload}}</i>{{other}}";

  test("holds its parts, which are not looked through", async () => {
    const page = await pageOf(template, { title: '{{payload}} & "<b>\n', fallback: "data:$&", payload: new Uint8Array([5, 6]) });
    const [, payload] = /<i>(.*)<\/i>/.exec(page)!;
    expect([...inflateSync(Buffer.from(payload, "base64"))]).toEqual([5, 6]);
    const title = "{{payload}} &amp; &quot;&lt;b&gt; ";
    expect(page.replace(payload, "…")).toBe(
      `<title>${title}</title><img id="fallback" alt="${title}" src="data:$&amp;"><i>…</i>{{other}}`,
    );
  });

  test("is whole: scripts, shaders and the engine's payload", async () => {
    const from = source();
    from.engine.raster = async () => new Uint16Array(0);
    const page = await (await exportDrawing({ ...wish, format: "html" }, from)).text();
    expect(page).toContain("<title>a &lt;b&gt;</title>");
    expect(page).toContain('"patch.frag"');
    expect(page).not.toMatch(/\{\{\w+\}\}/);
    expect(page).not.toMatch(/^(import|export) /m);
    const [, payload] = /id="payload">([^<]*)</.exec(page)!;
    expect([...inflateSync(Buffer.from(payload, "base64"))]).toEqual([1, 2, 3]);
    expect(Math.abs((await estimateSize({ ...wish, format: "html" }, from))! - page.length)).toBeLessThan(200);
  });
});

test("an estimate of a PNG looks at a small part of it", async () => {
  const from = source();
  const size = await estimateSize({ ...wish, width: 3000, height: 2000 }, from);
  expect(size).toBeGreaterThan(1000);
  const { width, height } = from.asked[0] as ExportWish;
  expect(width * height).toBeLessThan(70000);
});

describe("the clipboard", () => {
  test("takes the picture as a promise", async () => {
    const write = vi.fn(async ([item]: { types: Record<string, Promise<Blob>> }[]) => void (await item.types["image/png"]));
    vi.stubGlobal("ClipboardItem", class { constructor(readonly types: object) {} });
    vi.stubGlobal("navigator", { clipboard: { write } });
    await copyPng({ ...wish, format: "svg" }, source());
    const png = await bytesOf(await write.mock.calls[0][0][0].types["image/png"]);
    expect(decode(png).width).toBe(3);
  });

  test("that refuses, or is not there, is reported, after what the picture lacks", async () => {
    await expect(copyPng(wish, source())).rejects.toThrow(words.noClipboard);
    vi.stubGlobal("ClipboardItem", class {});
    vi.stubGlobal("navigator", { clipboard: { write: () => Promise.reject(new DOMException("", "NotAllowedError")) } });
    await expect(copyPng(wish, source())).rejects.toThrow(words.clipboardRefused);
    await expect(copyPng({ ...wish, width: 0 }, source())).rejects.toThrow(words.badSize);
  });
});

describe("PDF and plain SVG", () => {
  const asks = async (part: Partial<ExportWish>) => {
    const from = source();
    const notes: string[] = [];
    const file = await exportDrawing({ ...wish, ...part }, from, { onNotes: (found) => notes.push(...found) });
    expect([...(await bytesOf(file))]).toEqual([37, 80]);
    expect(notes).toEqual(["a note"]);
    return { type: file.type, ...from.asked[0] };
  };

  test("have the command's options", async () => {
    const viewport = wish.viewport;
    expect(await asks({ format: "pdf" })).toEqual({ type: "application/pdf", format: "pdf", viewport, options: { title: "a <b>" }, detail: 2 });
    const plain = { type: "image/svg+xml", format: "svg", viewport };
    expect(await asks({ format: "plain" })).toEqual({ ...plain, options: { svg: "vector" }, detail: 1 });
    expect(await asks({ format: "plain", plain: "pixels", transparent: true })).toEqual({
      ...plain,
      options: { svg: "image", background: "none" },
      detail: 2,
    });
  });

  test("that are cancelled end at once", async () => {
    const engine = { ...source().engine, write: () => new Promise<never>(() => undefined) };
    const cancel = new AbortController();
    const exported = exportDrawing({ ...wish, format: "pdf" }, { ...source(), engine }, { signal: cancel.signal });
    cancel.abort();
    await expect(exported).rejects.toThrow("abort");
  });

  test("have names of their own", () => {
    expect(exportName({ format: "pdf" }, "a.svg")).toBe("a.pdf");
    expect(exportName({ format: "plain" }, "a.svgz")).toBe("a-plain.svg");
    expect(exportName({ format: "svg" }, "a.xml")).toBe("a.svg");
  });
});

test.each([
  [30, 20, "a.png"],
  [60, 40, "a@2x.png"],
  [90, 60, "a@3x.png"],
  [45, 30, "a-45x30.png"],
  [60, 20, "a-60x20.png"],
])("a size of %d by %d is part of the name", (width, height, name) => {
  expect(nameOfSize("a.svg", { width, height }, { width: 30, height: 20 })).toBe(name);
});
