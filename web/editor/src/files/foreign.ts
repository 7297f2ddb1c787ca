// SVG of other programs, which has shapes but no diffusion curves.
import { isOfSfumato, SFUMATO, SVG } from "../source/attributes.js";
import { parse } from "../source/parse.js";
import { SourceError, type ElementNode } from "../source/tree.js";

/** Elements that other programs show. */
const NAMES = ["circle", "ellipse", "image", "line", "path", "polygon", "polyline", "rect", "text", "use"];
const SHOWN = new Set(NAMES);
const SHOWN_TAG = new RegExp(`<(?:[\\w.-]+:)?(?:${NAMES.join("|")})[\\s/>]`);

/** Longer texts are searched, not parsed, because parsing would stop the page for many seconds; characters. */
const LONG = 4e6;

function* within(element: ElementNode): Generator<ElementNode> {
  yield element;
  for (const child of element.children) yield* within(child);
}

/** Returns whether a text is SVG with visible content and without Sfumato's attributes, except the version. */
export function isForeign(text: string): boolean {
  if (text.length > LONG) return !text.includes(SFUMATO) && SHOWN_TAG.test(text);
  let isShowing = false;
  try {
    for (const element of within(parse(text))) {
      if (isOfSfumato(element)) return false;
      const { local, namespace } = element;
      isShowing ||= (namespace === SVG || namespace === "") && SHOWN.has(local);
    }
  } catch (error) {
    // Opening the file reports the error.
    if (error instanceof SourceError) return false;
    throw error;
  }
  return isShowing;
}
