// Words of the stage and the tools.
import { lowered, objects, shared, sideNoun, steps } from "./shared.js";

export const canvas = {
  name: shared.canvas,
  describe: "Tab selects the next curve, Enter enters it, Escape leaves it; Shift Enter goes to the handles of the bounding box. Arrow keys move the selection; at a handle they scale or rotate it. With nothing selected, arrow keys move a point: with the pen, Enter sets a node there; with a shape tool, Enter sets a corner.",
  undone: (label: string) => `Undone: ${label}`,
  redone: (label: string) => `Redone: ${label}`,
  handlesOf: (curve: string) => `Handles of curve “${curve}”`,
  boxOf: (name: string) => `Bounding box of “${name}”`,
  boxOfSeveral: (count: number) => `Bounding box of ${objects(count)}`,
  node: (index: number, curve: string) => `Node ${index} of curve “${curve}”`,
  handle: (node: number, end: "start" | "end") => `Handle of node ${node}, towards the ${end}`,
  stop: (side: string, index: number, count: number, value: string, at: string) =>
    `${side} stop ${index} of ${count}, ${value}, at ${at}`,
  bracket: (kind: "blur" | "radius", side: string, value: string, at: string) =>
    `${kind === "blur" ? shared.blur : shared.radius} ${value}, ${sideNoun(side)}, at ${at}`,
  paint: (kind: "linear" | "radial" | "texture", grip: "start" | "end" | "across" | "focus", side: string) => {
    const names = {
      linear: { start: "Start of the gradient", end: "End of the gradient", across: "", focus: "" },
      radial: {
        start: "Centre of the gradient", end: "Radius of the gradient",
        across: "Second radius of the gradient", focus: "Focus of the gradient",
      },
      texture: {
        start: "Corner of the texture", end: "Width of the texture", across: "Height of the texture", focus: "",
      },
    };
    return `${names[kind][grip]}, ${sideNoun(side)}`;
  },
  offset: (percent: string) => `${percent} %`,
  segment: (number: string) => `segment ${number}`,
  opacity: (percent: string) => `opacity ${percent} %`,
  scale: {
    nw: "Scale, top left", n: "Scale, top", ne: "Scale, top right", e: "Scale, right",
    se: "Scale, bottom right", s: "Scale, bottom", sw: "Scale, bottom left", w: "Scale, left",
  },
  turn: "Rotate",
  selectedCurve: (name: string, index: number, count: number) => `Curve “${name}”, ${index} of ${count}`,
  at: (name: string, x: string, y: string) => `${name} at x ${x}, y ${y}`,
  size: (width: string, height: string) => `${width} × ${height}`,
  angle: (degrees: string) => `${degrees}°`,
  guideTag: (axis: 0 | 1, value: string) => `${axis === 0 ? "x" : "y"} ${value}`,
  guideChosen: (axis: 0 | 1, value: string) => `${shared.guideAt[axis]} ${value}`,
  guideGoes: shared.removeGuide,
  blurTag: (value: string) => `${shared.blur} ${value}`,
  radiusTag: (value: string) => `${shared.radius} ${value}`,
  clear: "transparent",
  sampled: (sides: readonly (readonly [name: string, color: string])[]) =>
    sides.map((pair) => pair.join(" ")).join(" · "),
} as const;

export const tools = {
  undo: {
    move: steps.move,
    copy: "copy",
    scale: "scale",
    turn: steps.rotate,
    moveNodes: "move nodes",
    moveNode: steps.moveNode,
    moveHandle: "move handle",
    movePaint: "move gradient or texture",
    bend: "bend curve",
    addNode: "add node",
    deleteNodes: "delete nodes",
    kind: "change node type",
    moveStop: steps.moveStop,
    addStop: steps.addStop,
    deleteStops: "delete stops",
    blur: steps.changeBlur,
    radius: steps.changeRadius,
    pen: steps.drawCurve,
    penNode: "set node",
    penContinued: "continue curve",
    pencil: steps.drawCurve,
    stroke: "draw stroke",
    shape: { rectangle: "draw rectangle", ellipse: "draw ellipse", polygon: "draw polygon" },
    addGuide: lowered(shared.addGuide),
    moveGuide: lowered(shared.moveGuide),
    removeGuide: lowered(shared.removeGuide),
    sample: "sample colours",
    pick: "pick colour",
    close: lowered(shared.closeCurve),
  },
  /** The answer to a click, or to a drag without width or height. */
  dragShape: {
    rectangle: "Drag from corner to corner to draw a rectangle.",
    ellipse: "Drag from corner to corner to draw an ellipse.",
    polygon: "Drag from corner to corner to draw a polygon.",
  },
  /** The same where arrow keys move the corner. */
  flatShape: "Move the second corner across and down with the arrow keys, then press Enter.",
  firstCorner: "First corner set",
  noPhoto: "There is no photo to sample. Drop a picture on the canvas first.",
  photoUnread: "The photo cannot be read, so its colours cannot be sampled. Place it again as PNG or JPEG.",
} as const;
