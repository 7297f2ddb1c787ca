// The structure: which items there are, and where they stand.
export { duplicate } from "./duplicate.js";
export { group } from "./grouping.js";
export { makeInstance, makeUnique } from "./instances.js";
export { moveInto } from "../curves/moving.js";
export { deleteItems, restack } from "./stacking.js";
export { ungroup } from "./ungrouping.js";
