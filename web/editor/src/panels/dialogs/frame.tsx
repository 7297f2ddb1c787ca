// A modal dialog: head, what it holds, foot. The browser keeps the focus within and gives it back.
import type { ComponentChildren } from "preact";
import { useId, useLayoutEffect, useRef } from "preact/hooks";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { useShell } from "../services.js";

const words = en.dialogs;

interface FrameProps {
  readonly title: string;
  readonly class: string;
  /** In the head, between the title and the cross. */
  readonly head?: ComponentChildren;
  readonly foot?: ComponentChildren;
  readonly children: ComponentChildren;
}

export function Frame(props: FrameProps) {
  const { editor } = useShell();
  const dialog = useRef<HTMLDialogElement>(null);
  const id = useId();
  const close = () => {
    editor.dialog.value = null;
  };
  // With the page that shows it, not a frame later: a key that comes at once is the dialog's.
  useLayoutEffect(() => {
    const element = dialog.current;
    element?.showModal();
    element?.focus();
    return () => element?.close();
  }, []);
  // However the browser closed it. When another one takes its place, that one stays.
  const closed = () => dialog.current && close();
  return (
    <dialog
      ref={dialog}
      class={`dialog ${props.class}`}
      aria-labelledby={id}
      tabIndex={-1}
      onCancel={close}
      onClose={closed}
      onKeyDown={(event) => event.key !== "Escape" && event.stopPropagation()}
    >
      <div class="dialog-head">
        <h2 id={id}>{props.title}</h2>
        {props.head}
        <IconButton icon="x" label={words.close} onClick={close} />
      </div>
      {props.children}
      {props.foot && <div class="dialog-foot">{props.foot}</div>}
    </dialog>
  );
}
