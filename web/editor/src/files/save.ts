// Drawings to files: the one they came from, one that is chosen, or a download.
import { fileSave, supported } from "browser-fs-access";
import * as en from "../strings/en.js";
import type { Place, Saved } from "./place.js";
import { withExtension } from "./place.js";
import { saveServed } from "./served.js";
import { bytesOf } from "./text.js";

const words = en.files;

/** Why the disk did not take a file. */
export function reasonOf(error: unknown): string {
  const name = error instanceof DOMException ? error.name : "";
  if (name === "NotAllowedError" || name === "SecurityError") return words.notAllowed;
  if (name === "NotFoundError") return words.gone;
  if (name === "QuotaExceededError") return words.diskFull;
  return words.diskRefused;
}

const isAbort = (error: unknown) => error instanceof DOMException && error.name === "AbortError";

interface Asking {
  requestPermission?(options: { mode: "readwrite" }): Promise<PermissionState>;
}

/** Asks where the browser wants that: of what was dropped, or recovered, it has not asked yet. */
async function askForPermission(handle: FileSystemFileHandle & Asking): Promise<void> {
  const state = await (handle.requestPermission?.({ mode: "readwrite" }) ?? "granted");
  if (state !== "granted") throw new DOMException("refused", "NotAllowedError");
}

type HandleTarget = Extract<Place["target"], { kind: "handle" }>;

async function saveToHandle(bytes: Uint8Array<ArrayBuffer>, place: Place, target: HandleTarget, anyway: boolean): Promise<Saved> {
  const { handle } = target;
  try {
    await askForPermission(handle);
    const now = await handle.getFile();
    if (!anyway && now.lastModified !== target.modified) return { kind: "changed", reason: words.changedOnDisk(place.name) };
  } catch (error) {
    if (!anyway) return { kind: "problem", reason: reasonOf(error) };
  }
  try {
    await fileSave(new Blob([bytes]), { fileName: place.name }, handle, true);
    const { lastModified } = await handle.getFile();
    return { kind: "saved", place: { ...place, target: { kind: "handle", handle, modified: lastModified } } };
  } catch (error) {
    return isAbort(error) ? { kind: "cancelled" } : { kind: "problem", reason: reasonOf(error) };
  }
}

/**
 * Saves to where the drawing came from; asks, or downloads, where that is nowhere. A file holds the
 * old text or the new one, whole.
 * @param anyway replaces what somebody else has written since
 */
export async function save(text: string, place: Place, anyway = false): Promise<Saved> {
  const { target } = place;
  if (target.kind === "none") return saveAs(text, place);
  const bytes = await bytesOf(text, place.form);
  if (target.kind === "handle") return saveToHandle(bytes, place, target, anyway);
  return saveServed(bytes, place, target.tag, anyway);
}

/** Asks for a name; where the browser has no such dialog, downloads. */
export async function saveAs(text: string, place: Place): Promise<Saved> {
  const { packed } = place.form;
  const name = withExtension(place.name, packed ? "svgz" : "svg");
  const kinds = { extensions: packed ? [".svgz"] : [".svg"], mimeTypes: ["image/svg+xml"] };
  const type = packed ? "application/gzip" : "image/svg+xml";
  try {
    const blob = bytesOf(text, place.form).then((bytes) => new Blob([bytes], { type }));
    const handle = await fileSave(blob, { fileName: name, description: words.drawings, ...kinds, id: "sfumato" });
    if (!handle) return { kind: "downloaded", place: { ...place, name } };
    const { lastModified } = await handle.getFile();
    const target = { kind: "handle", handle, modified: lastModified } as const;
    return { kind: "saved", place: { name: handle.name, form: place.form, target } };
  } catch (error) {
    return isAbort(error) ? { kind: "cancelled" } : { kind: "problem", reason: reasonOf(error) };
  }
}

/** Whether save dialogs are there; else everything is downloaded. */
export const canChoosePlace = supported;

/** Removes the empty file that the browser made when a place was chosen and nothing was written. */
async function removeEmpty(handle: (FileSystemFileHandle & { remove?(): Promise<void> }) | null): Promise<void> {
  try {
    if (handle && (await handle.getFile()).size === 0) await handle.remove?.();
  } catch {
    // An empty file stays.
  }
}

/** A file that was made of a drawing, to where the person says. false: they left the dialog. @throws Error in words */
export async function saveExport(blob: Promise<Blob>, name: string, type: string): Promise<boolean> {
  let chosen: FileSystemFileHandle | null = null;
  const choose = (handle: FileSystemFileHandle | null): null => {
    chosen = handle;
    return null;
  };
  try {
    const options = { fileName: name, extensions: [name.slice(name.lastIndexOf("."))], mimeTypes: [type] };
    await fileSave(blob, { ...options, id: "sfumato-export" }, null, false, choose);
    return true;
  } catch (error) {
    await removeEmpty(chosen);
    if (isAbort(error)) return false;
    throw error instanceof DOMException ? new Error(reasonOf(error)) : error;
  }
}


type FolderPicker = (options: { id: string; mode: "readwrite" }) => Promise<FileSystemDirectoryHandle>;

/** Asks for a folder; null: this browser has no such dialog. */
async function chosenFolder(): Promise<FileSystemDirectoryHandle | null> {
  const { showDirectoryPicker } = globalThis as { showDirectoryPicker?: FolderPicker };
  return canChoosePlace && showDirectoryPicker ? showDirectoryPicker({ id: "sfumato-export", mode: "readwrite" }) : null;
}

/** Milliseconds until a browser has begun a download. */
const downloadTime = 60_000;

function download(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), downloadTime);
}

async function writeInto(folder: FileSystemDirectoryHandle, blob: Blob, name: string): Promise<void> {
  const handle = await folder.getFileHandle(name, { create: true });
  try {
    const stream = await handle.createWritable();
    await stream.write(blob);
    await stream.close();
  } catch (error) {
    await removeEmpty(handle);
    throw error;
  }
}

/**
 * Several files to a folder that the person chooses, or as downloads. false: they left the dialog.
 * @param make makes the files one after another, so that only one is in memory
 * @throws Error in words
 */
export async function saveExports(names: readonly string[], make: (index: number) => Promise<Blob>): Promise<boolean> {
  try {
    const folder = await chosenFolder();
    for (const [index, name] of names.entries()) {
      const blob = await make(index);
      if (folder) await writeInto(folder, blob, name);
      else download(blob, name);
    }
    return true;
  } catch (error) {
    if (isAbort(error)) return false;
    throw error instanceof DOMException ? new Error(reasonOf(error)) : error;
  }
}
