// The folder of a drawing, which a person grants for the pictures that the drawing names.
import { directoryOpen } from "browser-fs-access";
import type { Beside } from "./images.js";
import { besideFiles, besideFolder } from "./images.js";

interface FolderPicker {
  showDirectoryPicker?(options: { id: string; mode: "read" }): Promise<FileSystemDirectoryHandle>;
}

/** Asks for a folder; null: the person chose none. To be called while a click is handled. @throws DOMException */
export async function chooseFolder(): Promise<Beside | null> {
  const { showDirectoryPicker } = globalThis as FolderPicker;
  try {
    // A handle finds single files on request; without it, browsers list all files at once.
    if (showDirectoryPicker) return besideFolder(await showDirectoryPicker({ id: "sfumato-folder", mode: "read" }));
    const files = await directoryOpen({ recursive: true });
    return besideFiles(files.filter((file) => file instanceof File));
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") return null;
    throw error;
  }
}
