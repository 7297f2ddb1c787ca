// Exports of a drawing: PNG, SVG, PDF, and the HTML of the viewer.
import type { Box } from "../geometry/affine.js";
import type { Exporter } from "../engine/other-text.js";
import { encodePng } from "../engine/png.js";
import { parse } from "../source/parse.js";
import type { ElementNode } from "../source/tree.js";
import * as en from "../strings/en.js";
import { deflated, jpegUri, pageOf } from "./page.js";
import { withExtension } from "./place.js";

const words = en.files;

/** The export to write. */
export interface ExportWish {
  /** "plain": SVG for programs that know no diffusion curves. */
  readonly format: "svg" | "png" | "html" | "pdf" | "plain";
  /** Pixels; of PNG alone. */
  readonly width: number;
  readonly height: number;
  /** The part of the artboard's plane that is written, artboard units; of PNG, PDF and plain SVG. */
  readonly viewport: Box;
  /** Without the document's background; of PNG, PDF and plain SVG. */
  readonly transparent: boolean;
  /** Whether SVG keeps the photo that is traced over. */
  readonly keepReference: boolean;
  /** Bits of a channel; of PNG alone. */
  readonly depth?: 8 | 16;
  /** Whether only the selected layers and other outermost objects are drawn; not of SVG. */
  readonly isSelectionOnly?: boolean;
  /** Whether plain SVG holds triangles, or an image. */
  readonly plain?: "vectors" | "pixels";
}

/** The drawing that is exported. */
export interface ExportSource {
  readonly engine: Exporter;
  readonly text: string;
  /** Name of the drawing's file, or its title. */
  readonly name: string;
  /** The whole artboard. */
  readonly artboard: Box;
}

export interface ExportWatch {
  /** "draw": the engine works, "pack": the file is made. */
  readonly onStage?: (stage: "draw" | "pack") => void;
  /** Differences between the file and the drawing. */
  readonly onNotes?: (notes: readonly string[]) => void;
  readonly signal?: AbortSignal;
}

export const exportTypes = {
  svg: "image/svg+xml",
  png: "image/png",
  html: "text/html",
  pdf: "application/pdf",
  plain: "image/svg+xml",
} as const;

/** Returns the name of an export's file. A plain SVG must not replace the drawing's own file. */
export function exportName({ format }: Pick<ExportWish, "format">, name: string): string {
  return format === "plain" ? withExtension(name, "svg").replace(/\.svg$/, "-plain.svg") : withExtension(name, format);
}

/** Limits of a PNG: the command's limit of a side, and bytes of pixels, which are in memory thrice. */
export const mostSide = 16384;
export const mostPixelBytes = 512 * 2 ** 20;

const bytesPerPixel = (wish: ExportWish) => ((wish.depth ?? 8) === 16 ? 8 : 4);

/** Returns the problem with a size as text; null: none. */
export function complaintAboutSize(wish: ExportWish): string | null {
  const { width, height } = wish;
  const isWhole = Number.isInteger(width) && Number.isInteger(height) && width > 0 && height > 0;
  if (!isWhole) return words.badSize;
  if (Math.max(width, height) > mostSide) return words.sideTooLong(mostSide);
  return width * height * bytesPerPixel(wish) > mostPixelBytes ? words.pictureTooLarge : null;
}

/** Returns the result of a call, unless the signal aborts first. */
function unlessAborted<Value>(work: Promise<Value>, signal?: AbortSignal): Promise<Value> {
  if (!signal) return work;
  signal.throwIfAborted();
  return new Promise((resolve, reject) => {
    signal.addEventListener("abort", () => reject(signal.reason), { once: true });
    work.then(resolve, reject);
  });
}

async function exportPng(wish: ExportWish, { engine }: ExportSource, watch: ExportWatch): Promise<Blob> {
  const complaint = complaintAboutSize(wish);
  if (complaint !== null) throw new Error(complaint);
  const { width, height, viewport } = wish;
  const background = wish.transparent ? "none" : null;
  watch.onStage?.("draw");
  const drawing = engine.raster({ width, height, viewport, background, depth: wish.depth ?? 8 });
  const data = await unlessAborted(drawing, watch.signal);
  watch.onStage?.("pack");
  return new Blob([await encodePng({ width, height, data }, watch.signal)], { type: exportTypes.png });
}

const sfumato = "urn:sfumato:1";

function* references(element: ElementNode): Generator<ElementNode> {
  const isReference = element.attributes.some(
    ({ local, namespace, value }) => local === "reference" && namespace === sfumato && value === "true",
  );
  if (element.local === "image" && isReference) yield element;
  else for (const child of element.children) yield* references(child);
}

/** A text without the photos that are traced over, and the lines that were theirs alone. @throws SourceError */
export function withoutReference(text: string): string {
  const parts: string[] = [];
  let at = 0;
  for (const { range } of references(parse(text))) {
    const before = text.slice(at, range.start);
    const hasOwnLine = /\n[ \t]*$/.test(before) && /^[ \t]*(\r?\n|$)/.test(text.slice(range.end, range.end + 80));
    parts.push(hasOwnLine ? before.replace(/\r?\n[ \t]*$/, "") : before);
    at = range.end;
  }
  return parts.join("") + text.slice(at);
}

/** The longer side of the picture for browsers without WebGL 2, as in the command. */
const fallbackSide = 640;

