// The pictures that a drawing names as textures, as bytes and as pixels for SfumatoContext.addImage.

/** Files that lie beside a drawing, as far as the person or the command has granted them. */
export interface Beside {
  /** @param href as written in the drawing, relative to its folder; null: the file is missing */
  bytes(href: string): Promise<Uint8Array<ArrayBuffer> | null>;
}

export const nothingBeside: Beside = { bytes: () => Promise.resolve(null) };

const read = async (file: File) => new Uint8Array(await file.arrayBuffer());

/** The parts of a relative path; null: it leads elsewhere. */
export function partsOf(href: string): readonly string[] | null {
  if (/^([a-z][a-z0-9+.-]*:|[/\\])/i.test(href)) return null;
  const parts: string[] = [];
  for (const part of href.split("/")) {
    if (part === "" || part === ".") continue;
    if (part !== "..") parts.push(part);
    else if (parts.pop() === undefined) return null;
  }
  return parts.length === 0 ? null : parts;
}

/** Where a file of a chosen folder lies in it; of another, its name: its folder is not known. */
const placeOf = ({ webkitRelativePath, name }: File) =>
  webkitRelativePath ? webkitRelativePath.slice(webkitRelativePath.indexOf("/") + 1) : name;

/** Files that were dropped with the drawing, found by name, or files of a chosen folder, found by path. */
export function besideFiles(files: readonly File[]): Beside {
  const byPlace = new Map(files.map((file) => [placeOf(file), file]));
  const hasFolder = files.some(({ webkitRelativePath }) => webkitRelativePath);
  return {
    async bytes(href) {
      const parts = partsOf(href);
      const file = byPlace.get((hasFolder ? parts?.join("/") : parts?.at(-1)) ?? "");
      return file ? read(file).catch(() => null) : null;
    },
  };
}

/** The drawing's folder, which the person has chosen. */
export function besideFolder(folder: FileSystemDirectoryHandle): Beside {
  return {
    async bytes(href) {
      const parts = partsOf(href);
      if (!parts) return null;
      try {
        let at = folder;
        for (const part of parts.slice(0, -1)) at = await at.getDirectoryHandle(part);
        return await read(await (await at.getFileHandle(parts[parts.length - 1])).getFile());
      } catch {
        return null;
      }
    },
  };
}

