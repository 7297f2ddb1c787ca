// What the element loads when one of them comes near the screen: what reads, solves and draws pictures.
export { SharedPicture } from "./pictures.js";
export { ask, clients, largestSide, leave, pageOf, prepare, unask } from "./stage.js";
