// Decodes, in the browser, the pictures that a drawing names or contains, before the drawing is read.
import { bytesOfDataUri, decodeImage, imagesOf } from "../../../web/editor/src/files/images.ts";

/** A picture of one transparent pixel, for one that is left out. */
const transparent =
  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAAC0lEQVR42mNgAAIAAAUAAen63NgAAAAASUVORK5CYII=";

/**
 * @param {string} href
 * @param {string | URL | undefined} base the drawing's address
 */
async function fetched(href, base) {
  if (base === undefined) return null;
  try {
    const answer = await fetch(new URL(href, base));
    return answer.ok ? new Uint8Array(await answer.arrayBuffer()) : null;
  } catch {
    return null;
  }
}

/**
 * Adds the pictures of a text to a context. The reader refuses a drawing with a picture that is missing or
 * unreadable, unless `leaveOut` is given.
 * @param {import("../../../web/wasm/sfumato.mjs").SfumatoContext} context
 * @param {string | Uint8Array} text
 * @param {string | URL | undefined} base address for fetching files beside the drawing; none: they are not fetched
 * @param {((href: string) => void) | null} leaveOut called for such a picture, which becomes transparent
 * @returns {Promise<Map<string, Uint8Array>>} the fetched files, by their names in the drawing
 */
export async function addImages(context, text, base, leaveOut = null) {
  const words = typeof text === "string" ? text : new TextDecoder().decode(text);
  const files = new Map();
  if (!/<(?:[\w.-]+:)?image/.test(words)) return files;
  const { found, missing: absent } = await imagesOf(words, { bytes: (href) => fetched(href, base) });
  const missing = [...absent];
  for (const { href, bytes } of found) {
    files.set(href, bytes);
    const pixels = await decodeImage(bytes);
    if (pixels) context.addImage(bytes, pixels);
    else missing.push(href);
  }
  if (!leaveOut) return files;
  const nothing = bytesOfDataUri(transparent);
  if (missing.length > 0) context.addImage(nothing, { width: 1, height: 1, data: new Uint8Array(4) });
  for (const href of missing) {
    files.set(href, nothing);
    leaveOut(href);
  }
  return files;
}
