/** Which part of a picture is seen, and how large. */
export interface PictureView {
  /** Point of the artboard in the middle. */
  x: number;
  y: number;
  /** CSS pixels to a user unit. */
  zoom: number;
}

/**
 * `<sfumato-picture src alt interactive>`: attributes are src, alt, interactive, wheel="zoom", loading="eager",
 * max-error, mesh, background="none". Events: `error` (an ErrorEvent; `error` has code, line and column where
 * the drawing is at fault) and `settled`. Parts: canvas, hint.
 */
export class SfumatoPicture extends HTMLElement {
  /** What hints say. */
  static words: { wheel: () => string; touch: () => string };
  /** Where worker.js lies, where a bundler does not bring it. */
  static workerUrl: string | URL | null;
  /** Where sfumato-solver.wasm lies, where a bundler does not bring it. */
  static wasmUrl: string | URL | null;
  /** Resolves when the first frame is shown; rejects where there will be none. */
  readonly ready: Promise<void>;
  src: string;
  alt: string;
  interactive: boolean;
  mesh: boolean;
  /** null before the picture is there; to write in whole or in part. */
  get view(): PictureView | null;
  set view(state: Partial<PictureView> | null);
  /** Frames shown so far. */
  readonly frames: number;
  /** Shows the whole page. */
  fit(): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "sfumato-picture": SfumatoPicture;
  }
}
