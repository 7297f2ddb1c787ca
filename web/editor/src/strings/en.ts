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

/** panels */
const panels = {
  // panels: begin
  // panels: end
} as const;

/** layers */
const layers = {
  // layers: begin
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

export const en = { commands, engine, canvas, tools, panels, layers, picker, dialogs, welcome, tour, files, keys } as const;
