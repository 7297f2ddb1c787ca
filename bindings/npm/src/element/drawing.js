// Loaded when the first element comes near the screen: the code that reads, solves and draws pictures.
export { SharedPicture } from "./pictures.js";
export { ask, clients, largestSide, leave, pageOf, prepare, unask } from "./stage.js";
