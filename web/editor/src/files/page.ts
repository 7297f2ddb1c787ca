// The page of the viewer that `sfumato render -o page.html` writes, with another picture in it.
import type { Pixels } from "./images.js";

export interface PageParts {
  readonly title: string;
  /** The picture for a browser without WebGL 2, an address "data:image/jpeg;base64,…"; null: none. */
  readonly fallback: string | null;
  /** Engine.payload(). */
  readonly payload: Uint8Array<ArrayBuffer>;
}

const names: Readonly<Record<string, string>> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };

/** Text as the content of an element or an attribute in double quotes; controls become blanks. */
export const escapedHtml = (text: string): string =>
  text.replace(/[\0-\x1f]/g, " ").replace(/[&<>"]/g, (c) => names[c]);

/** Base64 of bytes of any number. */
export async function base64Of(bytes: Blob): Promise<string> {
  const uri = await new Promise<string>((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(bytes);
  });
  return uri.slice(uri.indexOf(",") + 1);
}

/** In zlib's format. */
export function deflated(bytes: Uint8Array<ArrayBuffer>): Promise<Blob> {
  return new Response(new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"))).blob();
}

/** The page's text, with its marks replaced; what replaces them is not looked through. */
export async function pageOf(template: string, parts: PageParts): Promise<string> {
  const title = escapedHtml(parts.title);
  const fallback = parts.fallback === null ? "" : `<img id="fallback" alt="${title}" src="${escapedHtml(parts.fallback)}">`;
  const payload = await base64Of(await deflated(parts.payload));
  const values: Readonly<Record<string, string>> = { title, fallback, payload };
  return template.replace(/\{\{(title|fallback|payload)\}\}/g, (_, name: string) => values[name]);
}

/** A JPEG of pixels as a data: URI; null: this browser makes none. */
export async function jpegUri({ width, height, data }: Pixels): Promise<string | null> {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d");
  if (!context) return null;
  context.putImageData(new ImageData(new Uint8ClampedArray(data), width, height), 0, 0);
  const blob = await canvas.convertToBlob({ type: "image/jpeg", quality: 0.8 }).catch(() => null);
  return blob?.type === "image/jpeg" ? `data:image/jpeg;base64,${await base64Of(blob)}` : null;
}
