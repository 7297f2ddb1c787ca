// The pictures that the gallery's drawings name. The editor that is one file holds them.
import { partsOf, type Beside } from "../files/images.js";

const pictures = import.meta.glob<string>("../../../../examples/*.png", { query: "?url", import: "default" });

export const besideExamples: Beside = {
  async bytes(href) {
    const address = pictures[`../../../../examples/${partsOf(href)?.at(-1)}`];
    if (!address) return null;
    return new Uint8Array(await (await fetch(await address())).arrayBuffer());
  },
};
