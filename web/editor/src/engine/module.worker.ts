// Unpacks the module of the page that is one file, and compiles it.
import { unpacked } from "./packed.js";

addEventListener("message", ({ data }: MessageEvent<string>) => {
  WebAssembly.compile(unpacked(data)).then(postMessage, (error: unknown) => postMessage(String(error)));
});
