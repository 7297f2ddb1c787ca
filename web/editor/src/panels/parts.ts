// The parts of the page that the first picture does not wait for: a file of its own (shell/part.tsx).
export { Dialogs } from "./dialogs/dialogs.js";
export { HintList, HintRing, HintsDock } from "./hints/hints.js";
export { Inspector } from "./inspector/inspector.js";
export { LayersPanel } from "./layers/layers.js";
export { Picker } from "./picker/picker.js";
export { Tour } from "./tour/tour.js";
