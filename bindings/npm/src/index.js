// The package in a page or a worker: the module is fetched, and compiled while it comes.
import { compiledFrom } from "./fetch-module.js";
import { packageOver } from "./library.js";
import { addImages } from "./images.js";

export {
  Attribute, Kind, Sfumato, SfumatoContext, SfumatoDocument, SfumatoError, SfumatoField, SfumatoPicture, Side,
  Space, Status, Table,
} from "./library.js";
export const { load, read, create } = packageOver(
  async (source = new URL("./sfumato.wasm", import.meta.url)) =>
    source instanceof URL || typeof source === "string" ? compiledFrom(source) : source,
  addImages,
);
