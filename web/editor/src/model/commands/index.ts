// Every edit, as a patch of the present text. null: nothing would change.
export * from "./attributes.js";
export * from "./clipboard.js";
export * from "./create.js";
export * from "./document.js";
export * from "./gradients.js";
export { movePaint } from "./paint-place.js";
export * from "./paints.js";
export * from "./shapes.js";
export * from "./structure.js";
export * from "./fitted.js";
export * from "./traced.js";
export { curvesOf, isContainer, together } from "./together.js";
export * from "./transform.js";
export type { Attribute } from "../types.js";
