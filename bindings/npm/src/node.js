// The package in Node: the module is a file beside this one, or, after bundling, in node_modules.
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { isAddress, packageOver, SfumatoError, Status } from "./library.js";

export {
  Attribute, Kind, Sfumato, SfumatoContext, SfumatoDocument, SfumatoError, SfumatoField, SfumatoPicture, Side,
  Space, Status, Table,
} from "./library.js";

const file = "sfumato.wasm";

/**
 * Returns the path of an address. A bundler's own class URL is no URL for node, so its text is used.
 * @param {string | {href: string}} address
 */
function pathOf(address) {
  const text = typeof address === "string" ? address : address.href;
  return /^file:/.test(text) ? fileURLToPath(text) : text;
}

/** Returns the places where the module may be: beside this script, and where an import from the project finds it. */
function* places() {
  // A CommonJS bundle has no import.meta.url.
  if (import.meta.url) yield pathOf(new URL("./sfumato.wasm", import.meta.url));
  else if (typeof __dirname !== "undefined") yield join(__dirname, file);
  const find = createRequire(join(process.cwd(), "package.json"));
  try {
    yield find.resolve(`sfumato/${file}`);
  } catch {
    // The package is not installed there.
  }
}

/** Reads the module from the first place that has it. */
async function moduleFile() {
  const tried = [];
  for (const path of places()) {
    try {
      return await readFile(path);
    } catch (error) {
      if (error.code !== "ENOENT") throw error;
      tried.push(path);
    }
  }
  const reason = `${file} is not there: copy it beside the bundle, or call \`await load(path)\` first`;
  throw new SfumatoError(Status.io, reason, { file: tried.join(", ") });
}

export const { load, read, importSvg, create } = packageOver(async (source) =>
  source === undefined ? moduleFile() : isAddress(source) ? readFile(pathOf(source)) : source,
);
