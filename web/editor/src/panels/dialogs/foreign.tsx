// A file of another program is to be opened: it has shapes, but no curves that the editor could show.
import { useSignal } from "@preact/signals";
import { complaintOf } from "../../engine/complaint.js";
import * as en from "../../strings/en.js";
import { useShell, type Foreign } from "../services.js";
import { Frame } from "./frame.js";

const words = en.dialogs;

function Body({ foreign }: { readonly foreign: Foreign }) {
  const isBusy = useSignal(false);
  const reason = useSignal<string | null>(null);
  const run = async (work: () => Promise<void>) => {
    isBusy.value = true;
    reason.value = null;
    try {
      await work();
    } catch (error) {
      reason.value = complaintOf(error);
    }
    isBusy.value = false;
  };
  const choice = (label: string, work: () => Promise<void>, isPrimary = false) => (
    <button
      type="button"
      class={isPrimary ? "button primary large" : "button large"}
      disabled={isBusy.value}
      onClick={() => void run(work)}
    >
      {label}
    </button>
  );
  const foot = (
    <>
      {choice(words.openAsIs, foreign.open)}
      <span class="spacer" />
      {foreign.insert && choice(words.insertAsLayers, foreign.insert)}
      {choice(isBusy.value ? words.converting : words.convert, foreign.convert, true)}
    </>
  );
  return (
    <Frame title={words.holdsNoCurves(foreign.name)} class="small foreign" foot={foot}>
      <div class="dialog-body form">
        <p class="read">{words.foreignText}</p>
        <p class="read muted">{words.foreignNote}</p>
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
