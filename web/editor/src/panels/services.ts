// The page's services for the panels besides the editor's state: files, keys, pictures.
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { ReadonlySignal } from "@preact/signals";
import type { Editor, TracedPhoto } from "../app/types.js";
import type { Box } from "../geometry/affine.js";
import type { PreviewWish } from "../engine/photo-trace.js";
import type { Watch } from "../engine/other-text.js";
import type { Hint, PhotoPixels, TraceOptions, TraceRound } from "../engine/types.js";
import type { ExportWatch, ExportWish } from "../files/export.js";
import type { Rgb } from "../geometry/color.js";
import type { Handle, Item } from "../model/types.js";

/** A drawing to begin from. */
export interface Example {
  readonly name: string;
  readonly curves: number;
  /** Address of a picture, 4 : 3. */
  readonly thumb: string;
  /** @throws Error where it cannot be read */
  open(): Promise<void>;
}

export interface RecentFile {
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly time: number;
  /** null: none is stored. */
  readonly picture: Blob | null;
  open(): void;
}

/** A drawing that this browser kept. */
export interface Autosave {
  readonly id: string;
  readonly name: string;
  readonly time: number;
  readonly curves: number;
  readonly picture: Blob | null;
}

/** Why a file could not be opened, and the text around the place. */
export interface Problem {
  readonly title: string;
  readonly reason: string;
  /** From 1; 0: unknown. */
  readonly line: number;
  readonly column: number;
  /** The line itself, if there is a text. */
  readonly source: string | null;
  /** Advice to the user. */
  readonly help?: string;
}

/** A file of another program, which holds no diffusion curves. */
export interface Foreign {
  readonly name: string;
  /** Opens a drawing of its shapes, and says what was left out. @throws Error, in words */
  convert(watch: Watch): Promise<void>;
  /** Puts its shapes into the drawing as layers; null: no drawing is open. @throws Error, in words */
  readonly insert: ((watch: Watch) => Promise<void>) | null;
  /** Opens it as it is. */
  open(): Promise<void>;
}

/** The choices of the first page. */
export interface Beginnings {
  readonly examples: readonly Example[];
  /** Empty until they are known. */
  readonly recent: ReadonlySignal<readonly RecentFile[]>;
}

/** A photo that is being traced, and what became of it. */
export interface Traced {
  readonly photo: TracedPhoto;
  readonly pixels: PhotoPixels;
  /** The drawing, SVG. */
  readonly text: string;
  readonly curves: number;
  /** Whether the photo goes into the drawing, too. */
  readonly keepsPhoto: boolean;
}

/** Traces photos, and draws the result so far. */
export interface Tracing {
  /** Asks for a photo; null: the person left it. @throws Error, in words */
  choose(): Promise<TracedPhoto | null>;
  /** @throws Error, in words */
  pixels(photo: TracedPhoto): Promise<PhotoPixels>;
  /** @throws Error, in words; the signal's reason */
  run(
    photo: PhotoPixels,
    options: TraceOptions,
    heard: (round: TraceRound) => void,
    signal: AbortSignal,
  ): Promise<string>;
  /** Draws a drawing, the latest of several. */
  draw(wish: PreviewWish, show: (pixels: PhotoPixels) => void): void;
  openAsNew(traced: Traced): Promise<void>;
  /** As a layer of the drawing, in one step of undo. */
  insert(traced: Traced): Promise<void>;
  /** Frees its resources. */
  end(): void;
}

export interface Services {
  readonly version: string;
  readonly problem: ReadonlySignal<Problem | null>;
  /** The file that the dialog "foreign" asks about. */
  readonly foreign: ReadonlySignal<Foreign | null>;
  /**
   * Writes a file for each wish; several wishes are sizes of one PNG. @param natural its size at 1×
   * @throws Error, in words; AbortError: the person left it
   */
  exportTo(
    wishes: readonly ExportWish[],
    natural: { readonly width: number; readonly height: number },
    watch: ExportWatch,
  ): Promise<void>;
  /** The picture to the clipboard. @throws Error, in words; AbortError: the person left it */
  copyPicture(wish: ExportWish, watch: ExportWatch): Promise<void>;
  /** Approximate bytes; null: unknown. */
  estimate(wish: ExportWish): Promise<number | null>;
  /**
   * Address of a picture of that part, at most 640 px wide; the caller revokes it. null: none can
   * be made.
   */
  preview(viewport: Box, transparent: boolean, isSelectionOnly: boolean): Promise<string | null>;
  trace(): Tracing;
  autosaves(): Promise<readonly Autosave[]>;
  recover(id: string): Promise<void>;
  forget(id: string): Promise<void>;
  /**
   * Asks for a place of the picture or the photo and gives its colour; null: the person left it.
   */
  pickColor(signal: AbortSignal): Promise<Rgb | null>;
  /**
   * A picture of a layer or group for its row, or null while there is none. Reading it subscribes.
   */
  thumb(handle: Handle): string | null;
  /** Returns the curve or other item that a hint is about; null: it does not exist, or there are several. */
  itemOf(hint: Hint): Item | null;
  /** Returns the fix of a hint, one step of undo; null: this kind has no automatic fix. */
  mend(hint: Hint): { readonly label: string; readonly run: () => void } | null;
  /** Asks for a picture file to use as a texture; null: the person left it. */
  chooseTexture(): Promise<{
    readonly href: string;
    readonly width: number;
    readonly height: number;
  } | null>;
}

export interface Shell {
  readonly editor: Editor;
  /** Not for what the first page shows: they come after it. */
  readonly services: Services;
}

export const ShellContext = createContext<Shell | null>(null);

export function useShell(): Shell {
  const shell = useContext(ShellContext);
  if (!shell) throw new Error("no shell around");
  return shell;
}
