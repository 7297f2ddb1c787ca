import { SfumatoError, Status } from "./index.js";

/** The class of `error` in the element's event, and its codes: the same as of the package. */
export { SfumatoError, Status };

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
 * max-error, max-time, import, mesh, background="none". Events: `error` (an ErrorEvent whose `error` is a
 * SfumatoError) and `settled`. Parts: canvas, hint.
 */
export class SfumatoPicture extends HTMLElement {
  /** The texts of hints. */
  static words: { wheel: () => string; touch: () => string };
  /** Address of worker.js, or a TrustedScriptURL with it; needed if the bundler does not find it. */
  static workerUrl: string | URL | { toString(): string } | null;
  /** Address of sfumato-solver.wasm; needed if the bundler does not find it. */
  static wasmUrl: string | URL | null;
  /**
   * Resolves when the first frame is shown, or when the picture is loaded if the element is out of sight. Rejects
   * with a SfumatoError if there will be no picture, with an AbortError if `src` changes or the element is removed
   * before that, and with an EncodingError if the element has no `src`.
   */
  readonly ready: Promise<void>;
  src: string;
  alt: string;
  interactive: boolean;
  mesh: boolean;
  /** Whether an ordinary SVG is converted to curves; that needs sfumato.wasm. */
  import: boolean;
  /** The content that the reader ignored, one message each. */
  readonly warnings: readonly string[];
  /**
   * null until the picture is loaded. Assign a whole view or a part of one to change it; before that, the picture
   * begins with it.
   */
  get view(): PictureView | null;
  set view(state: Partial<PictureView> | null);
  /** Number of frames shown so far. */
  readonly frames: number;
  /** Shows the whole page. */
  fit(): void;
}

/** The attributes of the element, for the JSX of a framework. */
export interface PictureAttributes {
  src?: string | undefined;
  alt?: string | undefined;
  interactive?: boolean | undefined;
  wheel?: "zoom" | undefined;
  loading?: "eager" | "lazy" | undefined;
  "max-error"?: number | string | undefined;
  "max-time"?: number | string | undefined;
  import?: boolean | undefined;
  mesh?: boolean | undefined;
  background?: "none" | undefined;
  view?: Partial<PictureView> | null | undefined;
  onerror?: ((event: ErrorEvent) => void) | undefined;
  onsettled?: ((event: Event) => void) | undefined;
}

declare global {
  interface HTMLElementTagNameMap {
    "sfumato-picture": SfumatoPicture;
  }
}

// For TSX. The comments let projects without React compile.
// @ts-ignore
declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      // @ts-ignore
      "sfumato-picture": PictureAttributes & Omit<DetailedHTMLProps<HTMLAttributes<SfumatoPicture>, SfumatoPicture>, keyof PictureAttributes>;
    }
  }
}
