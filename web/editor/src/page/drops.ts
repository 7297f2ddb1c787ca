// Files that are dropped anywhere on the page. What nobody takes, the browser would open instead of it.
import type { Documents } from "./documents.js";

const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;

export function listenToDrops(documents: Documents): void {
  document.addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = "copy";
  });
  document.addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    documents.dropEvent(event.dataTransfer!);
  });
}
