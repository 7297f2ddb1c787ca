import { afterEach, describe, expect, test, vi } from "vitest";
import { chooseFolder } from "../../../../web/editor/src/files/folder.js";
import { besideFiles, besideFolder, bytesOfDataUri, hrefsOf, imagesOf, partsOf } from "../../../../web/editor/src/files/images.js";

const bytes = (text: string) => Uint8Array.from(text, (c) => c.charCodeAt(0));

const directoryOpen = vi.hoisted(() => vi.fn());
vi.mock("browser-fs-access", () => ({ directoryOpen }));

test("images are found however they are written", () => {
  const text = `<svg><!-- <IMAGE href="no"/> -->
    <image href="a.png"/><svg:image xlink:href='b c.png' width=">"/><image
      height="/>" href = "d&amp;e&#x41;&#66;.png"></image><image href="a.png"/>
    <image href="#frag"/><image href=""/><image data-href="no.png"/><images href="no.png"/><use href="no.svg"/></svg>`;
  expect(hrefsOf(text)).toEqual(["a.png", "b c.png", "d&eAB.png"]);
});

// With a quadratic search, this would take minutes.
test("text that is no XML is looked through once", () => {
  const long = "x".repeat(2e6);
  expect(hrefsOf(`<image href="${long}"/><image href='b'/>`)).toEqual([long, "b"]);
  for (const piece of ["<image ", "<image x", '<image a="', "<image a='<image b=\"", "<", "<a:", '<image a="b" ']) {
    expect(hrefsOf(piece.repeat(4e5 / piece.length))).toEqual([]);
  }
  expect(hrefsOf(`<image href="${long}`)).toEqual([]);
});

test("data URIs are decoded, and nothing else is", () => {
  expect(bytesOfDataUri("data:image/png;base64,iVBO\n Rw==")).toEqual(bytes("\x89PNG"));
  expect(bytesOfDataUri("data:;base64,")).toEqual(bytes(""));
  expect(bytesOfDataUri("data:text/plain,a%20%FF%zz")).toEqual(bytes("a \xff%zz"));
  expect(bytesOfDataUri("data:image/png;base64,%%%")).toBeNull();
  expect(bytesOfDataUri("a.png")).toBeNull();
});

test("paths that lead out of the folder are none", () => {
  expect(partsOf("a/./b//c.png")).toEqual(["a", "b", "c.png"]);
  expect(partsOf("a/../b.png")).toEqual(["b.png"]);
  for (const href of ["../a", "a/../../b", "/a", "\\a", "c:a", "file:///a", "http://a/b", "", ".", "a/.."]) {
    expect(partsOf(href)).toBeNull();
  }
});

describe("files beside a drawing", () => {
  const file = new File(["pixels"], "t.png");

  test("that came with it are known by name", async () => {
    const beside = besideFiles([file]);
    expect(await beside.bytes("maps/t.png")).toEqual(bytes("pixels"));
    expect(await beside.bytes("u.png")).toBeNull();
    expect(await beside.bytes("https://example.org/t.png")).toBeNull();
  });

  test("of its folder are found by their path", async () => {
    const asked: string[] = [];
    const folder = (path: string): FileSystemDirectoryHandle =>
      ({
        getDirectoryHandle: async (name: string) => folder(`${path}${name}/`),
        getFileHandle: async (name: string) => {
          asked.push(path + name);
          if (path + name !== "maps/t.png") throw new DOMException("", "NotFoundError");
          return { getFile: async () => file };
        },
      }) as unknown as FileSystemDirectoryHandle;
    const beside = besideFolder(folder(""));
    expect(await beside.bytes("maps/t.png")).toEqual(bytes("pixels"));
    expect(await beside.bytes("t.png")).toBeNull();
    expect(await beside.bytes("../t.png")).toBeNull();
    expect(asked).toEqual(["maps/t.png", "t.png"]);
  });

  test("of a folder that was listed are found by their path, not by their name", async () => {
    const listed = (path: string) => Object.defineProperty(new File([path], "t.png"), "webkitRelativePath", { value: path });
    const beside = besideFiles([listed("art/a/t.png"), listed("art/b/t.png")]);
    expect(await beside.bytes("a/t.png")).toEqual(bytes("art/a/t.png"));
    expect(await beside.bytes("./b/../a/t.png")).toEqual(bytes("art/a/t.png"));
    expect(await beside.bytes("t.png")).toBeNull();
  });

  test("are named where they are missing", async () => {
    const text = '<image href="data:,x"/><image href="t.png"/><image href="http://a/t.png"/>';
    expect(await imagesOf(text, besideFiles([]))).toEqual({
      found: [{ href: "data:,x", bytes: bytes("x") }],
      missing: ["t.png", "http://a/t.png"],
    });
  });
});

describe("a folder", () => {
  afterEach(() => vi.unstubAllGlobals());
  const left = () => Promise.reject(new DOMException("", "AbortError"));

  test("is asked for as a handle where that is possible, else as a list", async () => {
    const getFileHandle = async () => ({ getFile: async () => new File(["handle"], "t.png") });
    directoryOpen.mockResolvedValue([new File(["list"], "t.png")]);
    expect(await (await chooseFolder())?.bytes("t.png")).toEqual(bytes("list"));
    vi.stubGlobal("showDirectoryPicker", async () => ({ getFileHandle }));
    expect(await (await chooseFolder())?.bytes("t.png")).toEqual(bytes("handle"));
  });

  test("that the person did not choose is none", async () => {
    directoryOpen.mockImplementation(left);
    expect(await chooseFolder()).toBeNull();
    vi.stubGlobal("showDirectoryPicker", left);
    expect(await chooseFolder()).toBeNull();
  });
});
