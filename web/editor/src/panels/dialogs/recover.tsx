// Drawings that this browser kept.
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { ago, date } from "../format.js";
import { useShell, type Autosave } from "../services.js";
import { StoredPicture } from "../welcome/stored.js";
import { Frame } from "./frame.js";

const words = en.dialogs;

export function RecoverDialog() {
  const { editor, services } = useShell();
  const list = useSignal<readonly Autosave[] | null>(null);
  const reason = useSignal<string | null>(null);
  const load = () =>
    services.autosaves().then(
      (found) => {
        list.value = found;
      },
      () => {
        reason.value = words.storageRefused;
      },
    );
  useEffect(() => void load(), []);
  const open = async (id: string) => {
    try {
      await services.recover(id);
      editor.dialog.value = null;
    } catch (error) {
      reason.value = error instanceof Error ? error.message : words.storageRefused;
    }
  };
  return (
    <Frame title={words.recover} class="small">
      <div class="dialog-body">
        {reason.value && (
          <p class="read failure" role="alert">
            {reason.value}
          </p>
        )}
        {list.value?.length === 0 && <p class="empty">{words.nothingKept}</p>}
        <ul class="kept-list">
          {list.value?.map(({ id, name, time, curves, picture }) => (
            <li key={id}>
              <StoredPicture picture={picture} />
              <span class="kept-name">
                <b>{name}</b>
                <span class="muted" title={date(time)}>
                  {words.keptAt(ago(time), curves)}
                </span>
              </span>
              <button type="button" class="button" onClick={() => void open(id)}>
                {words.openKept}
              </button>
              <IconButton
                icon="trash-2"
                label={words.forget(name)}
                onClick={() => void services.forget(id).then(load)}
              />
            </li>
          ))}
        </ul>
      </div>
    </Frame>
  );
}
