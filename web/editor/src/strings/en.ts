// All words that the editor shows; each part of it has its own object.

/** commands */
const commands = {
  // commands: begin
  align: "Align",
  bringUp: "Bring up",
  close: "Close curve",
  cut: "Cut",
  delete: "Delete",
  deleteNode: "Delete node",
  deleteStop: "Delete stop",
  deleted: (count: number) => (count === 1 ? "1 thing deleted" : `${count} things deleted`),
  duplicate: "Duplicate",
  flip: "Flip",
  group: "Group",
  join: "Join the ends",
  joinWantsTwo: "Select two open curves to join.",
  makeInstance: "Make an instance",
  makeUnique: "Make unique",
  newLayer: "New layer",
  nodeKind: "Change node",
  nothingToPaste: "There is no drawing on the clipboard.",
  open: "Open curve",
  paste: "Paste",
  reverse: "Reverse curve",
  sendDown: "Send down",
  swapSides: "Swap the sides",
  toBottom: "Send to the bottom",
  toTop: "Bring to the top",
  undo: "Undo",
  ungroup: "Ungroup",
  // commands: end
} as const;

/** What the page says of files and of itself. */
const page = {
  // page: begin
  cannotOpen: (name: string) => `“${name}” cannot be opened`,
  downloaded: (name: string) => `“${name}” was handed to the browser’s downloads.`,
  gone: "This drawing is no longer kept here.",
  graphics: {
    missing: "This browser has no WebGL 2, which draws the picture. Everything else works.",
    lost: "The graphics card let go of the page. Drawing again…",
  },
  missing: (names: readonly string[]) =>
    names.length === 1
      ? `The picture “${names[0]}” is not there. Drop it together with the drawing.`
      : `${names.length} pictures are not there. Drop them together with the drawing.`,
  noPicture: "This file is no picture.",
  notOpened: "Nothing was opened",
  otherTab: "Another tab of this browser has this drawing open.",
  placePhoto: "Place photo",
  saveAnyway: "Save anyway",
  saveElsewhere: "Save elsewhere",
  saved: (name: string) => `“${name}” saved`,
  takeOver: "Edit here",
  takenByTab: "Another tab goes on with this drawing. Changes here are no longer kept.",
  untitled: "Untitled.svg",
  // page: end
} as const;

/** engine */
const engine = {
  // engine: begin
  // engine: end
} as const;

/** canvas */
const canvas = {
  // canvas: begin
  // canvas: end
} as const;

/** tools */
const tools = {
  // tools: begin
  // tools: end
} as const;

/** As it stands within a sentence. */
const lowered = (text: string) => text.charAt(0).toLowerCase() + text.slice(1);

