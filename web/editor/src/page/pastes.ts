// Data pasted anywhere on the page, except into fields.
import { isForPage } from "../app/keys.js";

/** The browser makes it unreadable after the event. */
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
