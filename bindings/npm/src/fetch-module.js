/**
 * Loads a module from its address. It is compiled after the download if the server gives it a wrong MIME type.
 * @param {string | URL} address
 */
export async function compiledFrom(address) {
  if (typeof WebAssembly === "undefined") throw new Error("This browser has no WebAssembly.");
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status} ${answer.statusText}`);
  const type = answer.headers.get("content-type") ?? "";
  return type.startsWith("application/wasm")
    ? WebAssembly.compileStreaming(answer)
    : WebAssembly.compile(await answer.arrayBuffer());
}