/** panels */
const panels = {
  // panels: begin
  menu: "Menu",
  file: "File",
  edit: "Edit",
  object: "Object",
  view: "View",
  help: "Help",
  new: "New",
  open: "Open",
  save: "Save",
  saveAs: "Save as",
  placePhoto: "Place a photo to trace over",
  export: "Export",
  recover: "Recover",
  document: "Document",
  home: "Start page",
  undo: "Undo",
  redo: "Redo",
  undoOf: (label: string) => `Undo: ${lowered(label)}`,
  redoOf: (label: string) => `Redo: ${lowered(label)}`,
  cut: "Cut",
  copy: "Copy",
  paste: "Paste",
  duplicate: "Duplicate",
  delete: "Delete",
  selectAll: "Select all",
  group: "Group",
  ungroup: "Ungroup",
  bringUp: "Bring up",
  sendDown: "Send down",
  toTop: "Bring to the top",
  toBottom: "Send to the bottom",
  swapSides: "Swap the sides",
  reverse: "Reverse the direction",
  close: "Close the curve",
  join: "Join the ends",
  makeInstance: "Make a copy that follows",
  makeUnique: "Make unique",
  alignLeft: "Align left",
  alignCenter: "Align centre",
  alignRight: "Align right",
  flipHorizontal: "Flip left to right",
  flipVertical: "Flip top to bottom",
  zoomIn: "Zoom in",
  zoomOut: "Zoom out",
  zoomFit: "Whole picture",
  zoomSelection: "Selection",
  zoomActual: "Actual size",
  mesh: "Mesh",
  outlines: "Outlines",
  reference: "Reference photo",
  hideHandles: "Hide handles",
  grid: "Grid",
  snap: "Snap",
  keys: "Keys",
  tour: "The five steps",
  about: "About Sfumato",
  theme: "Light or dark",
  themes: { system: "As the system", light: "Light", dark: "Dark" },
  kept: {
    file: "Saved",
    browser: "Saved on this device",
    nowhere: "Not saved: this browser keeps nothing",
  },
  unsaved: "Not saved yet",
  toolOptions: "Options of the tool",
  tools: "Tools",
  tool: {
    select: "Select",
    nodes: "Nodes",
    pen: "Pen",
    pencil: "Pencil",
    stroke: "Stroke",
    sample: "Sample",
    blur: "Blur",
    hand: "Hand",
  },
  toolHint: {
    select: "Drag to move. Hold Alt to leave a copy.",
    nodes: "Drag a stop along the curve. Double-click it for its colour.",
    pen: "Click for a corner, drag for a curve. Enter ends it.",
    pencil: "Draw. The line is smoothed when you let go.",
    stroke: "Draw. A pen’s pressure is the radius.",
    sample: "Drag along the curve: both sides take the photo’s colours.",
    blur: "Drag away from the curve. Hold Shift for both sides.",
    hand: "Drag to move the picture. The wheel zooms.",
  },
  nodeKind: "Kind of node",
  corner: "Corner",
  smooth: "Smooth",
  symmetric: "Symmetric",
  showOnCurve: "Show on the curve",
  attribute: { color: "Colour", opacity: "Opacity", blur: "Blur" },
  smoothing: "Smoothing",
  strokeRadius: "Radius",
  sampleDistance: "Distance",
  sampleTolerance: "Tolerance",
  sampleSelection: "Sample the selection",
  canvas: "Canvas",
  panels: "Panels",
  panelsWidth: "Width of the panels",
  panelsSplit: "Height of the upper panel",
  sheetHeight: "Height of the sheet",
  sheetTabs: { curve: "Curve", layers: "Layers", hints: "Hints" },
  hintsTab: (count: number) => (count === 0 ? "Hints" : `Hints · ${count}`),
  hintCount: (count: number) => (count === 0 ? "No hints" : count === 1 ? "1 hint" : `${count} hints`),
  status: {
    empty: "Nothing to draw",
    exact: "Exact",
    refining: "Refining…",
    problem: "Cannot be drawn",
    failed: "Stopped",
  },
  exactTip: "The picture is the one that export will write",
  milliseconds: (value: string) => `${value} ms`,
  showProblem: "Show what is wrong",
  position: (x: string, y: string) => `x ${x}  y ${y}`,
  surround: "Grey around the picture",
  surrounds: { dark: "Dark", mid: "Middle grey", light: "Light" },
  zoom: (percent: string) => `Zoom, ${percent} %`,
  percent: (value: string) => `${value} %`,
  undoShort: "Undo",
  dismiss: "Dismiss",
  value: "Value",
  mixed: "Mixed",
  notANumber: "Not a number",
  atLeast: (least: string) => `At least ${least}`,
  atMost: (most: string) => `At most ${most}`,
  notAColor: "No colour that CSS knows",
  sides: { left: "Left", right: "Right" },
  bothSides: "Both sides",
  more: "More",
  moreOf: (name: string) => `More for “${name}”`,
  curveTitle: (name: string) => `Curve “${name}”`,
  strokeTitle: (name: string) => `Stroke “${name}”`,
  layerTitle: (name: string) => `Layer “${name}”`,
  groupTitle: (name: string) => `Group “${name}”`,
  copyTitle: (name: string) => `Copy “${name}”`,
  referenceTitle: (name: string) => `Photo “${name}”`,
  curvesTitle: (count: number) => `${count} curves`,
  thingsTitle: (count: number) => `${count} things`,
  nodeTitle: (index: number, count: number) => `Node ${index} of ${count}`,
  nodesTitle: (chosen: number, count: number) => `${chosen} of ${count} nodes`,
  changesCopies: (count: number) => `changes ${count} copies`,
  copyOf: (name: string) => `Follows “${name}”`,
  copyOfNothing: "What it follows is not in this file",
  goToOriginal: "Go to the original",
  ribbonOf: (side: string) => `${side} side`,
  stopName: (side: string, index: number, count: number, value: string, at: string) =>
    `${side} stop ${index} of ${count}, ${value}, at ${at} %`,
  stopAt: (at: string) => `Stop at ${at} %`,
  stopRemoved: "Stop removed",
  addStop: "add stop",
  copyStop: "copy stop",
  moveStop: "move stop",
  removeStop: "remove stop",
  setColor: "change colour",
  colorOfStop: (side: string, index: number, color: string) => `Colour of ${side.toLowerCase()} stop ${index}, ${color}`,
  hex: "Colour, hex",
  at: "At",
  atOf: (side: string, index: number) => `Place of ${side.toLowerCase()} stop ${index}`,
  pickFromPicture: "Pick from the picture",
  kindOfSide: (side: string) => `What the ${side.toLowerCase()} side has`,
  sideStops: "Colour stops",
  sideOpen: "Open: colours pass",
  sideBarrier: "Barrier: colours stop here",
  linear: "Linear gradient",
  radial: "Radial gradient",
  texture: "Texture…",
  paintOfDocument: "Of this document",
  openNow: "Open",
  asOther: "As the other side",
  barrierNow: "Barrier",
  paintNow: (id: string) => `Paint “${id}”`,
  giveColor: "give a colour",
  giveColorShort: "Give it a colour",
  openSide: "open the side",
  makeBarrier: "make a barrier",
  setPaint: "set gradient",
  setTexture: "set texture",
  blur: "Blur",
  radius: "Radius",
  bothAlike: "Both sides alike",
  linkBlur: "make the sides alike",
  blurAlong: (left: string, right: string | null) =>
    right === null ? `Blur along the curve: ${left}` : `Blur along the curve: left ${left}; right ${right}`,
  radiusAlong: (radii: string) => `Radius along the curve: ${radii}`,
  radiusName: (side: string, radius: string, at: string) => `${side}, radius ${radius} at ${at} %`,
  radiusOfPoint: (label: string, index: number) => `${label}, radius of point ${index}`,
  placeOfPoint: (label: string, index: number) => `${label}, place of point ${index}`,
  addRadius: "add radius",
  moveRadius: "change radius",
  removeRadius: "remove radius",
  opacity: "Opacity",
  opacityOf: (side: string) => `Opacity, ${side.toLowerCase()}`,
  opacityPercent: "Opacity, per cent",
  setOpacity: "change opacity",
  setBlur: "change blur",
  opaqueAgain: "Take the opacity away",
  weight: "Pull",
  alpha: "Strength",
  nodeX: "Node, x",
  nodeY: "Node, y",
  moveNode: "move node",
  move: "move",
  resize: "resize",
  left: "Left edge",
  top: "Upper edge",
  width: "Width",
  height: "Height",
  blend: "Blend",
  blendMode: "Blend mode",
  setBlend: "change blend mode",
  visible: "Visible",
  locked: "Locked",
  neverExported: "It is exported only if you ask for it.",
  showOrHide: "show or hide",
  lockOrUnlock: "lock or unlock",
  sampling: "Taking colours",
  all: "All of them",
  recolorTitle: "Exchange a colour",
  recolorFrom: (hex: string) => `${hex} becomes`,
  recolorTo: "New colour, hex",
  recolor: "exchange colour",
  artboard: "Artboard",
  setArtboard: "change artboard",
  background: "A background colour",
  backgroundTitle: "Background",
  backgroundColor: "Background, hex",
  setBackground: "change background",
  interpolation: "Colours mix in",
  linearLight: "Linear",
  setInterpolation: "change how colours mix",
  // panels: end
} as const;

