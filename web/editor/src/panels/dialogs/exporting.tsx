// What the export dialog finds out and does: a preview, an estimate, the work itself.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { ExportWish } from "../../files/export.js";
import { en } from "../../strings/en.js";
import { useShell } from "../services.js";

const words = en.dialogs;
/** An estimate is asked for when nothing was changed for this long, milliseconds. */
const REST = 300;

/** A picture of what would be written, made anew when the part changes. */
export function Preview({ wish }: { readonly wish: ExportWish }) {
  const { services } = useShell();
  const url = useSignal<string | null>(null);
  const transparent = wish.format === "png" && wish.transparent;
  useEffect(() => {
    let isOver = false;
    void services.preview(wish.viewport, transparent).then((made) => {
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
  }, [wish.viewport.join(), transparent]);
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

/** Does a work, and says in the dialog why it failed. */
export function useWork() {
  const { editor } = useShell();
  const isBusy = useSignal(false);
  const reason = useSignal<string | null>(null);
  const run = async (work: () => Promise<void>, done: string | null) => {
    isBusy.value = true;
    reason.value = null;
    try {
      await work();
      editor.dialog.value = null;
      if (done) editor.say(done);
    } catch (error) {
      // Closing the browser's own dialog is no failure.
      if (!(error instanceof DOMException && error.name === "AbortError")) {
        reason.value = error instanceof Error ? error.message : String(error);
      }
    }
    isBusy.value = false;
  };
  return { isBusy, reason, run };
}
