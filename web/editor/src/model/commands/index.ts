// Every edit, as a patch of the present text. null: nothing would change.
export * from "./attributes.js";
export * from "./structure/clipboard.js";
export * from "./curves/create.js";
export * from "./curves/combine.js";
export * from "./document.js";
export * from "./paint/gradients.js";
export { movePaint } from "./paint/paint-place.js";
export * from "./paint/paints.js";
export * from "./curves/shapes.js";
export { pasteStyle, styleOf, type Style } from "./style.js";
export * from "./structure/structure.js";
export * from "./curves/filled.js";
export * from "./curves/fitted.js";
export * from "./curves/own-shape.js";
export * from "./curves/traced.js";
export { curvesOf, isContainer, together } from "./structure/together.js";
export * from "./curves/transform.js";
export type { Attribute } from "../types.js";
