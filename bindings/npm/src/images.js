// Pictures that a drawing names or holds, decoded by the browser before it is read.
import { decodeImage, imagesOf } from "../../../web/editor/src/files/images.ts";

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
 * Hands a context the pictures of a text. What is not there, or is no picture, the reader speaks of.
 * @param {import("../../../web/wasm/sfumato.mjs").SfumatoContext} context
 * @param {string | Uint8Array} text
 * @param {string | URL | undefined} base files beside the drawing are fetched where there is one
 * @returns {Promise<Map<string, Uint8Array>>} the files that came, by what the drawing calls them
 */
export async function addImages(context, text, base) {
  const words = typeof text === "string" ? text : new TextDecoder().decode(text);
  const files = new Map();
  if (!/<(?:[\w.-]+:)?image/.test(words)) return files;
  const { found } = await imagesOf(words, { bytes: (href) => fetched(href, base) });
  for (const { href, bytes } of found) {
    files.set(href, bytes);
    const pixels = await decodeImage(bytes);
    if (pixels) context.addImage(bytes, pixels);
  }
  return files;
}
