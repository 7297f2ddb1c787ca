// What is pasted anywhere on the page, but into fields.
import { isForPage } from "../app/keys.js";

/** The browser lets nobody read it after the event. */
export interface Pasted {
  readonly files: readonly File[];
  readonly text: string;
}

export function listenToPastes(take: (pasted: Pasted) => void): void {
  document.addEventListener("paste", (event) => {
    const { clipboardData } = event;
    if (!clipboardData || !isForPage()) return;
    event.preventDefault();
    take({ files: [...clipboardData.files], text: clipboardData.getData("text/plain") });
  });
}
