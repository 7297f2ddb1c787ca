// All words that the editor shows. A translator copies this folder.
import { dialogs, files, photo, tour, trace, welcome } from "./dialogs.js";
import { layers, panels, picker } from "./panels.js";
import { canvas, commands, engine, page, tools } from "./window.js";

export const en = { page, commands, engine, canvas, tools, panels, layers, picker, dialogs, trace, photo, welcome, tour, files } as const;
