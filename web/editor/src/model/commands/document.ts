// Attributes of layers, groups and the document itself.
import type { Rgb } from "../../geometry/color.js";
import { numberText } from "../../geometry/path.js";
import { setAttribute, sf, SODIPODI, valueOf } from "../../source/attributes.js";
import { colorText } from "../../source/colors.js";
import { keywordOf, shareOf } from "../../source/css.js";
import { parse } from "../../source/parse.js";
import { applied, type Edit } from "../../source/patch.js";
import { setStyle, setStyles } from "../../source/set-style.js";
import { BLEND_MODES, Styles } from "../../source/styles.js";
import type { Property } from "../../source/styles.js";
import type { ElementNode } from "../../source/tree.js";
import { readArtboard } from "../artboard.js";
import { guidelinesOf } from "../guidelines.js";
import type { Drawing, Handle, Outcome } from "../types.js";
import { guidesKept } from "./guidelines.js";
import { outcomeOf } from "./structure/together.js";

export { rename } from "./structure/naming.js";

/** Edits of each of some items. */
function ofEach(
  d: Drawing,
  handles: readonly Handle[],
  edits: (element: ElementNode) => readonly Edit[],
): Outcome | null {
  return outcomeOf(
    [...new Set(handles)].flatMap((handle) => {
      const element = d.item(handle)?.element;
      return element ? edits(element) : [];
    }),
  );
}

function isShown(styles: Styles, element: ElementNode, property: "display" | "visibility") {
  const word = keywordOf(styles.value(element, property) ?? "");
  return property === "display" ? word !== "none" : word === null || word === "visible";
}

/** The value that shows an element: none of its own where then it is shown, else `shown`. */
function showing(
  styles: Styles,
  element: ElementNode,
  property: "display" | "visibility",
  shown: string,
): Partial<Record<Property, string | null>> {
  if (isShown(styles, element, property)) return {};
  const inherited = property === "visibility" && element.parent;
  const isHiddenElsewhere =
    styles.inSheets(element, property) !== null ||
    (inherited && !isShown(styles, inherited, property));
  return { [property]: isHiddenElsewhere ? shown : null };
}

/** By `display`; what is hidden by `visibility` is shown too. */
export function setHidden(d: Drawing, handles: readonly Handle[], hidden: boolean): Outcome | null {
  const styles = new Styles(d.text, d.root);
  return ofEach(d, handles, (element) => {
    if (!hidden) {
      return setStyles(d.text, styles, element, {
        ...showing(styles, element, "display", "inline"),
        ...showing(styles, element, "visibility", "visible"),
      });
    }
    const isHidden =
      !isShown(styles, element, "display") || !isShown(styles, element, "visibility");
    return isHidden ? [] : setStyle(d.text, styles, element, "display", "none");
  });
}

/** As Inkscape locks: sodipodi:insensitive. */
export function setLocked(d: Drawing, handles: readonly Handle[], locked: boolean): Outcome | null {
  const insensitive = { namespace: SODIPODI, local: "insensitive" };
  return ofEach(d, handles, (element) =>
    setAttribute(d.text, element, insensitive, locked ? "true" : null),
  );
}

/** Sets a property, or takes it away where its initial value then holds. */
function setOrDrop(d: Drawing, h: Handle, property: Property, value: string, initial: string) {
  const element = d.item(h)?.element;
  if (!element) return null;
  const styles = new Styles(d.text, d.root);
  const before = styles.value(element, property) ?? initial;
  const isSame = property === "opacity" ? shareOf(before) === Number(value) : before === value;
  if (isSame) return null;
  const mayDrop = value === initial && styles.inSheets(element, property) === null;
  return outcomeOf(setStyle(d.text, styles, element, property, mayDrop ? null : value));
}

/** @param opacity 0 to 1 */
export function setOpacity(d: Drawing, h: Handle, opacity: number): Outcome | null {
  const share = Math.min(Math.max(opacity, 0), 1);
  return setOrDrop(d, h, "opacity", numberText(share, 1e-4), "1");
}

/** @param blend a word of mix-blend-mode; others change nothing */
export function setBlend(d: Drawing, h: Handle, blend: string): Outcome | null {
  if (!(BLEND_MODES as readonly string[]).includes(blend)) return null;
  return setOrDrop(d, h, "mix-blend-mode", blend, "normal");
}

/** The length times a factor, in the same unit; null where it is none, or a percentage. */
function scaledLength(text: string | undefined, factor: number): string | null {
  const [, number, unit] =
    /^\s*([+-]?[\d.]+(?:[eE][+-]?\d+)?)([a-zA-Z]*)\s*$/.exec(text ?? "") ?? [];
  return number === undefined ? null : `${numberText(Number(number) * factor, 1e-4)}${unit}`;
}

/**
 * The viewBox; width and height, where they are there, keep what a unit is, and guides stay where they are on the
 * drawing.
 * @param box as Box
 */
export function setArtboard(
  d: Drawing,
  box: readonly [number, number, number, number],
): Outcome | null {
  const [x0, y0, x1, y1] = box;
  const [width, height] = [x1 - x0, y1 - y0];
  if (!(width > 0 && height > 0)) return null;
  const { viewBox } = readArtboard(d.root);
  const edits: Edit[] = [];
  const set = (name: string, value: string) => {
    edits.push(...setAttribute(d.text, d.root, name, value));
  };
  if (viewBox.some((value, i) => value !== box[i])) {
    set("viewBox", [x0, y0, width, height].map((value) => numberText(value, 1e-4)).join(" "));
    const sides = {
      width: width / (viewBox[2] - viewBox[0]),
      height: height / (viewBox[3] - viewBox[1]),
    };
    for (const [name, factor] of Object.entries(sides)) {
      const length = scaledLength(valueOf(d.root, name), factor);
      if (length !== null && factor !== 1) set(name, length);
    }
  }
  const made = outcomeOf(edits);
  if (!made || guidelinesOf(d).all.length === 0) return made;
  return outcomeOf([...edits, ...guidesKept(d, parse(applied(d.text, made.patch)))]);
}

/** Where colours are mixed; "srgb" is the default and not written. */
export function setInterpolation(d: Drawing, to: Drawing["interpolation"]): Outcome | null {
  if (d.interpolation === to) return null;
  const value = to === "srgb" ? null : to;
  return outcomeOf(setAttribute(d.text, d.root, sf("interpolation"), value));
}

/** null: none, whatever a <rect> says. */
export function setBackground(d: Drawing, color: Rgb | null): Outcome | null {
  if (!color && !d.background) return null;
  const said = color ? colorText(color) : "none";
  return outcomeOf(setAttribute(d.text, d.root, sf("background"), said));
}
