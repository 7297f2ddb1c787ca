// Trace photo: what is to become of it, and what it has become so far.
import { useSignal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { Icon } from "../../icons.js";
import * as en from "../../strings/en.js";
import { Segments } from "../controls/segments.js";
import { setting } from "../controls/sink.js";
import { Slider } from "../controls/slider.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import { Check } from "./check.js";
import { Frame } from "./frame.js";
import { TraceStageView } from "./trace-view.js";
import { pointsOf, TraceRun, type TraceChoice } from "./tracing.js";

const words = en.trace;
/** The library scales larger photos to this size, pixels on the longer side. */
const MOST_SIDE = 1024;
const MOST_SMOOTH = 8;

const count = (number: number) => number.toLocaleString("en");

/** The last choice, kept until the page closes. */
let remembered: TraceChoice = { detail: 0.5, smooth: 0, stops: "normal", isSharp: false };

interface FormProps {
  readonly choice: TraceChoice;
  readonly change: (to: Partial<TraceChoice>) => void;
}

function Ranges({ choice, change }: FormProps) {
  const detail = useSignal(choice.detail);
  const smooth = useSignal(choice.smooth);
  useEffect(() => {
    if (detail.value === choice.detail && smooth.value === choice.smooth) return;
    change({ detail: detail.value, smooth: smooth.value });
  }, [detail.value, smooth.value]);
  const points = words.points(count(pointsOf(detail.value)));
  const pixels = smooth.value > 0 ? words.pixels(decimal(smooth.value, 1)) : words.noSmoothing;
  return (
    <>
      <div>
        <div class="form-label">
          <span>{words.detail}</span>
          <output>{points}</output>
        </div>
        <Slider
          label={words.detail}
          text={points}
          value={detail.value}
          min={0}
          max={1}
          step={0.01}
          reset={0.5}
          sink={setting(detail)}
        />
      </div>
      <div>
        <div class="form-label">
          <span>{words.smooth}</span>
          <output>{pixels}</output>
        </div>
        <Slider
          label={words.smooth}
          text={pixels}
          value={smooth.value}
          min={0}
          max={MOST_SMOOTH}
          step={0.5}
          reset={0}
          sink={setting(smooth)}
        />
      </div>
    </>
  );
}

function Form({ choice, change }: FormProps) {
  return (
    <>
      <Ranges choice={choice} change={change} />
      <div>
        <div class="form-label">
          <span>{words.stops}</span>
        </div>
        <Segments
          full
          label={words.stops}
          value={choice.stops}
          choices={(["few", "normal", "many"] as const).map((value) => ({
            value,
            label: words.fewerOrMore[value],
          }))}
          onChange={(stops) => change({ stops })}
        />
      </div>
      <Check
        checked={choice.isSharp}
        label={words.sharp}
        note={words.sharpNote}
        onChange={(isSharp) => change({ isSharp })}
      />
    </>
  );
}

/** The run of this dialog; it ends with it. */
function useRun(): TraceRun {
  const { services } = useShell();
  const run = useMemo(() => new TraceRun(services.trace()), []);
  useEffect(() => () => run.end(), []);
  return run;
}

export function TraceDialog() {
  const { editor } = useShell();
  const run = useRun();
  const choice = useSignal(remembered);
  const keeps = useSignal(true);
  const dialog = editor.dialog.value;
  const photo = dialog?.kind === "trace" ? dialog.photo : null;
  useEffect(() => {
    if (photo) void run.take(photo, choice.peek());
  }, [photo]);
  const change = (to: Partial<TraceChoice>) => {
    remembered = choice.value = { ...choice.value, ...to };
    run.change(choice.value);
  };
  const choose = async () => {
    try {
      const chosen = await run.tracing.choose();
      if (chosen && editor.dialog.peek()?.kind === "trace") {
        editor.dialog.value = { kind: "trace", photo: chosen };
      }
    } catch (error) {
      run.fail(error);
    }
  };
  const stage = run.stage.value;
  const round = run.round.value;
  const pixels = run.pixels.value;
  const take = (how: "openAsNew" | "insert") => async () => {
    if (!photo || !pixels || !round) return;
    run.stop();
    const keepsPhoto = keeps.value && photo.artboardFromPhoto === null;
    const { text, curves } = round;
    await run.tracing[how]({ photo, pixels, text, curves, keepsPhoto });
    if (editor.dialog.peek()?.kind === "trace") editor.dialog.value = null;
  };
  const isReady = round !== null && stage !== "failed";
  const foot = (
    <>
      {stage === "running" ? (
        <button type="button" class="button large" onClick={() => run.stop()}>
          {words.stop}
        </button>
      ) : (
        <button
          type="button"
          class="button large"
          disabled={!pixels}
          onClick={() => void run.run(choice.value)}
        >
          {words.again}
        </button>
      )}
      <span class="spacer" />
      {!editor.welcome.value && (
        <button
          type="button"
          class="button large"
          disabled={!isReady}
          onClick={() => void take("insert")()}
        >
          {words.insertAsLayer}
        </button>
      )}
      <button
        type="button"
        class="button primary large"
        disabled={!isReady}
        onClick={() => void take("openAsNew")()}
      >
        {words.open}
      </button>
    </>
  );
  const isLarge = pixels !== null && Math.max(pixels.width, pixels.height) > MOST_SIDE;
  return (
    <Frame title={words.title} class="export trace" foot={foot}>
      <div class="export-grid">
        <TraceStageView run={run} name={photo?.name ?? ""} />
        <div class="form export-form">
          <button type="button" class="button" onClick={() => void choose()}>
            <Icon name="image-plus" small />
            {photo ? words.chooseOther : words.choose}
          </button>
          <Form choice={choice.value} change={change} />
          {photo?.artboardFromPhoto === null && (
            <Check
              checked={keeps.value}
              label={words.keep}
              note={words.keepNote}
              onChange={(to) => {
                keeps.value = to;
              }}
            />
          )}
          {isLarge && <p class="read muted">{words.scaled(MOST_SIDE)}</p>}
          {run.reason.value && (
            <p class="read failure" role="alert">
              {run.reason.value}
            </p>
          )}
        </div>
      </div>
    </Frame>
  );
}
