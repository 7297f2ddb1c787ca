// Path data: read, written, and rewritten as little as can be.
export { readPathText, type PathText } from "./pathreader.js";
export { numberText, writePath } from "./pathwriter.js";
export { reversedData } from "./reverse.js";
export { rewritePath } from "./rewrite.js";
export { geometryAttributes, readPath, shapeData, shapePaths, type AttributeOf } from "./shape.js";
