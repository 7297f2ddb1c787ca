// Files dropped anywhere on the page. The browser would open a file that is not handled in place of the page.
import { piecesOf, type Piece } from "../files/pieces.js";

const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;

export function listenToDrops(take: (pieces: readonly Piece[]) => void): void {
  document.addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = "copy";
  });
  document.addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    const pieces = piecesOf(event.dataTransfer!);
    if (pieces) take(pieces);
  });
}
