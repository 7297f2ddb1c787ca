// The package in a page or a worker: fetches the module and compiles it during the download.
import { SfumatoError, Status as Codes } from "../../../web/wasm/error.mjs";
import { compiledFrom } from "./fetch-module.js";
import { addImages } from "./images.js";
import { isAddress, packageOver } from "./library.js";
import { besideScript } from "./places.js";

export {
  Attribute, Kind, Sfumato, SfumatoContext, SfumatoDocument, SfumatoError, SfumatoField, SfumatoPicture, Side,
  Space, Status, Table,
} from "./library.js";

/** Returns the address of the module. Bundlers look for the last line. */
function modulePlace() {
  const moved = besideScript(import.meta.url, "sfumato.wasm");
  if (moved) return moved;
  if (!import.meta.url) {
    const reason = "this bundle does not know where sfumato.wasm is: call `await load(address)` first";
    throw new SfumatoError(Codes.unavailable, reason);
  }
  return new URL("./sfumato.wasm", import.meta.url);
}

export const { load, read, importSvg, create } = packageOver(
  async (source = modulePlace()) => (isAddress(source) ? compiledFrom(source) : source),
  addImages,
);
