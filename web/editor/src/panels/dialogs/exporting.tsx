// The work of the export dialog: a preview, an estimate, the export itself.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { complaintOf } from "../../engine/complaint.js";
import type { ExportWatch, ExportWish } from "../../files/export.js";
import * as en from "../../strings/en.js";
import { useShell } from "../services.js";

const words = en.dialogs;
/** An estimate is made when nothing was changed for this long, milliseconds. */
const REST = 300;

/** A preview of the export, updated when the part changes. */
export function Preview({ wish }: { readonly wish: ExportWish }) {
  const { services } = useShell();
  const url = useSignal<string | null>(null);
  const transparent = wish.transparent && wish.format !== "html";
  const isAlone = wish.isSelectionOnly ?? false;
  useEffect(() => {
    let isOver = false;
    void services.preview(wish.viewport, transparent, isAlone).then((made) => {
      if (isOver) {
        if (made) URL.revokeObjectURL(made);
        return;
      }
      if (url.peek()) URL.revokeObjectURL(url.peek()!);
      url.value = made;
    });
    return () => {
      isOver = true;
    };
  }, [wish.viewport.join(), transparent, isAlone]);
  useEffect(() => () => void (url.peek() && URL.revokeObjectURL(url.peek()!)), []);
  return (
    <div class="export-view">
      {url.value && (
        <img class={transparent ? "chequer" : undefined} src={url.value} alt={words.previewAlt} />
      )}
    </div>
  );
}

export function useEstimate(wish: ExportWish): number | null {
  const { services } = useShell();
  const size = useSignal<number | null>(null);
  useEffect(() => {
    let isOver = false;
    size.value = null;
    const timer = window.setTimeout(
      () => void services.estimate(wish).then((found) => !isOver && (size.value = found)),
      REST,
    );
    return () => {
      isOver = true;
      window.clearTimeout(timer);
    };
  }, [JSON.stringify(wish)]);
  return size.value;
}

type Stage = "begin" | "draw" | "pack";

/** Does a work, and says in the dialog how far it is and why it failed. It ends with the dialog. */
export function useWork() {
  const { editor } = useShell();
  /** null: nothing is done. */
  const stage = useSignal<Stage | null>(null);
  const reason = useSignal<string | null>(null);
  const stop = useRef<AbortController | null>(null);
  useEffect(() => () => stop.current?.abort(), []);
  const run = async (work: (watch: ExportWatch) => Promise<void>, done: string | null) => {
    const own = new AbortController();
    const { signal } = own;
    stop.current = own;
    stage.value = "begin";
    reason.value = null;
    // Work that has ended reports no further progress.
    const onStage = (now: Stage) => {
      if (!signal.aborted) stage.value = now;
    };
    try {
      await work({ signal, onStage });
      editor.dialog.value = null;
      if (done) editor.say(done);
    } catch (error) {
      // Leaving this dialog, or the browser's own, is no failure.
      if (!(error instanceof DOMException && error.name === "AbortError")) {
        reason.value = complaintOf(error);
      }
    }
    own.abort();
    stage.value = null;
  };
  return { stage, reason, run };
}
