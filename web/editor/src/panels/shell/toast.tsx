// A message about the last action, with a way to undo it. One at a time; it stays longer under the pointer or
// with the focus.
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "../../icons.js";
import * as en from "../../strings/en.js";
import { useShell } from "../services.js";

/** Work in progress, with a button that stops it. */
function TaskView() {
  const { task } = useShell().editor;
  const now = task.value;
  if (!now) return null;
  return (
    <div class="toast">
      <Icon name="loader-circle" small />
      {now.text}
      <button type="button" onClick={now.stop}>
        {en.page.stopTask}
      </button>
    </div>
  );
}

/** Milliseconds. */
const STAYS = 5000;

export function ToastView() {
  const { toast } = useShell().editor;
  const now = toast.value;
  const timer = useRef(0);
  const wait = () => {
    window.clearTimeout(timer.current);
    timer.current = window.setTimeout(() => {
      toast.value = null;
    }, STAYS);
  };
  const stay = () => window.clearTimeout(timer.current);
  useEffect(() => {
    if (now) wait();
    return stay;
  }, [now]);
  return (
    <div class="toasts" role="status">
      <TaskView />
      {now && (
        <div
          class="toast"
          onPointerEnter={stay}
          onPointerLeave={wait}
          onFocusIn={stay}
          onFocusOut={wait}
        >
          {now.text}
          <button
            type="button"
            onClick={() => {
              toast.value = null;
              now.action?.run();
            }}
          >
            {now.action?.label ?? en.page.dismiss}
          </button>
        </div>
      )}
    </div>
  );
}
