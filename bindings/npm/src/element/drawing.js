// Loaded when the first element comes near the screen: the code that reads, solves and draws pictures.
export { shared } from "./pictures.js";
export { ask, clients, largestSide, leave, pageOf, pauseUntil, prepare, unask } from "./stage.js";
