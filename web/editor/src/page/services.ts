// The services that panels get besides the editor's state.
import type { DrawingEditor } from "../app/editor.js";
import { chosen } from "../app/selected.js";
import type { PictureCanvas } from "../canvas/renderer.js";
import type { Thumbs } from "../canvas/thumbs.js";
import { pageHost } from "../engine/page-host.js";
import { exporterOf, type Exporter } from "../engine/other-text.js";
import {
  copyPng,
  estimateSize,
  exportDrawing,
  exportName,
  exportTypes,
  nameOfSize,
  type ExportSource,
  type ExportWatch,
  type ExportWish,
} from "../files/export.js";
import { pickFile } from "../files/open.js";
import { saveExport, saveExports } from "../files/save.js";
import { onlyItems } from "../model/commands/index.js";
import type { Services } from "../panels/services.js";
import * as en from "../strings/en.js";
import type { Documents } from "./documents.js";
import { dataUri } from "./files.js";
import { itemOfHint, mendOf } from "./mend.js";
import { pickColor } from "./pick.js";
import { previewOf } from "./preview.js";
import { PhotoTracing } from "./tracing.js";

type Size = Pick<ExportWish, "width" | "height">;

/** Returns the engine that draws all of the drawing, or the selection alone. */
function exporterFor(editor: DrawingEditor, isSelectionOnly: boolean, signal = new AbortController().signal): Exporter {
  const { drawing, engine } = editor;
  if (!isSelectionOnly) return engine;
  return exporterOf(pageHost, onlyItems(drawing, chosen(editor)), engine.images, signal);
}

function sourceOf(editor: DrawingEditor, { isSelectionOnly = false }: ExportWish, watch: ExportWatch = {}): ExportSource {
  const { drawing, file } = editor;
  const engine = exporterFor(editor, isSelectionOnly, watch.signal);
  return { engine, text: drawing.text, name: file.value.name, artboard: drawing.artboard };
}

async function exportTo(editor: DrawingEditor, wishes: readonly ExportWish[], natural: Size, watch: ExportWatch): Promise<void> {
  const source = sourceOf(editor, wishes[0], watch);
  const notes = new Set<string>();
  const onNotes = (found: readonly string[]) => found.forEach((note) => notes.add(note));
  const make = (wish: ExportWish) => exportDrawing(wish, source, { ...watch, onNotes });
  const isSaved = wishes.length > 1 ? await saveSizes(wishes) : await saveOne(wishes[0]);
  if (!isSaved) throw new DOMException("left", "AbortError");
  if (notes.size > 0) editor.say(en.page.exportNotes([...notes].join("; ")));

  function saveSizes(sizes: readonly ExportWish[]) {
    const names = sizes.map((wish) => nameOfSize(source.name, wish, natural));
    return saveExports(names, (index) => make(sizes[index]));
  }

  function saveOne(wish: ExportWish) {
    const blob = make(wish);
    // A closed dialog must not leave a failure without a report.
    blob.catch(() => {});
    return saveExport(blob, exportName(wish, source.name), exportTypes[wish.format]);
  }
}

async function chooseTexture(editor: DrawingEditor) {
  const opened = await pickFile((text) => editor.engine.convert(text), "photo");
  if (!opened) return null;
  if (opened.kind !== "photo") {
    editor.say(opened.kind === "problem" ? opened.reason : en.page.noPicture);
    return null;
  }
  const { width, height, blob } = opened;
  return { href: await dataUri(blob), width, height };
}

export function servicesOf(editor: DrawingEditor, documents: Documents, picture: PictureCanvas, thumbs: Thumbs): Services {
  return {
    get version() {
      return editor.engine.version;
    },
    problem: documents.problem,
    foreign: documents.foreign,
    exportTo: (wishes, natural, watch) => exportTo(editor, wishes, natural, watch),
    copyPicture: (wish, watch) => copyPng(wish, sourceOf(editor, wish, watch), watch),
    estimate: (wish) => estimateSize(wish, sourceOf(editor, wish)),
    preview: async (viewport, transparent, isSelectionOnly) => {
      await editor.completeEdits();
      return previewOf(exporterFor(editor, isSelectionOnly), viewport, transparent);
    },
    trace: () => new PhotoTracing(editor, documents),
    autosaves: async () => documents.kept.value,
    recover: (id) => documents.recover(id),
    forget: (id) => documents.forget(id),
    pickColor: (stop) => pickColor(editor, stop),
    thumb: (handle) => thumbs.of(handle),
    itemOf: (hint) => itemOfHint(editor, picture, hint),
    mend: (hint) => mendOf(editor, picture, hint),
    chooseTexture: () => chooseTexture(editor),
  };
}
