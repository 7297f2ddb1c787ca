// What there is, and where it stands.
export { duplicate } from "./duplicate.js";
export { group } from "./grouping.js";
export { makeInstance, makeUnique } from "./instances.js";
export { moveInto } from "./moving.js";
export { deleteItems, restack } from "./stacking.js";
export { ungroup } from "./ungrouping.js";
