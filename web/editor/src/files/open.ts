// Reads a dropped or chosen file as a drawing or a photo to trace over. The bytes decide the file's type.
import { fileOpen } from "browser-fs-access";
import type { FileWithHandle } from "browser-fs-access";
import { complaintOf } from "../engine/complaint.js";
import * as en from "../strings/en.js";
import type { Place } from "./place.js";
import { withExtension } from "./place.js";
import { FileProblem, mostTextBytes, plainForm, textOf } from "./text.js";

const words = en.files;

export interface Photo {
  readonly kind: "photo";
  readonly blob: Blob;
  readonly name: string;
  /** Pixels, turned as its camera said. */
  readonly width: number;
  readonly height: number;
}

export interface OpenedDrawing {
  readonly kind: "drawing";
  readonly text: string;
  readonly place: Place;
  /** The text is not the file's, which must not be written over. */
  readonly isConverted?: true;
}

export type Opened =
  | OpenedDrawing
  | Photo
  | { readonly kind: "problem"; readonly reason: string };

/** Orzan's XML as SVG; Engine.convert. */
export type Convert = (text: string) => Promise<string>;

/** Bytes of a file that is read at all: more is neither a drawing nor a photo. */
export const mostFileBytes = mostTextBytes;
const mostPhotoPixels = 100e6;

/** How files begin that a browser may decode. */
function isPicture(bytes: Uint8Array): boolean {
  const text = String.fromCharCode(...bytes.subarray(0, 12));
  return (
    text.startsWith("\x89PNG\r\n\x1a\n") ||
    text.startsWith("\xff\xd8\xff") ||
    /^GIF8[79]a/.test(text) ||
    /^RIFF[^]{4}WEBP/.test(text) ||
    /^[^]{4}ftyp(avi[fs]|hei[cfx]|mif1|msf1)/.test(text) ||
    /^(BM|II\*\0|MM\0\*|8BPS|\0\0\x01\0)/.test(text)
  );
}

async function openPhoto(blob: Blob, name: string): Promise<Photo> {
  const picture = await createImageBitmap(blob).catch(() => null);
  if (!picture) throw new FileProblem(words.undecodable(name));
  const { width, height } = picture;
  picture.close();
  if (width * height > mostPhotoPixels) throw new FileProblem(words.photoTooLarge(name));
  return { kind: "photo", blob, name, width, height };
}

/** The local name of the first element, behind comments and the like; "": there is none. */
export function rootName(text: string): string {
  const prolog = /^\ufeff?(?:\s+|<\?[^]*?\?>|<!--[^]*?-->|<!DOCTYPE(?:[^[>]|\[[^\]]*\])*>)*/.exec(text);
  return /^<(?:[^\s<>/:!?]+:)?([^\s<>/:!?]+)/.exec(text.slice(prolog ? prolog[0].length : 0))?.[1] ?? "";
}

async function read(file: File): Promise<Uint8Array<ArrayBuffer>> {
  if (file.size > mostFileBytes) throw new FileProblem(words.tooLarge(file.name));
  let bytes;
  try {
    bytes = new Uint8Array(await file.arrayBuffer());
  } catch {
    throw new FileProblem(words.unreadable(file.name));
  }
  if (bytes.length === 0) throw new FileProblem(words.empty(file.name));
  return bytes;
}

async function openBytes(bytes: Uint8Array<ArrayBuffer>, file: File, convert: Convert): Promise<Opened> {
  const { name } = file;
  if (isPicture(bytes)) return openPhoto(file, name);
  const { text, form } = await textOf(bytes, name);
  const root = rootName(text);
  if (root === "") throw new FileProblem(words.noDrawing(name));
  if (root === "svg") return { kind: "drawing", text, place: { name, form, target: { kind: "none" } } };
  // Orzan's XML becomes a new drawing: saving must not write SVG into that file.
  const svg = await convert(text).catch((error: unknown) => {
    throw new FileProblem(complaintOf(error));
  });
  const place = { name: withExtension(name, "svg"), form: plainForm, target: { kind: "none" } } as const;
  return { kind: "drawing", text: svg, place, isConverted: true };
}

/** @param handle saving writes to it, where it is an SVG */
export async function openFile(file: File, convert: Convert, handle: FileSystemFileHandle | null = null): Promise<Opened> {
  try {
    const opened = await openBytes(await read(file), file, convert);
    if (!handle || opened.kind !== "drawing" || opened.isConverted) return opened;
    const target = { kind: "handle", handle, modified: file.lastModified } as const;
    return { ...opened, place: { ...opened.place, target } };
  } catch (error) {
    if (error instanceof FileProblem) return { kind: "problem", reason: error.message };
    throw error;
  }
}

const drawings = { extensions: [".svg", ".svgz", ".xml"], mimeTypes: ["image/svg+xml"] };
const photos = {
  extensions: [".png", ".jpg", ".jpeg", ".webp", ".gif", ".avif"],
  mimeTypes: ["image/png", "image/jpeg", "image/webp", "image/gif", "image/avif"],
};

/** Asks for a file; null: the person chose none. @param what photos alone, or drawings and photos */
export async function pickFile(convert: Convert, what: "any" | "photo" = "any"): Promise<Opened | null> {
  const photo = { ...photos, description: words.photos };
  const any = {
    description: words.drawingsAndPhotos,
    extensions: [...drawings.extensions, ...photos.extensions],
    mimeTypes: [...drawings.mimeTypes, ...photos.mimeTypes],
    id: "sfumato",
  };
  let file: FileWithHandle;
  try {
    file = await fileOpen(what === "any" ? any : { ...photo, id: "sfumato-photo" });
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") return null;
    return { kind: "problem", reason: words.noPicker };
  }
  return openFile(file, convert, file.handle ?? null);
}
