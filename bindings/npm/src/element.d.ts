/** The visible part of a picture, and its scale. */
export interface PictureView {
  /** The artboard point in the middle. */
  x: number;
  y: number;
  /** CSS pixels per user unit. */
  zoom: number;
}

/**
 * `<sfumato-picture src alt interactive>`: attributes are src, alt, interactive, wheel="zoom", loading="eager",
 * max-error, mesh, background="none". Events: `error` (an ErrorEvent; `error` has code, line and column where
 * the drawing is at fault) and `settled`. Parts: canvas, hint.
 */
export class SfumatoPicture extends HTMLElement {
  /** The texts of hints. */
  static words: { wheel: () => string; touch: () => string };
  /** Address of worker.js; needed if the bundler does not find it. */
  static workerUrl: string | URL | null;
  /** Address of sfumato-solver.wasm; needed if the bundler does not find it. */
  static wasmUrl: string | URL | null;
  /** Resolves when the first frame is shown; rejects if none can be shown. */
  readonly ready: Promise<void>;
  src: string;
  alt: string;
  interactive: boolean;
  mesh: boolean;
  /** null until the picture is loaded. Assign a whole view or a part of one to change it. */
  get view(): PictureView | null;
  set view(state: Partial<PictureView> | null);
  /** Number of frames shown so far. */
  readonly frames: number;
  /** Shows the whole page. */
  fit(): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "sfumato-picture": SfumatoPicture;
  }
}
