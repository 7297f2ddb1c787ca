// The five steps, done by the user: a card that watches, and can be closed at any time.
import { effect, untracked, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { Icon } from "../../icons.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { useShell } from "../services.js";
import { prepare, watches } from "./watch.js";

const words = en.tour;
/** The tick stands for this long before the next step, milliseconds. */
const PAUSE = 1100;

export function Tour() {
  const step = useShell().editor.tour.value;
  return step === null || step >= watches.length ? null : <Card key={step} step={step} />;
}

function Card({ step }: { readonly step: number }) {
  const { editor } = useShell();
  const isDone = useSignal(false);
  const leave = () => {
    editor.tour.value = null;
    editor.settings.tourDone.value = true;
  };
  const next = () => {
    if (step + 1 < watches.length) editor.tour.value = step + 1;
    else {
      leave();
      if (isDone.peek()) editor.say(words.finished);
    }
  };
  useEffect(() => {
    prepare(editor, step);
    const isReached = untracked(() => watches[step](editor));
    let timer = 0;
    const stop = effect(() => {
      if (isDone.peek() || !isReached()) return;
      isDone.value = true;
      editor.announcement.value = words.done;
      timer = window.setTimeout(next, PAUSE);
    });
    return () => {
      stop();
      window.clearTimeout(timer);
    };
  }, [step]);
  const { title, text } = words.steps[step];
  const isLast = step === watches.length - 1;
  return (
    <section class="popover tour-card" role="complementary" aria-label={words.label} data-region>
      <div class="tour-card-head">
        <span class="tour-dots" aria-hidden="true">
          {watches.map((_, k) => (
            <i
              key={k}
              class={k < step || (k === step && isDone.value) ? "past" : k === step ? "now" : ""}
            />
          ))}
        </span>
        <span class="visually-hidden">{words.stepOf(step + 1, watches.length)}</span>
        <IconButton small icon="x" label={words.leave} onClick={leave} />
      </div>
      <div aria-live="polite">
        <h2>
          {isDone.value && <Icon name="check" />}
          {title}
        </h2>
        <p class="read">{text}</p>
      </div>
      <div class="tour-card-foot">
        <button type="button" class="button quiet" onClick={leave}>
          {words.leave}
        </button>
        <button type="button" class={isDone.value ? "button primary" : "button"} onClick={next}>
          {isLast ? words.end : isDone.value ? words.next : words.skip}
        </button>
      </div>
    </section>
  );
}
