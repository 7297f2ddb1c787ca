/**
 * A module by its address. Servers that do not know .wasm name another type, and nothing streams then.
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
