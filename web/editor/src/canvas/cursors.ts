// Cursors: the system's where it has one, else 24 px drawings in white with a dark rim.
import type { GripName } from "./box.js";

/** A drawing, and the pixel that points. Lines are laid twice: dark and wide, then white. */
function drawn(lines: string, x: number, y: number, fallback: string): string {
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" width="24" height="24" fill="none" stroke-linecap="round" stroke-linejoin="round">` +
    `<g stroke="#000" stroke-opacity=".8" stroke-width="4">${lines}</g><g stroke="#fff" stroke-width="1.75">${lines}</g></svg>`;
  return `url("data:image/svg+xml,${encodeURIComponent(svg)}") ${x} ${y}, ${fallback}`;
}

const NIB = `<path d="M4 4l4 12 8-8zM4 4l6 6M9 17l9-9 3 3-9 9z"/>`;
const ARROW = `<path d="M5 3v14l4-3.500 3 6 2-1-3-6h5z"/>`;
const CROSS = `<path d="M12 4v5M12 15v5M4 12h5M15 12h5"/>`;
const BLUR = `<path d="M2 12h20M6 8l-4 4 4 4M18 8l4 4-4 4M12 5v14"/>`;

const FIXED = {
  default: "default",
  move: "move",
  copy: "copy",
  grab: "grab",
  grabbing: "grabbing",
  stop: "ew-resize",
  none: "not-allowed",
  bend: drawn(`${ARROW}<path d="M15 9c4-6 5 1 7-4"/>`, 5, 3, "default"),
  pen: drawn(NIB, 4, 4, "crosshair"),
  "pen-close": drawn(`${NIB}<circle cx="19" cy="5" r="2.500"/>`, 4, 4, "crosshair"),
  "pen-continue": drawn(`${NIB}<path d="M16 8l6-6"/>`, 4, 4, "crosshair"),
  "pen-add": drawn(`${NIB}<path d="M19 2v6M16 5h6"/>`, 4, 4, "crosshair"),
  "pen-remove": drawn(`${NIB}<path d="M16 5h6"/>`, 4, 4, "crosshair"),
  draw: drawn(CROSS, 12, 12, "crosshair"),
  sample: drawn(`${CROSS}<circle cx="12" cy="12" r="2"/>`, 12, 12, "crosshair"),
  turn: drawn(`<path d="M19 12a7 7 0 1 1-2-5M18 2v5h-5"/>`, 12, 12, "grab"),
  turning: drawn(`<path d="M19 12a7 7 0 1 1-2-5M18 2v5h-5"/>`, 12, 12, "grabbing"),
} as const;

export type CursorName = keyof typeof FIXED | `${GripName}-resize` | `blur-${number}`;

/** Which way a corner or edge is pulled. */
export function resizeCursor(grip: GripName): CursorName {
  return `${grip}-resize`;
}

/** The blur cursor is turned in steps of so many degrees: few drawings, no flicker. */
const BLUR_STEP = 15;

/** @param angle of the curve's normal, rad */
export function blurCursor(angle: number): CursorName {
  const degrees = Math.round((angle * 180) / Math.PI / BLUR_STEP) * BLUR_STEP;
  return `blur-${((degrees % 180) + 180) % 180}`;
}

/** As CSS's `cursor`. */
export function cssCursor(name: CursorName): string {
  if (name in FIXED) return FIXED[name as keyof typeof FIXED];
  if (!name.startsWith("blur-")) return name;
  return drawn(`<g transform="rotate(${name.slice(5)} 12 12)">${BLUR}</g>`, 12, 12, "ew-resize");
}
