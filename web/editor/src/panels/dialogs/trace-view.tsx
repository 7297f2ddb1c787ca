// The preview of a trace, and how far it is.
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { PhotoPixels } from "../../engine/types.js";
import * as en from "../../strings/en.js";
import { Segments } from "../controls/segments.js";
import { decimal } from "../format.js";
import { shownSize, type TraceRun, type TraceStage } from "./tracing.js";

const words = en.trace;
const count = (number: number) => number.toLocaleString("en");

/** Draws pixels as large as shownSize() says. */
function draw(canvas: HTMLCanvasElement, { width, height, data }: PhotoPixels): void {
  const size = shownSize(width, height);
  Object.assign(canvas, size);
  const context = canvas.getContext("2d");
  if (!context) return;
  const image = new ImageData(data, width, height);
  if (size.width === width && size.height === height) return context.putImageData(image, 0, 0);
  const whole = new OffscreenCanvas(width, height);
  whole.getContext("2d")?.putImageData(image, 0, 0);
  context.imageSmoothingQuality = "high";
  context.drawImage(whole, 0, 0, size.width, size.height);
}

function Canvas({ pixels, label }: { readonly pixels: PhotoPixels; readonly label: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (canvas.current) draw(canvas.current, pixels);
  }, [pixels]);
  return <canvas ref={canvas} class="chequer" role="img" aria-label={label} />;
}

/** Returns the text for a stage, without its numbers. */
function stageText(stage: TraceStage, run: TraceRun): string {
  const round = run.round.value;
  if (stage === "reading") return words.reading;
  if (stage === "done") return words.done;
  if (stage === "stopped") return words.stopped;
  if (stage !== "running") return "";
  return round && round.psnr > 0 ? words.round(round.round + 1, round.roundCount) : words.begin;
}

function Progress({ run }: { readonly run: TraceRun }) {
  const stage = run.stage.value;
  const round = run.round.value;
  const rounds = round && round.psnr > 0 ? round.round + 1 : 0;
  const share = stage === "done" ? 1 : round ? rounds / round.roundCount : 0;
  return (
    <div class="trace-state">
      <progress aria-label={words.progress} max={1} value={share} />
      <p role="status">
        {`${stageText(stage, run)} `}
        {round && round.psnr > 0 && <b title={words.nearTip}>{words.near(decimal(round.psnr, 1))}</b>}
      </p>
      <p class="muted">{round && words.amounts(count(round.curves), count(round.controlPoints))}</p>
    </div>
  );
}

export function TraceStageView({ run, name }: { readonly run: TraceRun; readonly name: string }) {
  const shows = useSignal<"drawing" | "photo">("drawing");
  const pixels = run.pixels.value;
  const preview = run.preview.value;
  const isDrawing = shows.value === "drawing" && preview !== null;
  return (
    <div class="trace-view">
      <div class="trace-picture">
        {pixels === null ? (
          <p class="read">{run.stage.value === "reading" ? words.reading : words.nothing}</p>
        ) : (
          <Canvas
            pixels={isDrawing ? preview : pixels}
            label={isDrawing ? words.previewAlt(name) : words.photoAlt(name)}
          />
        )}
      </div>
      {pixels !== null && (
        <Segments
          full
          label={words.show}
          value={isDrawing ? "drawing" : "photo"}
          choices={(["drawing", "photo"] as const).map((value) => ({
            value,
            label: words.shown[value],
          }))}
          onChange={(to) => {
            shows.value = to;
          }}
        />
      )}
      {pixels !== null && <Progress run={run} />}
    </div>
  );
}
