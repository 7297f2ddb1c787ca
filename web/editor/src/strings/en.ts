// All words that the editor shows. A translator copies this folder. Use it as a namespace: a chunk then holds
// only the parts that it shows.
export { dialogs, files, photo, tour, trace } from "./dialogs.js";
export { layers, panels } from "./panels.js";
export { picker } from "./picker.js";
export { canvas, tools } from "./stage.js";
export { welcome } from "./welcome.js";
export { commands, engine, page } from "./window.js";
