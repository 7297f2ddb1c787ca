// A file of another program is to be opened: it has shapes, but no curves that the editor could show.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { complaintOf } from "../../engine/complaint.js";
import type { Watch } from "../../engine/other-text.js";
import * as en from "../../strings/en.js";
import { useShell, type Foreign } from "../services.js";
import { Frame } from "./frame.js";

const words = en.dialogs;

function Body({ foreign }: { readonly foreign: Foreign }) {
  /** The share that is done; null: nothing is being done. */
  const share = useSignal<number | null>(null);
  const reason = useSignal<string | null>(null);
  const stop = useRef<AbortController | null>(null);
  // Closing the dialog ends the conversion.
  useEffect(() => () => stop.current?.abort(), []);
  const run = async (work: (watch: Watch) => Promise<void>) => {
    const own = (stop.current = new AbortController());
    const onProgress = (done: number) => (share.value = done);
    share.value = 0;
    reason.value = null;
    try {
      await work({ signal: own.signal, onProgress });
    } catch (error) {
      if (!own.signal.aborted) reason.value = complaintOf(error);
    }
    share.value = null;
  };
  const isBusy = share.value !== null;
  const choice = (label: string, work: (watch: Watch) => Promise<void>, isPrimary = false) => (
    <button
      type="button"
      class={isPrimary ? "button primary large" : "button large"}
      disabled={isBusy}
      onClick={() => void run(work)}
    >
      {label}
    </button>
  );
  const foot = (
    <>
      {isBusy ? (
        <button type="button" class="button large" onClick={() => stop.current?.abort()}>
          {words.cancelConverting}
        </button>
      ) : (
        choice(words.openAsIs, foreign.open)
      )}
      <span class="spacer" />
      {foreign.insert && choice(words.insertAsLayers, foreign.insert)}
      {choice(isBusy ? words.converting : words.convert, foreign.convert, true)}
    </>
  );
  return (
    <Frame title={words.holdsNoCurves(foreign.name)} class="small foreign" foot={foot}>
      <div class="dialog-body form">
        <p class="read">{words.foreignText}</p>
        <p class="read muted">{words.foreignNote}</p>
        {isBusy && <progress value={share.value ?? 0} aria-label={words.converting} />}
        {reason.value !== null && (
          <p class="read lines failure" role="alert">
            {reason.value}
          </p>
        )}
      </div>
    </Frame>
  );
}

export function ForeignDialog() {
  const foreign = useShell().services.foreign.value;
  return foreign && <Body foreign={foreign} />;
}
