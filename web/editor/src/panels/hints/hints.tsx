// Hints of lint: docked below the stage, or a tab of the phone's sheet.
import { signal, useSignal } from "@preact/signals";
import { useLayoutEffect } from "preact/hooks";
import type { Hint } from "../../engine/types.js";
import { mapped } from "../../geometry/affine.js";
import { Icon } from "../../icons.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { Resizer } from "../controls/resizer.js";
import { useShell } from "../services.js";
import { itemsOf, placeOf, showHint } from "./show.js";

const words = en.dialogs;
const hiddenRules = signal<ReadonlySet<string>>(new Set());
/** The hint that the pointer or the focus is on: its place in the drawing of then is ringed. */
const current = signal<{ readonly hint: Hint; readonly revision: number } | null>(null);

function HintRow({ hint }: { readonly hint: Hint }) {
  const shell = useShell();
  const { editor, services } = shell;
  const item = services.itemOf(hint);
  const repair = services.mend(hint);
  const look = (on: boolean) => {
    current.value = on ? { hint, revision: editor.drawing.revision } : null;
    editor.hovered.value = on && item ? item.handle : null;
  };
  const isCurrent = current.value?.hint === hint;
  // A row that is removed gets no pointerleave event.
  useLayoutEffect(() => () => void (current.peek()?.hint === hint && look(false)), [hint]);
  const go = () => showHint(shell, hint);
  const names = [
    "hint",
    hint.severity === "warning" ? "warn" : "info",
    isCurrent ? "current" : "",
  ];
  return (
    <li
      class={names.filter(Boolean).join(" ")}
      onPointerEnter={() => look(true)}
      onPointerLeave={() => look(false)}
    >
      <Icon name={hint.severity === "warning" ? "triangle-alert" : "info"} />
      <button
        type="button"
        class="hint-text"
        onClick={go}
        onFocus={() => look(true)}
        onBlur={() => look(false)}
      >
        <strong>{hint.message}</strong>
        {item && (
          <span class="muted">
            {item.parent ? words.hintIn(item.name, item.parent.name) : words.hintOf(item.name)}
          </span>
        )}
      </button>
      <div class="actions">
        {repair && (
          <button type="button" class="button" onClick={repair.run}>
            {repair.label}
          </button>
        )}
        {!repair && itemsOf(shell, hint).length > 0 && (
          <button
            type="button"
            class="button"
            aria-label={words.showHintOf(hint.message)}
            onClick={go}
          >
            {words.showHint}
          </button>
        )}
        <IconButton
          small
          icon="eye-off"
          label={words.hideRule}
          onClick={() => {
            hiddenRules.value = new Set([...hiddenRules.value, hint.rule]);
          }}
        />
      </div>
    </li>
  );
}

export function HintList() {
  const { editor } = useShell();
  const hidden = hiddenRules.value;
  const all = editor.hints.value;
  const shown = all.filter(({ rule }) => !hidden.has(rule));
  if (all.length === 0) {
    return <p class="empty">{editor.hintsKnown.value ? words.noHints : words.lookingForHints}</p>;
  }
  return (
    <>
      <ul class="hint-list">
        {shown.map((hint) => (
          <HintRow key={`${hint.rule} ${hint.offset} ${hint.stackItem} ${hint.at} ${hint.message}`} hint={hint} />
        ))}
      </ul>
      {shown.length < all.length && (
        <button
          type="button"
          class="button quiet hint-more"
          onClick={() => {
            hiddenRules.value = new Set();
          }}
        >
          {words.showHidden(all.length - shown.length)}
        </button>
      )}
    </>
  );
}

/** Below the stage, which grows smaller by it. */
export function HintsDock() {
  const { editor } = useShell();
  const height = useSignal(240);
  if (!editor.hintsShown.value) return null;
  return (
    <section
      class="hints"
      aria-label={words.hints}
      data-region
      style={{ "--hints": `${height.value}px` }}
    >
      <Resizer
        kind="line"
        label={words.hintsHeight}
        value={height.value}
        min={96}
        max={480}
        sign={-1}
        onChange={(to) => {
          height.value = to;
        }}
      />
      <div class="section-head">
        <h2>
          {words.hints} <span class="badge">{editor.hints.value.length}</span>
        </h2>
        <IconButton
          small
          icon="x"
          label={words.closeHints}
          onClick={() => {
            editor.hintsShown.value = false;
          }}
        />
      </div>
      <HintList />
    </section>
  );
}

/** A ring at the place of the current hint; within the stage. */
export function HintRing() {
  const { editor } = useShell();
  const { hint, revision } = current.value ?? {};
  // After a change of the drawing this place may not exist.
  const at = hint && revision === editor.drawing.revision ? placeOf(editor, hint) : null;
  if (!at) return null;
  // Read here, so that the ring follows the view and the stage.
  void editor.view.value;
  void editor.stage.value;
  const [x, y] = mapped(editor.stageFromArtboard(), at);
  return (
    <svg
      class="leak"
      viewBox="0 0 40 40"
      aria-hidden="true"
      style={{ left: `${x - 20}px`, top: `${y - 20}px` }}
    >
      <circle cx="20" cy="20" r="17" />
      <circle class="in" cx="20" cy="20" r="17" />
    </svg>
  );
}
