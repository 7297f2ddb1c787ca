// Words of the editor that several parts show, and how counts and grades are put into words.

/** Returns a text as it stands within a sentence. */
export const lowered = (text: string) => text.charAt(0).toLowerCase() + text.slice(1);

/** Returns a text as it begins a sentence. */
export const raised = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

export const objects = (count: number) => `${count} objects`;

/** Returns a side's name as a noun within a sentence: "left side", "inside". */
export const sideNoun = (name: string) =>
  name === shared.sides.left || name === shared.sides.right ? `${lowered(name)} side` : lowered(name);

export const curvesOf = (count: number) => (count === 1 ? "1 curve" : `${count} curves`);

/** Returns a word for how near a drawing is to its photo, from the peak signal-to-noise ratio in dB. */
export const gradeOf = (psnr: number) => (psnr >= 40 ? "excellent" : psnr >= 30 ? "good" : psnr >= 25 ? "fair" : "rough");

/** Labels that stand in several places and mean the same there. */
export const shared = {
  addGuide: "Add a guide",
  artboard: "Artboard",
  blur: "Blur",
  bringForward: "Bring forward",
  bringToFront: "Bring to front",
  canvas: "Canvas",
  close: "Close",
  closeCurve: "Close curve",
  color: "Colour",
  colorBothSides: "Colour both sides",
  colorStops: "Colour stops",
  combine: { unite: "Unite", subtract: "Subtract from the lowest", intersect: "Intersect", exclude: "Exclude" },
  commands: "Find a command",
  copyStyle: "Copy style",
  curve: "Curve",
  cut: "Cut",
  cutCurve: "Cut at nodes",
  dark: "Dark",
  delete: "Delete",
  done: "Done",
  drawCurve: "Draw a curve",
  duplicate: "Duplicate",
  edit: "Edit",
  export: "Export",
  file: "File",
  group: "Group",
  guideAt: ["Vertical guide, x", "Horizontal guide, y"],
  hints: "Hints",
  hue: "Hue",
  joinEnds: "Join ends",
  keys: "Keyboard shortcuts",
  layers: "Layers",
  light: "Light",
  lockGuides: "Lock guides",
  lookingForEdges: "Looking for edges…",
  makeLinkedCopy: "Make a linked copy",
  nearTip: "How near the drawing is to the photo: 30 dB is good, 40 dB is hard to tell apart",
  moveGuide: "Move guide",
  needsGuide: "Drag a guide from a ruler first",
  newLayer: "New layer",
  normal: "Normal",
  opacity: "Opacity",
  open: "Open",
  openCurve: "Open curve",
  oneColor: "One colour",
  ownShape: "Make a shape of its own",
  paste: "Paste",
  pasteStyle: "Paste style",
  pen: "Pen",
  percent: (value: string) => `${value} %`,
  photo: "Photo",
  radius: "Radius",
  removeGuide: "Remove guide",
  removeGuides: "Remove all guides",
  reverse: "Reverse direction",
  saturation: "Saturation",
  sendBackward: "Send backward",
  sendToBack: "Send to back",
  show: "Show",
  showGuides: "Show guides",
  sides: { left: "Left", right: "Right", inside: "Inside", outside: "Outside" },
  simplify: "Simplify",
  softenWithBlur: "Soften with blur",
  swapSides: "Swap sides",
  theme: "Theme",
  tools: "Tools",
  tour: "Five-step tour",
  undo: "Undo",
  ungroup: "Ungroup",
  unlink: "Unlink",
  value: "Value",
  view: "View",
} as const;

/** Names of undo steps that several parts of the editor make. */
export const steps = {
  addStop: "add stop",
  changeBlur: "change blur",
  changeColor: "change colour",
  changeRadius: "change radius",
  drawCurve: "draw curve",
  move: "move",
  moveNode: "move node",
  moveStop: "move stop",
  openSide: "make side open",
  rotate: "rotate",
} as const;