function smallWish({ artboard }: ExportSource): ExportWish {
  const [left, top, right, bottom] = artboard;
  const scale = fallbackSide / Math.max(right - left, bottom - top);
  const pixels = (length: number) => Math.max(1, Math.round(length * scale));
  const size = { width: pixels(right - left), height: pixels(bottom - top) };
  return { format: "png", ...size, viewport: artboard, transparent: false, keepReference: false };
}

async function fallbackOf(source: ExportSource): Promise<string | null> {
  const { width, height, viewport } = smallWish(source);
  const data = await source.engine.raster({ width, height, viewport, background: null, depth: 8 });
  return data instanceof Uint16Array ? null : jpegUri({ width, height, data });
}

const titleOf = ({ name }: ExportSource) => name.replace(/\.(svgz?|xml)$/i, "");

async function exportHtml(source: ExportSource, watch: ExportWatch): Promise<Blob> {
  watch.onStage?.("draw");
  const { default: template } = await import("../../../viewer/dist/page.html?raw");
  const payload = new Uint8Array(await unlessAborted(source.engine.payload(), watch.signal));
  const fallback = await unlessAborted(fallbackOf(source), watch.signal);
  watch.onStage?.("pack");
  const page = await unlessAborted(pageOf(template, { title: titleOf(source), fallback, payload }), watch.signal);
  return new Blob([page], { type: exportTypes.html });
}

async function exportFile(wish: ExportWish, source: ExportSource, watch: ExportWatch): Promise<Blob> {
  const isPdf = wish.format === "pdf";
  const isVectors = !isPdf && wish.plain !== "pixels";
  const own: Record<string, string> = isPdf ? { title: titleOf(source) } : { svg: isVectors ? "vector" : "image" };
  const options = wish.transparent ? { ...own, background: "none" } : own;
  watch.onStage?.("draw");
  const format = isPdf ? "pdf" : "svg";
  const writing = source.engine.write({ format, viewport: wish.viewport, options, detail: isVectors ? 1 : 2 });
  const { bytes, warnings } = await unlessAborted(writing, watch.signal);
  watch.onNotes?.(warnings);
  return new Blob([bytes], { type: exportTypes[wish.format] });
}

/** Returns the file that a wish describes. @throws Error in words; the signal's reason */
export function exportDrawing(wish: ExportWish, source: ExportSource, watch: ExportWatch = {}): Promise<Blob> {
  if (wish.format === "png") return exportPng(wish, source, watch);
  if (wish.format === "html") return exportHtml(source, watch);
  if (wish.format === "pdf" || wish.format === "plain") return exportFile(wish, source, watch);
  return svgOf(wish, source).then((text) => new Blob([text], { type: exportTypes.svg }));
}

// Async, so that what parse() throws is a promise's affair.
const svgOf = async (wish: ExportWish, { text }: ExportSource) =>
  wish.keepReference ? text : withoutReference(text);

/** Pixels of the picture that an estimate is made from. */
const sampledPixels = 256 * 256;

async function estimatePng(wish: ExportWish, source: ExportSource): Promise<number> {
  const share = Math.min(1, Math.sqrt(sampledPixels / (wish.width * wish.height)));
  const size = { width: Math.ceil(wish.width * share), height: Math.ceil(wish.height * share) };
  const blob = await exportPng({ ...wish, ...size }, source, {});
  return Math.round((blob.size * wish.width * wish.height) / (size.width * size.height));
}

/** Returns the approximate size of the file in bytes; null: unknown. */
export async function estimateSize(wish: ExportWish, source: ExportSource): Promise<number | null> {
  try {
    if (wish.format === "svg") return new Blob([await svgOf(wish, source)]).size;
    if (wish.format === "pdf" || wish.format === "plain") return null;
    if (wish.format === "png") return complaintAboutSize(wish) === null ? await estimatePng(wish, source) : null;
    const { default: template } = await import("../../../viewer/dist/page.html?raw");
    const payload = await deflated(new Uint8Array(await source.engine.payload()));
    const fallback = await fallbackOf(source);
    return template.length + Math.ceil((payload.size * 4) / 3) + (fallback?.length ?? 0);
  } catch {
    return null;
  }
}

type Size = Pick<ExportWish, "width" | "height">;

/** Returns the name of one of several sizes of a picture: "a.png", "a@2x.png", or "a-300x200.png" for other sizes. */
export function nameOfSize(name: string, { width, height }: Size, natural: Size): string {
  const scale = width / natural.width;
  const isWhole = Number.isInteger(scale) && height === natural.height * scale;
  const suffix = !isWhole ? `-${width}x${height}` : scale === 1 ? "" : `@${scale}x`;
  return withExtension(name, "png").replace(/\.png$/, `${suffix}.png`);
}

/** The picture to the clipboard; to be called while a click is handled. @throws Error in words */
export async function copyPng(wish: ExportWish, source: ExportSource, watch: ExportWatch = {}): Promise<void> {
  if (!("ClipboardItem" in globalThis) || !navigator.clipboard?.write) throw new Error(words.noClipboard);
  const png = exportDrawing({ ...wish, format: "png" }, source, watch);
  // Handed over as a promise, since browsers forget the click while the picture is drawn.
  const item = new ClipboardItem({ [exportTypes.png]: png });
  await navigator.clipboard.write([item]).catch(async (error: unknown) => {
    await png;
    throw error instanceof DOMException ? new Error(words.clipboardRefused) : error;
  });
}
