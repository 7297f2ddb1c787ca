// What is dropped on the page: one drawing or photo, and the pictures that the drawing names.
import { en } from "../strings/en.js";
import type { Convert, Opened } from "./open.js";
import { openFile } from "./open.js";

const words = en.files;

export interface Dropped {
  readonly opened: Opened;
  /** Files dropped with it, which a drawing may name as textures. */
  readonly beside: readonly File[];
}

interface Piece {
  readonly file: File;
  readonly isFolder: boolean;
  readonly handle: Promise<FileSystemFileHandle | null>;
}

type HandleItem = DataTransferItem & { getAsFileSystemHandle?(): Promise<FileSystemHandle | null> };

function pieceOf(item: HandleItem): Piece | null {
  const file = item.getAsFile();
  if (!file) return null;
  const isFolder = item.webkitGetAsEntry?.()?.isDirectory ?? false;
  const handle = (item.getAsFileSystemHandle?.() ?? Promise.resolve(null))
    .then((found) => (found?.kind === "file" ? (found as FileSystemFileHandle) : null))
    .catch(() => null);
  return { file, isFolder, handle };
}

const isDrawing = ({ file }: Piece) => /\.(svgz?|xml)$/i.test(file.name) || file.type === "image/svg+xml";

/**
 * Takes what a drop brings; null: no files. To be called while the event is handled: the browser
 * forgets the files afterwards.
 */
export function openDropped(data: DataTransfer, convert: Convert): Promise<Dropped> | null {
  const items = [...data.items].filter(({ kind }) => kind === "file");
  const pieces = items.map(pieceOf).filter((piece) => piece !== null);
  return items.length === 0 ? null : openPieces(pieces, convert);
}

async function openPieces(pieces: readonly Piece[], convert: Convert): Promise<Dropped> {
  const problem = (reason: string): Dropped => ({ opened: { kind: "problem", reason }, beside: [] });
  const drawings = pieces.filter(isDrawing);
  if (pieces.length === 0 || pieces.some(({ isFolder }) => isFolder)) return problem(words.folder);
  if (drawings.length > 1 || (drawings.length === 0 && pieces.length > 1)) return problem(words.several);
  const chosen = drawings[0] ?? pieces[0];
  const opened = await openFile(chosen.file, convert, await chosen.handle);
  return { opened, beside: pieces.filter((piece) => piece !== chosen).map(({ file }) => file) };
}
