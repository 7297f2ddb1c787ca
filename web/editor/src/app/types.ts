// contract: the editor's state, as panels and tools see it.
import type { ReadonlySignal, Signal } from "@preact/signals";
import type { Affine, Box, Point } from "../geometry/affine.js";
import type { Rgb } from "../geometry/color.js";
import type { Engine, EngineStatus, Hint } from "../engine/types.js";
import type { Style } from "../model/commands/index.js";
import type { Attribute, Drawing, Handle, Item, Outcome, Selection } from "../model/types.js";

export type ToolName =
  | "select"
  | "nodes"
  | "pen"
  | "pencil"
  | "stroke"
  | "rectangle"
  | "ellipse"
  | "polygon"
  | "sample"
  | "blur"
  | "hand";

/** Artboard point in the middle of the stage, CSS pixels to an artboard unit. */
export interface ViewState {
  readonly x: number;
  readonly y: number;
  readonly zoom: number;
}

export type Theme = "system" | "light" | "dark";
export type Surround = "dark" | "mid" | "light";

/** Kept in this browser; signals, so that a change is seen at once. */
export interface Settings {
  readonly theme: Signal<Theme>;
  readonly surround: Signal<Surround>;
  /** Pencil: the largest distance of the curve from the drawn line, CSS pixels, 0.5 to 8. */
  readonly smoothing: Signal<number>;
  /** "auto": unless the graphics driver draws in software. */
  readonly exactPixels: Signal<"auto" | "on" | "off">;
  readonly snap: Signal<boolean>;
  /** Whether pen and pencil give both sides of a new curve the current colour; else the colours of the picture. */
  readonly ownColor: Signal<boolean>;
  /** Whether several objects are aligned to the artboard, as a single one always is. */
  readonly alignToArtboard: Signal<boolean>;
  readonly grid: Signal<boolean>;
  /** Units between the finest lines of the grid; 0: as fine as the zoom allows. */
  readonly gridUnit: Signal<number>;
  /** Whether rulers show along the upper and the left edge of the stage. */
  readonly rulers: Signal<boolean>;
  readonly colorModel: Signal<"oklch" | "hsv" | "rgb">;
  /** The last eight. */
  readonly recent: Signal<readonly Rgb[]>;
  readonly panelWidth: Signal<number>;
  /** Sampling: how far from the curve, photo pixels, 1 to 12; and the tolerance in OKLab. */
  readonly sampleDistance: Signal<number>;
  readonly sampleTolerance: Signal<number>;
  /** Whether a curve takes the width of the photo's transition, too. */
  readonly sampleBlur: Signal<boolean>;
  /** Radius of new local strokes, artboard units. */
  readonly strokeRadius: Signal<number>;
  /** Sides of new polygons, 3 to 12. */
  readonly polygonSides: Signal<number>;
  readonly tourDone: Signal<boolean>;
}

export interface Toast {
  readonly text: string;
  readonly action: { readonly label: string; readonly run: () => void } | null;
}

/** Work that takes long, and that the person can end. */
export interface Task {
  readonly text: string;
  readonly stop: () => void;
}

/** Where the drawing is unlike the photo that lies on it. */
export interface Difference {
  /** The address of a picture that fills the artboard. */
  readonly href: string;
  /** Decibels; null: there is nothing to compare with. */
  readonly psnr: number | null;
  /** Drawing.revision of what it shows. */
  readonly revision: number;
}

/** A photo to trace. */
export interface TracedPhoto {
  readonly blob: Blob;
  readonly name: string;
  /** Where it lies on the drawing, from its shares of 0 to 1; null: it does not. */
  readonly artboardFromPhoto: Affine | null;
}

/** The dialog that is open over the page; null: none. */
export type Dialog =
  | { readonly kind: "trace"; readonly photo: TracedPhoto | null }
  | {
      readonly kind: "commands" | "export" | "keys" | "new" | "recover" | "about" | "problem" | "document" | "foreign" | "guides";
    }
  | null;

/** The colour picker: what it edits. */
export interface PickerTarget {
  readonly handle: Handle;
  readonly side: "left" | "right";
  /** Indices of stops, ascending, at least one; null: the whole side, which gets one colour. */
  readonly stops: readonly number[] | null;
}

/** One movement of the pointer: shown while it lasts, kept as one step of undo. */
export interface Gesture {
  /** Shows what a command makes of the drawing as it was when the gesture began. null: nothing. */
  show(make: (before: Drawing) => Outcome | null): void;
  keep(): void;
  drop(): void;
  readonly isOver: boolean;
}

/** Work that a tool has begun and that is not in the drawing yet: undo and redo belong to it while it lasts. */
export interface Draft {
  /** The steps that undo and redo would take within it, or null. */
  readonly undoLabel: string | null;
  readonly redoLabel: string | null;
  undo(): void;
  redo(): void;
  /** Ends the draft and adds it to the drawing. The edit may complete later. */
  finish(): void;
  /** Ends it, and leaves nothing. */
  drop(): void;
}

