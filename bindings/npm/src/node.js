// The package in Node: the module is a file beside this one.
import { readFile } from "node:fs/promises";
import { packageOver } from "./library.js";

export {
  Attribute, Kind, Sfumato, SfumatoContext, SfumatoDocument, SfumatoError, SfumatoField, SfumatoPicture, Side,
  Space, Status, Table,
} from "./library.js";
export const { load, read, importSvg, create } = packageOver(
  async (source = new URL("./sfumato.wasm", import.meta.url)) =>
    source instanceof URL || typeof source === "string" ? readFile(source) : source,
);
