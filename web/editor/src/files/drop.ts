// Files dropped on the page: one drawing or photo, and the pictures that the drawing names.
import * as en from "../strings/en.js";
import type { Convert, Opened } from "./open.js";
import { openFile } from "./open.js";
import type { Piece } from "./pieces.js";

const words = en.files;

export interface Dropped {
  readonly opened: Opened;
  /** Files dropped with it, which a drawing may name as textures. */
  readonly beside: readonly File[];
}

const isDrawing = ({ file }: Piece) => /\.(svgz?|xml)$/i.test(file.name) || file.type === "image/svg+xml";

export async function openPieces(pieces: readonly Piece[], convert: Convert): Promise<Dropped> {
  const problem = (reason: string): Dropped => ({ opened: { kind: "problem", reason }, beside: [] });
  const drawings = pieces.filter(isDrawing);
  if (pieces.length === 0 || pieces.some(({ isFolder }) => isFolder)) return problem(words.folder);
  if (drawings.length > 1 || (drawings.length === 0 && pieces.length > 1)) return problem(words.several);
  const chosen = drawings[0] ?? pieces[0];
  const opened = await openFile(chosen.file, convert, await chosen.handle);
  return { opened, beside: pieces.filter((piece) => piece !== chosen).map(({ file }) => file) };
}