export interface FileState {
  readonly name: string;
  /** Whether there is something that no file has. */
  readonly isChanged: boolean;
  /** Where it is safe: "file", "browser" (autosave), or "nowhere" (storage refused). */
  readonly kept: "file" | "browser" | "nowhere";
  /** Why nowhere: the browser refuses, has no room, or another tab goes on with the drawing. */
  readonly lost?: "refused" | "full" | "elsewhere";
  /** Whether the newest change is still to be written there. */
  readonly isWaiting?: boolean;
}

/** How it stands with exact pixels of what is seen. */
export type ExactState =
  | { readonly kind: "off" | "exact" }
  | { readonly kind: "gathering"; readonly share: number }
  /** There can be none, and why. */
  | { readonly kind: "none"; readonly reason: string };

export interface Editor {
  /** Within components and effects, reading it subscribes to its changes. */
  readonly drawing: Drawing;
  /** The engine's number of the text that it began with: pictures of earlier ones are of another drawing. */
  readonly opened: ReadonlySignal<number>;
  readonly selection: Signal<Selection>;
  /**
   * The isolated layer or group. The stage fades everything else, and tools edit only what is within it. null: nothing
   * is isolated.
   */
  readonly isolated: ReadonlySignal<Handle | null>;
  readonly tool: Signal<ToolName>;
  /** Which stops stand on the curve: keys 1 2 3. */
  readonly attribute: Signal<Attribute>;
  readonly hovered: Signal<Handle | null>;
  readonly view: Signal<ViewState>;
  /** The stage, CSS pixels. */
  readonly stage: Signal<{ readonly width: number; readonly height: number }>;
  /** Where the pointer is, artboard units. */
  readonly pointer: Signal<Point | null>;
  readonly settings: Settings;
  readonly engine: Engine;
  readonly status: ReadonlySignal<EngineStatus>;
  readonly hints: ReadonlySignal<readonly Hint[]>;
  /** Whether the hints describe the present drawing: lint has answered for it. */
  readonly hintsKnown: ReadonlySignal<boolean>;
  readonly hintsShown: Signal<boolean>;
  readonly file: Signal<FileState>;
  /** Labels of what undo and redo would do, or null. */
  readonly undoLabel: ReadonlySignal<string | null>;
  readonly redoLabel: ReadonlySignal<string | null>;
  /** The draft of the present tool, or null. */
  readonly draft: Signal<Draft | null>;
  readonly toast: Signal<Toast | null>;
  readonly task: Signal<Task | null>;
  readonly dialog: Signal<Dialog>;
  readonly picker: Signal<PickerTarget | null>;
  /** The look that *Paste style* gives to curves, or null. */
  readonly copiedStyle: Signal<Style | null>;
  readonly exactState: Signal<ExactState>;
  readonly showMesh: Signal<boolean>;
  readonly showOutlines: Signal<boolean>;
  readonly showReference: Signal<boolean>;
  readonly showDifference: Signal<boolean>;
  /** null: it is not shown, or not known yet. */
  readonly difference: Signal<Difference | null>;
  readonly hideHandles: Signal<boolean>;
  /** Whether the page to begin from is shown. */
  readonly welcome: Signal<boolean>;
  /** Step of the tour, 0 to 4; null: none. */
  readonly tour: Signal<number | null>;
  /** The text that a screen reader announces. */
  readonly announcement: Signal<string>;

  /** One step of undo; false where nothing changes or the drawing is read-only (it says so). */
  run(label: string, outcome: Outcome | null, merge?: string): boolean;
  gesture(label: string): Gesture;
  /** Whether a gesture is open, also while its pointer rests. */
  readonly isInGesture: boolean;
  /** An edit that is on its way into the drawing: undo and redo wait for it. */
  awaitEdit(work: Promise<unknown>): void;
  undo(): void;
  redo(): void;
  /** A new document takes the place of this one. */
  open(text: string, name: string): void;
  /** Isolates a layer or group; null: ends the isolation. */
  isolate(handle: Handle | null): void;
  /** The layer that new curves go into: the selection's, else the topmost that is not locked, within the isolated item. */
  readonly activeLayer: Item | null;
  /** The engine's number of a layer, or null where it has no curves that the engine has read. */
  engineLayer(layer: Item): number | null;
  /** The unit of the last decimal to write for an element: 1/1000 of a CSS pixel at this zoom. */
  step(item: Item | null): number;
  artboardFromStage(): Affine;
  stageFromArtboard(): Affine;
  /** Shows a box of the artboard as large as it fits. */
  fit(box?: Box): void;
  zoomBy(factor: number, at?: Point): void;
  /** Commands of keys.ts and menus by name ("undo", "zoom-in", …). */
  command(name: string): void;
  say(text: string, action?: Toast["action"]): void;
}
