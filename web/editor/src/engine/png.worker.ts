// The worker of png.ts: one picture, one answer.
import { packPng } from "./pack-png.js";
import type { PngAnswer, PngPixels } from "./png.js";

addEventListener("message", ({ data }: MessageEvent<PngPixels>) => {
  let answer: PngAnswer;
  try {
    answer = { png: packPng(data) };
  } catch (error) {
    answer = { error: String(error) };
  }
  postMessage(answer, { transfer: "png" in answer ? [answer.png.buffer] : [] });
});
