// The drawings of the gallery, to begin from. Their texts are fetched when one is chosen; the editor
// that is one file holds them.
import type { Example } from "../panels/services.js";
import type { Documents } from "./documents.js";

const texts = import.meta.glob<string>("../../../../examples/{sunset,portrait,apple,fish,flower,strokes,textures}.svg", {
  query: "?raw",
  import: "default",
});
const thumbs = import.meta.glob<string>("../../thumbs/{sunset,portrait,apple,fish,flower,strokes,textures}.webp", { query: "?url", import: "default", eager: true });

/** The gallery; tests check the numbers of curves and strokes against the files. */
const known = [
  { id: "sunset", name: "Sunset", curves: 15 },
  { id: "portrait", name: "Portrait", curves: 191 },
  { id: "apple", name: "Apple", curves: 41 },
  { id: "fish", name: "Fish", curves: 218 },
  { id: "flower", name: "Flower", curves: 236 },
  { id: "strokes", name: "Strokes", curves: 327 },
  { id: "textures", name: "Textures", curves: 2 },
] as const;

export const exampleIds = known.map(({ id }) => id);
export const curveCounts = new Map(known.map(({ id, curves }) => [id, curves] as const));

export function textOfExample(id: string): Promise<string> {
  return texts[`../../../../examples/${id}.svg`]();
}

/** Opens a copy of an example. */
async function openExample(documents: Promise<Documents>, id: string): Promise<void> {
  const text = await textOfExample(id);
  await (await documents).beginExample(text, `${id}.svg`);
}

export function examplesOf(documents: Promise<Documents>): readonly Example[] {
  return known.map(({ id, name, curves }) => ({
    name,
    curves,
    thumb: thumbs[`../../thumbs/${id}.webp`],
    open: () => openExample(documents, id),
  }));
}
