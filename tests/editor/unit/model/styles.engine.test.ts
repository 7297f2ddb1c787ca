// The model's styles equal the engine's: visibility, opacity, blend mode, and the colours of stops, with all kinds
// of selectors and var().
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test, vi } from "vitest";
import { openDrawing } from "../../../../web/editor/src/model/drawing.js";
import { gradientOf } from "../../../../web/editor/src/model/gradients.js";
import { readCommon } from "../../../../web/editor/src/model/item-reading.js";
import type { CurveItem, Drawing, Item } from "../../../../web/editor/src/model/types.js";
import { keywordOf } from "../../../../web/editor/src/source/css.js";
import { Styles } from "../../../../web/editor/src/source/styles.js";
import * as limits from "../../../../web/editor/src/source/limits.js";
import type { ElementNode } from "../../../../web/editor/src/source/tree.js";
import { randomNumbers, repository } from "../corpus.js";
import { styledDocument } from "./style-documents.js";

const modulePath = process.env.SFUMATO_WASM ?? join(repository, "build-wasm/sfumato.wasm");
/** SFUMATO_SEEDS: number of random documents. */
const seeds = Number(process.env.SFUMATO_SEEDS ?? 1000);

// These tests generate much input, and machines may be busy.
vi.setConfig({ testTimeout: 120_000 + 240 * seeds });

interface EngineContext {
  read(text: string): { write(): string; free(): void };
}

async function engine(): Promise<EngineContext> {
  const library = (await import(join(repository, "web/wasm/sfumato.mjs"))) as {
    loadSfumato(bytes: Uint8Array): Promise<{ context(): EngineContext }>;
  };
  return (await library.loadSfumato(readFileSync(modulePath))).context();
}

function isDisplayed(styles: Styles, element: ElementNode): boolean {
  return keywordOf(styles.value(element, "display") ?? "") !== "none";
}

/** Returns visible curves, which may be in a group that is itself invisible. */
function* shownCurves(styles: Styles, items: readonly Item[]): Iterable<CurveItem> {
  for (const item of items) {
    if (!isDisplayed(styles, item.element)) continue;
    if (item.kind === "curve" && !item.hidden) yield item;
    yield* shownCurves(styles, item.children);
  }
}

/** Returns whether the whole document is composited, so that the engine makes it a part of its layer. */
function isComposited(d: Drawing): boolean {
  const { opacity, blend } = readCommon(d.root, new Styles(d.text, d.root));
  return opacity !== 1 || blend !== "normal";
}

/** Returns, for each layer with visible curves, its compositing, and the stops of each curve. */
function said(d: Drawing, withCompositing: boolean) {
  const styles = new Styles(d.text, d.root);
  const isShown = isDisplayed(styles, d.root);
  const layers = [...d.all()].filter(({ kind }) => isShown && kind === "layer");
  const shown = layers.map((layer) => ({
    ...(withCompositing ? { opacity: layer.opacity, blend: layer.blend } : {}),
    curves: [...shownCurves(styles, layer.hidden ? [] : [layer])].map(({ left }) =>
      left.color.kind === "paint" ? gradientOf(d, left.color.href)?.stops : left.color,
    ),
  }));
  return { background: d.background, layers: shown.filter(({ curves }) => curves.length > 0) };
}

/** Rounds numbers as the engine writes colours. */
const rounded = (value: unknown): unknown =>
  JSON.parse(JSON.stringify(value, (_, one) => (typeof one === "number" ? +one.toFixed(2) : one)));

/** Returns the model's and the engine's description of a document. */
function bothSay(context: EngineContext, text: string): [model: unknown, engine: unknown] {
  const document = context.read(text);
  const own = openDrawing(text);
  const isWhole = !isComposited(own);
  const read = rounded(said(openDrawing(document.write()), isWhole));
  document.free();
  return [rounded(said(own, isWhole)), read];
}

/** Returns documents whose var() and selectors are just within a limit, or just beyond it. */
function* documentsAtLimits(): Iterable<string> {
  const document = (sheet: string, content: string) =>
    `<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 90 90" sf:version="1"><style>${sheet}</style>${content}</svg>`;
  const curve = (left: string) => `<polyline points="0 1 90 9" sf:left="${left}"/>`;
  const stopped = (sheet: string) =>
    document(
      `stop{${sheet}}`,
      `<linearGradient id="g" gradientUnits="userSpaceOnUse" x2="9"><stop/></linearGradient><g sf:diffuse="true">${curve("url(#g)")}</g>`,
    );
  const { VARIABLE_DEPTH, VARIABLE_VALUE_BYTES } = limits;
  for (let depth = VARIABLE_DEPTH - 3; depth < VARIABLE_DEPTH + 2; depth += 1) {
    const chain = Array.from({ length: depth }, (_, i) => `--v${i}:var(--v${i + 1});`).join("");
    yield stopped(`${chain}--v${depth}:lime;stop-color:var(--v0,red)`);
    yield stopped(`stop-color:${"var(--x,".repeat(depth)}lime${")".repeat(depth)}`);
  }
  for (let bytes = -60; bytes < 0; bytes += 1) {
    // The text is counted once when read and once when substituted.
    const long = "x".repeat(VARIABLE_VALUE_BYTES / 2 + bytes);
    yield stopped(
      `--v:${long};stop-color:var(--c,lime);--c:var(--v) lime;stop-color:var(--c,lime)`,
    );
    yield stopped(`--v:/*ö${long}*/ lime;stop-color:var(--v)`);
  }
  const rules = `${"g ".repeat(20)}x polyline{display:none}`.repeat(30);
  const curves = `${"<g>".repeat(200)}${curve("red").repeat(3000)}${"</g>".repeat(200)}`;
  yield document(`g polyline{display:none}${rules}`, `<g sf:diffuse="true">${curves}</g>`);
}

describe.skipIf(!existsSync(modulePath))(`styles (SFUMATO_WASM: ${modulePath})`, () => {
  test("say to the model what they say to the engine", async () => {
    const context = await engine();
    for (let seed = 1; seed <= seeds; seed += 1) {
      const text = styledDocument(randomNumbers(seed));
      const [model, read] = bothSay(context, text);
      expect(model, `seed ${seed}\n${text}`).toEqual(read);
    }
  });

  test("have limits that both reach at the same place", async () => {
    const context = await engine();
    const colors = new Set<string>();
    for (const text of documentsAtLimits()) {
      const [model, read] = bothSay(context, text);
      expect(model, text.slice(0, 2000)).toEqual(read);
      colors.add(JSON.stringify(read));
    }
    // Within limits and beyond them.
    expect(colors.size).toBe(3);
  });
});
