// The page as `sfumato edit` serves it: with one drawing, which saving writes back.
import * as en from "../strings/en.js";
import type { Beside } from "./images.js";
import type { Convert, Opened } from "./open.js";
import { mostFileBytes, openFile } from "./open.js";
import type { Place, Saved } from "./place.js";

const words = en.files;

/** The drawing's name; null: the page does not come from the command. */
export function servedName(): string | null {
  const name = document.querySelector<HTMLMetaElement>('meta[name="sfumato-file"]')?.content;
  if (name === undefined) return null;
  try {
    return decodeURIComponent(name);
  } catch {
    // Bytes that are no UTF-8: shown as the command wrote them.
    return name;
  }
}

/** A request to the command; null: it has ended. */
async function ask(path: string, init: RequestInit = {}): Promise<Response | null> {
  return fetch(new URL(path, document.baseURI), { ...init, cache: "no-store" }).catch(() => null);
}

/** The drawing that the page was opened with. */
export async function openServed(name: string, convert: Convert): Promise<Opened> {
  const answer = await ask("drawing");
  if (!answer) return { kind: "problem", reason: words.commandEnded };
  if (!answer.ok) return { kind: "problem", reason: words.commandRefused(await answer.text()) };
  if (Number(answer.headers.get("Content-Length")) > mostFileBytes) return { kind: "problem", reason: words.tooLarge(name) };
  const opened = await openFile(new File([await answer.blob()], name), convert);
  const tag = answer.headers.get("ETag");
  if (opened.kind !== "drawing" || opened.isConverted || tag === null) return opened;
  return { ...opened, place: { ...opened.place, target: { kind: "served", tag } } };
}

/** Writes the file back, unless it has changed since `tag`. */
export async function saveServed(bytes: Uint8Array<ArrayBuffer>, place: Place, tag: string, anyway: boolean): Promise<Saved> {
  if (bytes.length > mostFileBytes) return { kind: "problem", reason: words.tooLarge(place.name) };
  const answer = await ask("drawing", { method: "PUT", body: bytes, headers: { "If-Match": anyway ? "*" : tag } });
  if (!answer) return { kind: "problem", reason: words.commandEnded };
  if (answer.status === 412) return { kind: "changed", reason: words.changedOnDisk(place.name) };
  const next = answer.headers.get("ETag");
  if (!answer.ok || next === null) return { kind: "problem", reason: words.commandRefused(await answer.text()) };
  return { kind: "saved", place: { ...place, target: { kind: "served", tag: next } } };
}

/** Files beside the drawing, as far as the command gives them. */
export const besideServed: Beside = {
  async bytes(href) {
    const answer = await ask(`file?${encodeURIComponent(href)}`);
    return answer?.ok ? new Uint8Array(await answer.arrayBuffer()) : null;
  },
};
