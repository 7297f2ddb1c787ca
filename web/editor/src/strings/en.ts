// All words that the editor shows; each part of it has its own object.

/** commands */
const commands = {
  // commands: begin
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