/** layers */
const layers = {
  // layers: begin
  title: "Layers",
  newLayer: "New layer",
  empty: "Nothing here yet. Draw a curve (P) or drop a picture.",
  treeOf: (file: string) => `Layers of ${file}`,
  rename: "Rename",
  nameOf: (name: string) => `Name of “${name}”`,
  move: "move in the layers",
  hide: "Hide",
  show: "Show",
  lock: "Lock",
  unlock: "Unlock",
  hidden: (name: string) => `Hide ${name}`,
  locked: (name: string) => `Lock ${name}`,
  set: { hidden: { on: "hide", off: "show" }, locked: { on: "lock", off: "unlock" } },
  many: (count: number) => `${count} things`,
  original: "original",
  copiesFollow: (count: number) => (count === 1 ? "One copy follows this one" : `${count} copies follow this one`),
  blend: {
    normal: "Normal",
    darken: "Darken",
    multiply: "Multiply",
    "color-burn": "Colour burn",
    lighten: "Lighten",
    screen: "Screen",
    "color-dodge": "Colour dodge",
    overlay: "Overlay",
    "soft-light": "Soft light",
    "hard-light": "Hard light",
    difference: "Difference",
    exclusion: "Exclusion",
    hue: "Hue",
    saturation: "Saturation",
    color: "Colour",
    luminosity: "Luminosity",
  },
  // layers: end
} as const;

/** picker */
const picker = {
  // picker: begin
  // picker: end
} as const;

/** dialogs */
const dialogs = {
  // dialogs: begin
  hints: "Hints",
  noHints: "No hints. Nothing leaks, no side is hidden.",
  hintsHeight: "Height of the hints",
  closeHints: "Close hints",
  hintIn: (name: string, parent: string) => `“${name}” in “${parent}”`,
  hintOf: (name: string) => `“${name}”`,
  hideRule: "Hide all of this kind",
  showHidden: (count: number) => (count === 1 ? "Show 1 hidden hint" : `Show ${count} hidden hints`),
  // dialogs: end
} as const;

/** welcome */
const welcome = {
  // welcome: begin
  // welcome: end
} as const;

/** tour */
const tour = {
  // tour: begin
  // tour: end
} as const;

/** files */
const files = {
  // files: begin
  // files: end
} as const;

/** keys */
const keys = {
  // keys: begin
  // keys: end
} as const;

export const en = { page, commands, engine, canvas, tools, panels, layers, picker, dialogs, welcome, tour, files, keys } as const;
