// Words of the window: messages, commands and the engine.
import { curvesOf, objects, shared } from "./shared.js";

/** Messages of the page about files and about itself. */
export const page = {
  brokenPictures: (count: number) =>
    count === 1
      ? "This browser cannot read a picture in this drawing. Save that picture as PNG or JPEG."
      : `This browser cannot read ${count} pictures in this drawing. Save them as PNG or JPEG.`,
  cannotOpen: (name: string) => `“${name}” cannot be opened`,
  chooseFolder: "Choose folder",
  converted: (name: string, curves: number) =>
    `“${name}” was converted to ${curvesOf(curves)}.`,
  convertedPartly: (name: string, curves: number) =>
    `“${name}” was converted to ${curvesOf(curves)}; some parts were left out.`,
  leftOutOf: (name: string) => `Left out of “${name}”`,
  showLeftOut: shared.show,
  nothingConverted: "Nothing in this SVG can be converted to curves.",
  nothingPasted: "Nothing was pasted",
  downloaded: (name: string) => `“${name}” downloaded.`,
  exportNotes: (notes: string) => `Exported. Note: ${notes}.`,
  gone: "This drawing is no longer stored in this browser.",
  graphics: {
    missing: "This browser has no WebGL 2, so the picture is not shown. Use another browser to see it; everything else works.",
    lost: "The graphics driver was reset. Redrawing…",
  },
  insertLayers: "insert layers",
  keptHere: "Your drawing is stored in this browser.",
  missing: (names: readonly string[]) =>
    names.length === 1
      ? `The picture “${names[0]}” is missing. Drop it together with the drawing.`
      : `${names.length} pictures are missing. Drop them together with the drawing.`,
  pastedName: "pasted.svg",
  untitled: "untitled.svg",
  noPicture: "This file is not a picture. Choose a photo, such as a PNG or JPEG.",
  notOpened: "Nothing was opened",
  otherTab: "This drawing is open in another tab of this browser.",
  placePhoto: "Place photo",
  photoPlaced: "Photo placed over the drawing.",
  traceIt: "Trace…",
  saveAnyway: "Save anyway",
  saveElsewhere: "Save elsewhere",
  saved: (name: string) => `“${name}” saved`,
  takeOver: "Edit here",
  takenByTab: "This drawing is now edited in another tab. Changes here are not saved.",
} as const;

export const commands = {
  align: "Align",
  bringUp: shared.bringForward,
  close: shared.closeCurve,
  combine: shared.combine,
  combineWantsTwo: "Select two or more closed curves, and nothing else, to combine their shapes.",
  copyStyleWantsCurve: "Select the curve whose style you want to copy.",
  cut: shared.cut,
  cutCurve: shared.cutCurve,
  cutWantsNode: "Select one or more inner nodes of a curve with the node tool, then cut there.",
  delete: shared.delete,
  deleteHandle: "Retract handle",
  deleteNode: "Delete node",
  deleteStop: "Delete stop",
  deleted: (count: number) => (count === 1 ? "1 object deleted" : `${objects(count)} deleted`),
  distribute: "Distribute",
  distributeWantsThree: "Select at least three objects to distribute them.",
  duplicate: shared.duplicate,
  /** Why an edit is not done. */
  faults: {
    far: "Not changed: that is too far outside the canvas. Coordinates go up to 10,000,000.",
    "colorless stroke": "Not changed: a stroke needs a colour. Delete the stroke instead.",
    "circle of instances": "Not changed: a linked copy cannot be inside its own original. Put it in another layer.",
  },
  flip: "Flip",
  group: shared.group,
  join: shared.joinEnds,
  joinWantsTwo: "Select exactly two open curves, then join them.",
  makeInstance: shared.makeLinkedCopy,
  makeUnique: shared.unlink,
  newLayer: shared.newLayer,
  nodeKind: "Change node type",
  isShape: "Nothing was changed: it is already a shape of its own.",
  needsClosed: "Select a closed curve first. To close a curve, choose Object, Close curve.",
  noColors: "This selection has no side with several colours.",
  nothingLeft: "Nothing is left of these shapes.",
  nothingToSimplify: "These curves have no nodes that they do not need.",
  nothingToPaste: "There is no drawing on the clipboard. Copy curves or an SVG first.",
  oneColor: shared.oneColor,
  ownShape: shared.ownShape,
  open: shared.openCurve,
  paste: shared.paste,
  pasteStyle: shared.pasteStyle,
  reverse: shared.reverse,
  sendDown: shared.sendBackward,
  simplify: shared.simplify,
  styleCopied: "Style copied. Select other curves and paste it.",
  swapSides: shared.swapSides,
  toBottom: shared.sendToBack,
  toTop: shared.bringToFront,
  undo: shared.undo,
  ungroup: shared.ungroup,
  lintFixes: {
    closeCurve: shared.closeCurve,
    swapSides: shared.swapSides,
    deleteCurve: "Delete curve",
    deleteHidden: "Delete curve below",
    deleteEmptyLayers: "Delete empty layers",
    removeBlur: "Remove blur",
    addBarrier: "Make open side a barrier",
    matchEnds: "End with first colour",
    joinToCurve: "Move end onto curve",
    openSide: "Make side open",
    endAtOutline: "Limit layer to its outline",
    deleteInvisible: "Delete invisible object",
    bringIn: "Move into picture",
  },
} as const;

export const engine = {
  reasonAt: (line: number, column: number, reason: string) => `Line ${line}, column ${column}: ${reason}`,
  noWorker: "This browser cannot start web workers for this page, so the picture cannot be computed. Use another browser.",
  noWebAssembly: "This browser has no WebAssembly, so the picture cannot be computed. Turn it on, or use another browser.",
  noModule: (reason: string) => `The module that computes the picture could not be loaded (${reason}). Reload the page.`,
  traceTooLarge: "There is not enough memory to trace this photo. Use a smaller photo, or choose less detail.",
} as const;
