// The exports and imports of the module.
import { same, textOf } from "./harness.mjs";

/** Exports for JavaScript besides the C interface. */
const OWN = [
  "memory",
  "_initialize",
  "__indirect_function_table",
  "sfumato_allocate",
  "sfumato_free",
];

function headerNames() {
  const header = textOf("include/sfumato/sfumato.h").toString();
  return [...header.matchAll(/^SFUMATO_API [^()]*?(sfumato_[a-z_]+)\(/gm)].map(([, name]) => name);
}

export async function testFace(tap, module) {
  await tap.test("the module exports what the C header declares, and nothing else", () => {
    const exported = WebAssembly.Module.exports(module).map(({ name }) => name);
    const sorted = (names) => [...names].sort().join(" ");
    same(sorted(exported), sorted([...headerNames(), ...OWN]), "the module's list");
  });
  await tap.test("the module imports a clock of WASI, and nothing else", () => {
    const imported = WebAssembly.Module.imports(module).map((one) => `${one.module} ${one.name}`);
    same(imported.join(", "), "wasi_snapshot_preview1 clock_time_get", "the list of imports");
  });
  await tap.test("the module has no names of functions in it", () => {
    same(WebAssembly.Module.customSections(module, "name").length, 0, "the number of name sections");
  });
}
