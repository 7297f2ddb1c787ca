import { fetched, isWebPage } from "./places.js";
import { SfumatoError, Status } from "../../../web/wasm/error.mjs";

/**
 * Loads a module from its address. It is compiled after the download if the server gives it a wrong MIME type.
 * @param {string | URL} address
 */
export async function compiledFrom(address) {
  if (typeof WebAssembly === "undefined") {
    throw new SfumatoError(Status.unavailable, "this browser has no WebAssembly");
  }
  const answer = await fetched(address);
  const type = answer.headers.get("content-type") ?? "";
  if (type.startsWith("application/wasm")) return WebAssembly.compileStreaming(answer);
  const bytes = await answer.arrayBuffer();
  if (!isWebPage(new Uint8Array(bytes))) return WebAssembly.compile(bytes);
  const reason = "the server has answered with a web page, expected a WebAssembly module: set its address, as docs/npm.md describes";
  throw new SfumatoError(Status.io, reason, { file: String(address) });
}
