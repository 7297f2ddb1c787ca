// The package in a page or a worker: fetches the module and compiles it during the download.
import { compiledFrom } from "./fetch-module.js";
import { packageOver } from "./library.js";
import { addImages } from "./images.js";

export {
  Attribute, Kind, Sfumato, SfumatoContext, SfumatoDocument, SfumatoError, SfumatoField, SfumatoPicture, Side,
  Space, Status, Table,
} from "./library.js";
export const { load, read, importSvg, create } = packageOver(
  async (source = new URL("./sfumato.wasm", import.meta.url)) =>
    source instanceof URL || typeof source === "string" ? compiledFrom(source) : source,
  addImages,
);
