// The files of a drop, including those that are available only during the browser's event.
export interface Piece {
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

/**
 * Returns the files of a drop; null: no files. Call it while the event is handled: the browser forgets the
 * files afterwards.
 */
export function piecesOf(data: DataTransfer): readonly Piece[] | null {
  const items = [...data.items].filter(({ kind }) => kind === "file");
  return items.length === 0 ? null : items.map(pieceOf).filter((piece) => piece !== null);
}
