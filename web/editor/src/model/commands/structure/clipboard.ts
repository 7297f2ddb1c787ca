// Items as text, for here and elsewhere.
export { copyItems } from "./copying.js";
export { paste } from "./paste.js";
export { insertCentred } from "./inserted.js";
