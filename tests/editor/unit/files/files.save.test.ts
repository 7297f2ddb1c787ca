import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import type { Place } from "../../../../web/editor/src/files/place.js";
import { newPlace, withExtension } from "../../../../web/editor/src/files/place.js";
import { save, saveAs, saveExport } from "../../../../web/editor/src/files/save.js";
import { besideServed, openServed, servedName } from "../../../../web/editor/src/files/served.js";
import { plainForm } from "../../../../web/editor/src/files/text.js";
import * as en from "../../../../web/editor/src/strings/en.js";

const words = en.files;
const fileSave = vi.hoisted(() => vi.fn());
vi.mock("browser-fs-access", () => ({ fileSave, fileOpen: vi.fn(), supported: true }));

const fails = async (reason: string): Promise<Blob> => {
  throw new Error(reason);
};

/** Returns a file on a disk, with the time of its last change. */
function disk(modified: number) {
  const state = { modified, gone: false };
  const handle = {
    name: "a.svg",
    getFile: async () => {
      if (state.gone) throw new DOMException("", "NotFoundError");
      return { lastModified: state.modified };
    },
  } as unknown as FileSystemFileHandle;
  return { state, handle };
}

const at = (handle: FileSystemFileHandle, modified: number): Place => ({
  name: "a.svg",
  form: plainForm,
  target: { kind: "handle", handle, modified },
});

beforeEach(() => void fileSave.mockReset());

describe("saving to the file that was opened", () => {
  test("writes it, and knows the file as it is then", async () => {
    const { state, handle } = disk(1);
    fileSave.mockImplementation(async (blob: Blob) => {
      expect(await blob.text()).toBe("<svg/>");
      state.modified = 2;
      return handle;
    });
    const saved = await save("<svg/>", at(handle, 1));
    expect(saved).toMatchObject({ kind: "saved", place: { target: { modified: 2 } } });
    expect(fileSave.mock.calls[0][2]).toBe(handle);
    expect(fileSave.mock.calls[0][3]).toBe(true);
  });

  test("does not replace what somebody else has written, unless that is said", async () => {
    const { handle } = disk(5);
    expect(await save("<svg/>", at(handle, 1))).toEqual({ kind: "changed", reason: words.changedOnDisk("a.svg") });
    expect(fileSave).not.toHaveBeenCalled();
    fileSave.mockResolvedValue(handle);
    expect(await save("<svg/>", at(handle, 1), true)).toMatchObject({ kind: "saved" });
  });

  test("that is gone is reported", async () => {
    const { state, handle } = disk(1);
    state.gone = true;
    expect(await save("<svg/>", at(handle, 1))).toEqual({ kind: "problem", reason: words.gone });
  });

  test.each([
    ["NotAllowedError", words.notAllowed],
    ["SecurityError", words.notAllowed],
    ["NotFoundError", words.gone],
    ["QuotaExceededError", words.diskFull],
    ["NoModificationAllowedError", words.diskRefused],
    ["InvalidStateError", words.diskRefused],
  ])("that fails with %s is reported", async (name, reason) => {
    fileSave.mockRejectedValue(new DOMException("", name));
    expect(await save("<svg/>", at(disk(1).handle, 1))).toEqual({ kind: "problem", reason });
  });
});

describe("saving under a name", () => {
  test("gives the place that was chosen", async () => {
    const { handle } = disk(3);
    fileSave.mockResolvedValue(handle);
    const saved = await save("<svg/>", newPlace("b.xml"));
    expect(fileSave.mock.calls[0][1].fileName).toBe("b.svg");
    expect(saved).toMatchObject({ kind: "saved", place: { name: "a.svg", target: { kind: "handle", modified: 3 } } });
  });

  test("downloads where there is no dialog", async () => {
    fileSave.mockResolvedValue(null);
    expect(await saveAs("<svg/>", newPlace("b"))).toMatchObject({ kind: "downloaded", place: { name: "b.svg", target: { kind: "none" } } });
  });

  test("that is left changes nothing", async () => {
    fileSave.mockRejectedValue(new DOMException("", "AbortError"));
    expect(await saveAs("<svg/>", newPlace("b"))).toEqual({ kind: "cancelled" });
    expect(await saveExport(Promise.resolve(new Blob()), "a.png", "image/png")).toBe(false);
  });

  test("of what could not be made says why", async () => {
    fileSave.mockImplementation((blob: Promise<Blob>) => blob);
    const failed = saveExport(fails("too large"), "a.png", "image/png");
    await expect(failed).rejects.toThrow("too large");
  });
});

test("names take an extension in the place of their own", () => {
  expect(withExtension("a.svg", "png")).toBe("a.png");
  expect(withExtension("a.b.SVGZ", "html")).toBe("a.b.html");
  expect(withExtension("v1.5", "svg")).toBe("v1.5.svg");
  expect(withExtension(".svg", "svg")).toBe(".svg.svg");
});

describe("under `sfumato edit`", () => {
  const ask = vi.fn<(url: URL, init: RequestInit) => Promise<Response>>();
  beforeEach(() => {
    ask.mockReset();
    vi.stubGlobal("fetch", ask);
    const querySelector = () => ({ content: "a.svg" });
    vi.stubGlobal("document", { baseURI: "http://127.0.0.1:9/secret/", querySelector });
  });
  afterEach(() => vi.unstubAllGlobals());
  const convert = () => Promise.reject(new Error("none"));
  const place: Place = { name: "a.svg", form: plainForm, target: { kind: "served", tag: '"1"' } };

  test("the drawing is opened with its version", async () => {
    ask.mockResolvedValue(new Response("<svg/>", { headers: { ETag: '"4"' } }));
    expect(servedName()).toBe("a.svg");
    const opened = await openServed("a.svg", convert);
    expect(opened).toMatchObject({ kind: "drawing", text: "<svg/>", place: { target: { kind: "served", tag: '"4"' } } });
    expect(String(ask.mock.calls[0][0])).toBe("http://127.0.0.1:9/secret/drawing");
  });

  test("saving names the version that it replaces", async () => {
    ask.mockResolvedValue(new Response(null, { status: 204, headers: { ETag: '"2"' } }));
    expect(await save("<svg/>", place)).toMatchObject({ kind: "saved", place: { target: { tag: '"2"' } } });
    expect(ask.mock.calls[0][1]).toMatchObject({ method: "PUT", headers: { "If-Match": '"1"' } });
    await save("<svg/>", place, true);
    expect(ask.mock.calls[1][1]).toMatchObject({ headers: { "If-Match": "*" } });
  });

  test("a file that has changed is reported, and a command that has ended", async () => {
    ask.mockResolvedValue(new Response("x", { status: 412 }));
    expect(await save("<svg/>", place)).toEqual({ kind: "changed", reason: words.changedOnDisk("a.svg") });
    ask.mockResolvedValue(new Response("no space left\n", { status: 500 }));
    expect(await save("<svg/>", place)).toEqual({ kind: "problem", reason: words.commandRefused("no space left") });
    ask.mockRejectedValue(new TypeError("failed to fetch"));
    expect(await save("<svg/>", place)).toEqual({ kind: "problem", reason: words.commandEnded });
    expect(await openServed("a.svg", convert)).toEqual({ kind: "problem", reason: words.commandEnded });
  });

  test("files beside the drawing are asked for by their whole name", async () => {
    ask.mockResolvedValue(new Response("x", { status: 404 }));
    expect(await besideServed.bytes("../a b.png?&#")).toBeNull();
    expect(String(ask.mock.calls[0][0])).toBe("http://127.0.0.1:9/secret/file?..%2Fa%20b.png%3F%26%23");
  });
});
