// The names in docs/editor.md are names that the editor shows.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import * as en from "../../../web/editor/src/strings/en.js";

const GUIDE = new URL("../../../docs/editor.md", import.meta.url);

/** Returns all texts of a part of the strings; those with a count or a name are functions, and left out. */
function textsOf(part: unknown): string[] {
  if (typeof part === "string") return [part];
  return part !== null && typeof part === "object" ? Object.values(part).flatMap(textsOf) : [];
}

/** Returns the phrases in italics, without line breaks; with figures in them they are examples. */
function namesIn(text: string): string[] {
  const found = text.matchAll(/(?<!\*)\*([^*]+)\*(?!\*)/g);
  return [...found].map(([, name]) => name.replace(/\s+/g, " ")).filter((name) => !/\d/.test(name));
}

test("the guide calls everything by its name", () => {
  const plain = (text: string) => text.replace(/…$/, "").replaceAll("’", "'");
  const shown = new Set(textsOf(en).map(plain));
  const unknown = namesIn(readFileSync(GUIDE, "utf8")).filter((name) => !shown.has(plain(name)));
  expect(unknown).toEqual([]);
});
