// The licence texts of the libraries that the WebAssembly modules contain parts of.
import { readFileSync } from "node:fs";
import { join } from "node:path";

const debian = (name) => readFileSync(`/usr/share/doc/${name}/copyright`, "utf8");
/** Returns one of the comments of a file in the folder of `scripts/build-wasm`. */
const comment = (folder, name, which) => readFileSync(join(folder, name), "utf8").match(/\/\*[^]*?\*\//g).at(which);

const texts = {
  pugixml: (folder) => comment(folder, "pugixml/pugixml.hpp", -1),
  zlib: (folder) => comment(folder, "zlib/zlib.h", 0),
  "wasi-libc": () => debian("wasi-libc"),
  "libc++": () => debian("libc++-19-dev-wasm32"),
};

/** The libraries in modules that write files. */
export const libraries = ["pugixml", "zlib", "wasi-libc", "libc++"];

/** @param folder the output folder of `scripts/build-wasm` */
export const licenceOfLibrary = (folder, name) => texts[name](folder);
