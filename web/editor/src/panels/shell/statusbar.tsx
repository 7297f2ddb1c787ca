// The bar below: what the tool does, hints, whether the picture is exact, place, surround, zoom.
import { useSignal, useSignalEffect } from "@preact/signals";
import type { EngineStatus } from "../../engine/types.js";
import { Icon, type IconName } from "../../icons.js";
import * as en from "../../strings/en.js";
import { openMenu } from "../controls/menu.js";
import { radioKeys } from "../controls/radio.js";
import { decimal } from "../format.js";
import { zoomMenu } from "../menus/main.js";
import { useShell } from "../services.js";

const words = en.panels;
/** "Refining…" is not shown sooner than this, milliseconds. */
const PATIENCE = 150;

function ToolHint() {
  const { tool } = useShell().editor;
  return (
    <span class="status-hint">
      <b>{words.tool[tool.value]}</b> {words.toolHint[tool.value]}
    </span>
  );
}

function HintsButton() {
  const { editor } = useShell();
  const count = editor.hints.value.length;
  const isUnread = editor.status.value.kind === "problem" || editor.status.value.kind === "failed";
  // Nobody has looked for hints in what cannot be drawn.
  if (count === 0 && isUnread) return null;
  const isLooking = count === 0 && !editor.hintsKnown.value;
  const state = count > 0 ? "some" : isLooking ? "looking" : "";
  return (
    <button
      type="button"
      class={`status-button hints-button ${state}`}
      aria-expanded={editor.hintsShown.value}
      onClick={() => {
        editor.hintsShown.value = !editor.hintsShown.value;
      }}
    >
      <Icon name={count > 0 ? "triangle-alert" : isLooking ? "search" : "check"} small />
      {isLooking ? words.hintsLooking : words.hintCount(count)}
    </button>
  );
}

/** Returns the engine's state; "refining" only once it is older than PATIENCE. */
function usePatientStatus() {
  const { editor } = useShell();
  const shown = useSignal<EngineStatus>(editor.status.peek());
  useSignalEffect(() => {
    const now = editor.status.value;
    if (now.kind !== "refining" || shown.peek().kind === "refining") {
      shown.value = now;
      return;
    }
    const timer = window.setTimeout(() => {
      shown.value = now;
    }, PATIENCE);
    return () => window.clearTimeout(timer);
  });
  return shown.value;
}

const icons: Readonly<Record<EngineStatus["kind"], IconName>> = {
  empty: "check",
  exact: "check",
  refining: "loader-circle",
  problem: "circle-alert",
  failed: "circle-alert",
};

function Engine() {
  const { editor } = useShell();
  const status = usePatientStatus();
  const time =
    "milliseconds" in status
      ? words.milliseconds(decimal(status.milliseconds, status.milliseconds < 10 ? 1 : 0))
      : null;
  const face = (
    <>
      <Icon name={icons[status.kind]} small />
      <span class="status-word">{words.status[status.kind]}</span>
    </>
  );
  if (status.kind === "problem" || status.kind === "failed") {
    return (
      <button
        type="button"
        class="status-button bad"
        data-tip={words.showProblem}
        onClick={() => {
          editor.dialog.value = { kind: "problem" };
        }}
      >
        {face}
      </button>
    );
  }
  return (
    <span
      class={`status-item engine ${status.kind === "exact" ? "ok" : ""}`}
      data-tip={status.kind === "exact" ? words.exactTip(time) : undefined}
    >
      {face}
    </span>
  );
}

/** How it stands with exact pixels; pressed, it turns them on or off. */
function ExactPixels() {
  const { editor } = useShell();
  const state = editor.exactState.value;
  const word =
    state.kind === "gathering"
      ? words.exactStates.gathering(decimal(Math.floor(100 * state.share), 0))
      : words.exactStates[state.kind];
  const tip = state.kind === "none" ? words.exactStateTips.none(state.reason) : words.exactStateTips[state.kind];
  return (
    <button
      type="button"
      class="status-button"
      aria-label={word}
      aria-pressed={state.kind !== "off"}
      data-tip={tip}
      onClick={() => editor.command("exact-pixels")}
    >
      <Icon name={state.kind === "exact" ? "check" : "scan-line"} small />
      <span class="desk-wide">{word}</span>
    </button>
  );
}

function Place() {
  const { pointer } = useShell().editor;
  const at = pointer.value;
  if (!at) return <span class="status-item place desk-wide" />;
  return (
    <span class="status-item place desk-wide muted">
      {words.position(decimal(at[0], 1), decimal(at[1], 1))}
    </span>
  );
}

function Surrounds() {
  const { surround } = useShell().editor.settings;
  return (
    <span class="surrounds" role="radiogroup" aria-label={words.surround} onKeyDown={radioKeys()}>
      {(["dark", "mid", "light"] as const).map((name) => (
        <button
          key={name}
          type="button"
          role="radio"
          class={`surround-${name}`}
          aria-checked={surround.value === name}
          tabIndex={surround.value === name ? 0 : -1}
          aria-label={words.surrounds[name]}
          data-tip={words.surrounds[name]}
          onClick={() => {
            surround.value = name;
          }}
        />
      ))}
    </span>
  );
}

function Zoom() {
  const { view } = useShell().editor;
  const percent = decimal(view.value.zoom * 100, view.value.zoom < 0.1 ? 1 : 0);
  return (
    <button
      type="button"
      class="status-button zoom"
      aria-haspopup="menu"
      aria-label={words.zoom(percent)}
      onClick={(event) => openMenu(words.zoom(percent), zoomMenu(), event.currentTarget)}
    >
      {words.percent(percent)}
      <Icon name="chevron-up" small />
    </button>
  );
}

export function StatusBar() {
  return (
    <footer class="status" data-region>
      <ToolHint />
      <HintsButton />
      <Engine />
      <ExactPixels />
      <Place />
      <Surrounds />
      <Zoom />
    </footer>
  );
}
