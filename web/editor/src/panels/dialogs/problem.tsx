// A drawing that cannot be opened or drawn: the reason, the place, and the line itself.
import { useSignal } from "@preact/signals";
import * as en from "../../strings/en.js";
import { useShell, type Problem } from "../services.js";
import { Frame } from "./frame.js";

const words = en.dialogs;
/** Longer lines are cut around the place, characters. */
const AROUND = 60;

/** Returns the page's problem with a file, else the engine's problem with the drawing. */
function useProblem(): Problem | null {
  const { editor, services } = useShell();
  const status = editor.status.value;
  if (services.problem.value) return services.problem.value;
  if (status.kind === "failed")
    return { title: words.stopped, reason: status.reason, line: 0, column: 0, source: null };
  if (status.kind !== "problem") return null;
  const { reason, line, column } = status;
  const source = line > 0 ? (editor.drawing.text.split(/\r\n|\r|\n/)[line - 1] ?? null) : null;
  const help = editor.undoLabel.value === null ? words.fixFile : words.fixDrawing;
  return { title: words.cannotDraw, reason, line, column, source, help };
}

/** The part of a line around a column, and how far into it the column lies. */
function around(source: string, column: number): { text: string; at: number } {
  const place = Math.max(column - 1, 0);
  const from = Math.max(place - AROUND, 0);
  const to = Math.min(place + AROUND, source.length);
  const before = from > 0 ? "…" : "";
  return {
    text: before + source.slice(from, to) + (to < source.length ? "…" : ""),
    at: place - from + before.length,
  };
}

function Line({
  source,
  line,
  column,
}: {
  readonly source: string;
  readonly line: number;
  readonly column: number;
}) {
  const { text, at } = around(source, column);
  return (
    <pre class="problem-line" tabIndex={0} aria-label={words.lineOf(line)}>
      <span class="muted">{line} </span>
      {text.slice(0, at)}
      <mark>{text.slice(at, at + 1) || " "}</mark>
      {text.slice(at + 1)}
    </pre>
  );
}

export function ProblemDialog() {
  const { editor } = useShell();
  const problem = useProblem();
  const isShown = useSignal(false);
  if (!problem) return null;
  const { title, reason, line, column, source, help } = problem;
  const foot = (
    <>
      {source !== null && !isShown.value && (
        <button
          type="button"
          class="button large"
          onClick={() => {
            isShown.value = true;
          }}
        >
          {words.showLine}
        </button>
      )}
      <span class="spacer" />
      <button
        type="button"
        class="button primary large"
        onClick={() => {
          editor.dialog.value = null;
        }}
      >
        {words.goOn}
      </button>
    </>
  );
  return (
    <Frame title={title} class="small" foot={foot}>
      <div class="dialog-body form">
        <p class="read lines">{line > 0 ? en.engine.reasonAt(line, column, reason) : reason}</p>
        {help && <p class="read muted">{help}</p>}
        {isShown.value && source !== null && <Line source={source} line={line} column={column} />}
      </div>
    </Frame>
  );
}
