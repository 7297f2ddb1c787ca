// The services that panels get besides the editor's state.
import type { DrawingEditor } from "../app/editor.js";
import type { PictureCanvas } from "../canvas/renderer.js";
import type { Thumbs } from "../canvas/thumbs.js";
import { copyPng, estimateSize, exportDrawing, exportTypes, type ExportWatch, type ExportWish } from "../files/export.js";
import { pickFile } from "../files/open.js";
import { saveExport } from "../files/save.js";
import type { Services } from "../panels/services.js";
import { en } from "../strings/en.js";
import type { Documents } from "./documents.js";
import { dataUri } from "./files.js";
import { itemOfHint, mendOf } from "./mend.js";
import { pickColor } from "./pick.js";
import { previewOf } from "./preview.js";
import { PhotoTracing } from "./tracing.js";

function sourceOf(editor: DrawingEditor) {
  const { drawing, engine, file } = editor;
  return { engine, text: drawing.text, name: file.value.name, artboard: drawing.artboard };
}

async function exportTo(editor: DrawingEditor, wish: ExportWish, watch: ExportWatch): Promise<void> {
  const blob = exportDrawing(wish, sourceOf(editor), watch);
  // A closed dialog must not leave a failure without a report.
  blob.catch(() => {});
  const isSaved = await saveExport(blob, editor.file.value.name, exportTypes[wish.format], wish.format);
  if (!isSaved) throw new DOMException("left", "AbortError");
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
    exportTo: (wish, watch) => exportTo(editor, wish, watch),
    copyPicture: (wish, watch) => copyPng(wish, sourceOf(editor), watch),
    estimate: (wish) => estimateSize(wish, sourceOf(editor)),
    preview: async (viewport, transparent) => {
      await editor.completeEdits();
      return previewOf(editor, viewport, transparent);
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
