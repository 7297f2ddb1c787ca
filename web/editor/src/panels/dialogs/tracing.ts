// Background work of the dialog that traces photos: reads the photo, runs the trace, draws its rounds.
import { signal, type Signal } from "@preact/signals";
import type { TracedPhoto } from "../../app/types.js";
import { complaintOf } from "../../engine/complaint.js";
import type { PhotoPixels, TraceOptions, TraceRound } from "../../engine/types.js";
import type { Tracing } from "../services.js";

/** A trace begins when nothing was changed for this long, milliseconds. */
const REST = 300;
/** Longer side of what is shown, pixels. */
const SIDE = 640;

/** The settings that the user can change. */
export interface TraceChoice {
  /** 0 to 1. */
  readonly detail: number;
  /** Pixels. */
  readonly smooth: number;
  readonly stops: TraceOptions["stops"];
  readonly isSharp: boolean;
}

/** Returns the control points for a detail, as the command defines it: 250 to 16,000. */
export const pointsOf = (detail: number): number => Math.round(250 * 64 ** detail);

export function optionsOf({ detail, smooth, stops, isSharp }: TraceChoice): TraceOptions {
  return { points: pointsOf(detail), smooth, stops, blur: isSharp ? "off" : "on" };
}

/** Where a trace stands. */
export type TraceStage = "empty" | "reading" | "running" | "done" | "stopped" | "failed";

/** The size of a picture that is shown. */
export function shownSize(width: number, height: number): { readonly width: number; readonly height: number } {
  const scale = Math.min(1, SIDE / Math.max(width, height));
  return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
}

export class TraceRun {
  readonly stage: Signal<TraceStage> = signal<TraceStage>("empty");
  readonly pixels: Signal<PhotoPixels | null> = signal<PhotoPixels | null>(null);
  /** The last round for the present photo and settings. */
  readonly round: Signal<TraceRound | null> = signal<TraceRound | null>(null);
  /** The last drawing that was drawn. */
  readonly preview: Signal<PhotoPixels | null> = signal<PhotoPixels | null>(null);
  readonly reason: Signal<string | null> = signal<string | null>(null);
  photo: TracedPhoto | null = null;
  #stop: AbortController | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly tracing: Tracing) {}

  /** Another photo takes the place of the one before. */
  async take(photo: TracedPhoto, choice: TraceChoice): Promise<void> {
    this.stop();
    this.photo = photo;
    this.pixels.value = this.preview.value = this.round.value = this.reason.value = null;
    this.stage.value = "reading";
    try {
      const pixels = await this.tracing.pixels(photo);
      if (this.photo !== photo) return;
      this.pixels.value = pixels;
      await this.run(choice);
    } catch (error) {
      if (this.photo === photo) this.fail(error);
    }
  }

  /** Traces again once the pointer rests. */
  change(choice: TraceChoice): void {
    clearTimeout(this.#timer);
    if (this.pixels.value) this.#timer = setTimeout(() => void this.run(choice), REST);
  }

  async run(choice: TraceChoice): Promise<void> {
    const pixels = this.pixels.value;
    if (!pixels) return;
    this.stop();
    const own = new AbortController();
    this.#stop = own;
    this.round.value = this.reason.value = null;
    this.stage.value = "running";
    const heard = (round: TraceRound) => !own.signal.aborted && this.#hear(round, pixels, true);
    try {
      const text = await this.tracing.run(pixels, optionsOf(choice), heard, own.signal);
      if (own.signal.aborted) return;
      const last = this.round.peek();
      if (last) this.#hear({ ...last, text }, pixels, false);
      this.stage.value = "done";
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }

  #hear(round: TraceRound, pixels: PhotoPixels, isDraft: boolean): void {
    this.round.value = round;
    const size = shownSize(pixels.width, pixels.height);
    this.tracing.draw({ text: round.text, ...size, isDraft }, (drawn) => {
      // The photo or the settings have changed by now: a drawing that is shown stays until there is a newer
      // one.
      if (this.pixels.value === pixels) this.preview.value = drawn;
    });
  }

  /** Stops, and keeps the result so far. */
  stop(): void {
    clearTimeout(this.#timer);
    this.#stop?.abort();
    this.#stop = null;
    if (this.stage.value === "running") this.stage.value = "stopped";
  }

  fail(error: unknown): void {
    this.reason.value = complaintOf(error);
    this.stage.value = "failed";
  }

  end(): void {
    this.stop();
    this.photo = null;
    this.tracing.end();
  }
}