export interface DrawingImage {
  readonly href: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

export interface DrawingImages {
  readonly found: readonly DrawingImage[];
  /** Names of files that are not there. */
  readonly missing: readonly string[];
}

const entities: Readonly<Record<string, string>> = { amp: "&", lt: "<", gt: ">", quot: '"', apos: "'" };

function decoded(value: string): string {
  return value.replace(/&(?:#x([0-9a-f]{1,6})|#(\d{1,7})|(amp|lt|gt|quot|apos));/gi, (whole, hex, decimal, name) => {
    if (name) return entities[name] ?? whole;
    const code = hex ? parseInt(hex, 16) : parseInt(decimal, 10);
    return code <= 0x10ffff ? String.fromCodePoint(code) : whole;
  });
}

// The slash is escaped because Vite 5 reads this line in the npm package, and would otherwise end the expression there.
const attribute = /\s*(?:([^\s=<>"'\/]+)\s*=\s*(["'])|\/)/y;

/** The href of a start tag whose attributes begin at `at`, whatever its prefix. Strings are skipped at once: they may be long. */
function hrefAt(text: string, at: number): string | null {
  let href: string | null = null;
  for (attribute.lastIndex = at; ; ) {
    const match = attribute.exec(text);
    if (!match) return href;
    const [, name, quote] = match;
    if (quote === undefined) continue;
    const begin = attribute.lastIndex;
    const end = text.indexOf(quote, begin);
    if (end < 0) return null;
    if (/^(?:[^:]+:)?href$/.test(name)) href = decoded(text.slice(begin, end)).trim();
    attribute.lastIndex = end + 1;
  }
}

/**
 * Returns the addresses in the <image> elements of a text, each once, in order. An <image> in a comment only
 * costs time.
 */
export function hrefsOf(text: string): readonly string[] {
  const hrefs = new Set<string>();
  const tag = /<(?:[\w.-]{1,100}:)?image(?=[\s/])/g;
  while (tag.exec(text)) {
    const href = hrefAt(text, tag.lastIndex);
    if (href !== null && href !== "" && !href.startsWith("#")) hrefs.add(href);
  }
  return [...hrefs];
}

/** Percent escapes as bytes, one character each. */
const bytesText = (text: string) =>
  text.replace(/%([0-9a-f]{2})/gi, (_, hex: string) => String.fromCharCode(parseInt(hex, 16)));

/** The bytes of a data: URI; null: it is none. */
export function bytesOfDataUri(uri: string): Uint8Array<ArrayBuffer> | null {
  const match = /^data:([^,]*),([^]*)$/i.exec(uri);
  if (!match) return null;
  try {
    const isBase64 = /;\s*base64\s*$/i.test(match[1]);
    const text = isBase64 ? atob(match[2].replace(/\s+/g, "")) : bytesText(match[2]);
    return Uint8Array.from(text, (c) => c.charCodeAt(0));
  } catch {
    return null;
  }
}

/**
 * The files that a drawing names or holds. Nothing is fetched: an address of another site is missing.
 * @param isWanted which of them
 */
export async function imagesOf(
  text: string,
  beside: Beside = nothingBeside,
  isWanted: (href: string) => boolean = () => true,
): Promise<DrawingImages> {
  const found: DrawingImage[] = [];
  const missing: string[] = [];
  for (const href of hrefsOf(text).filter(isWanted)) {
    const bytes = bytesOfDataUri(href) ?? (await beside.bytes(href));
    if (bytes) found.push({ href, bytes });
    else missing.push(href);
  }
  return { found, missing };
}

export interface Pixels {
  readonly width: number;
  readonly height: number;
  /** RGBA, not premultiplied, as the file has them: no colour profile, no turning. */
  readonly data: Uint8ClampedArray<ArrayBuffer> | Uint8Array<ArrayBuffer>;
}

/** Texels that the engine takes. */
const mostTexels = 64e6;

/** Decodes a picture, in a page or a worker; null: no browser does, or it is too large for the engine. */
export async function decodeImage(bytes: Uint8Array<ArrayBuffer>): Promise<Pixels | null> {
  const picture = await createImageBitmap(new Blob([bytes]), {
    colorSpaceConversion: "none",
    premultiplyAlpha: "none",
    imageOrientation: "none",
  }).catch(() => null);
  if (!picture) return null;
  try {
    if (picture.width * picture.height > mostTexels) return null;
    return pixelsByGl(picture) ?? pixelsByCanvas(picture);
  } finally {
    picture.close();
  }
}

/** By a texture, which keeps what is behind alpha; null: there is no WebGL, or the picture is too large. */
function pixelsByGl(picture: ImageBitmap): Pixels | null {
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  const { width, height } = picture;
  if (!gl || Math.max(width, height) > gl.getParameter(gl.MAX_TEXTURE_SIZE)) return null;
  try {
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
    return readTexture(gl, width, height);
  } finally {
    gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}

function readTexture(gl: WebGL2RenderingContext, width: number, height: number): Pixels | null {
  const texture: WebGLTexture | null = gl.getParameter(gl.TEXTURE_BINDING_2D);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) return null;
  const data = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return gl.getError() === gl.NO_ERROR ? { width, height, data } : null;
}

/** By a canvas, which loses what little alpha shows; the same where the picture is opaque. */
function pixelsByCanvas(picture: ImageBitmap): Pixels | null {
  const { width, height } = picture;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) return null;
  context.drawImage(picture, 0, 0);
  return { width, height, data: context.getImageData(0, 0, width, height).data };
}
