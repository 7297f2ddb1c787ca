// Which part of the artboard is seen: pan, zoom about a point, and the smooth way between two views.
import { Motion } from "../../../viewer/motion.js";
import { View } from "../../../viewer/view.js";
import type { Affine, Box, Point } from "../geometry/affine.js";
import type { Editor, ViewState } from "./types.js";

/** Around what is fitted into the stage, CSS pixels. */
const MARGIN = 24;
/** Artboard units of a box that has no extent, so that a point can be fitted. */
const LEAST_EXTENT = 1e-6;
/** How much of the stage the artboard never leaves, as a share of its width and height. */
const KEPT = 0.1;

export function stageFromArtboard(
  { x, y, zoom }: ViewState,
  width: number,
  height: number,
): Affine {
  return [zoom, 0, 0, zoom, width / 2 - x * zoom, height / 2 - y * zoom];
}

export function artboardFromStage(
  { x, y, zoom }: ViewState,
  width: number,
  height: number,
): Affine {
  return [1 / zoom, 0, 0, 1 / zoom, x - width / (2 * zoom), y - height / (2 * zoom)];
}

/** Returns the part of the plane that is visible. */
export function seenBox({ x, y, zoom }: ViewState, { width, height }: { readonly width: number; readonly height: number }): Box {
  const [dx, dy] = [width / 2 / zoom, height / 2 / zoom];
  return [x - dx, y - dy, x + dx, y + dy];
}

/** The viewer's view, with an editor's room: the artboard may be moved to the side. */
class StageView extends View {
  constructor(artboard: Box, width: number, height: number, ratio: number) {
    super([...artboard], () => false);
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.ratio = ratio;
  }

  /** The state that shows a box, with a margin. */
  showing([x0, y0, x1, y1]: Box): ViewState {
    const across = Math.max(1, this.width - 2 * MARGIN);
    const down = Math.max(1, this.height - 2 * MARGIN);
    const zoom = Math.min(
      across / Math.max(x1 - x0, LEAST_EXTENT),
      down / Math.max(y1 - y0, LEAST_EXTENT),
    );
    return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, zoom };
  }

  override fitted(): ViewState {
    return this.showing(this.page as unknown as Box);
  }

  /** As the viewer's, but that the page may go as far as a tenth of the stage still shows it. */
  override limited(state: ViewState): ViewState {
    const { zoom } = super.limited(state);
    const [x0, y0, x1, y1] = this.page;
    const reach = 0.5 - KEPT;
    const within = (value: number, kept: number, low: number, high: number, extent: number) => {
      const slack = (extent * reach) / zoom;
      return Math.min(high + slack, Math.max(low - slack, Number.isFinite(value) ? value : kept));
    };
    return {
      x: within(state.x, this.state.x, x0, x1, this.width),
      y: within(state.y, this.state.y, y0, y1, this.height),
      zoom,
    };
  }
}

/** The state of the editor that navigation needs. */
export type ViewOwner = Pick<Editor, "view" | "stage"> & {
  readonly drawing: { readonly artboard: Box };
};

/** Moves the editor's view. Points are of the stage, CSS pixels. */
export class Navigation {
  private readonly motion: Motion;
  private seen: StageView;
  private frame = 0;

  /** @param ratio device pixels to a CSS pixel, read at each step */
  constructor(
    private readonly owner: ViewOwner,
    private readonly ratio: () => number = () => globalThis.devicePixelRatio ?? 1,
  ) {
    this.seen = this.now();
    this.motion = new Motion(this.seen);
  }

  private now(): StageView {
    const { width, height } = this.owner.stage.peek();
    const seen = new StageView(this.owner.drawing.artboard, width, height, this.ratio());
    seen.state = this.owner.view.peek();
    return seen;
  }

  /** Zoom that is on its way counts from where it goes, so that quick steps add up. */
  private start(): { view: StageView; from: ViewState } {
    this.seen = this.now();
    this.motion.view = this.seen;
    return { view: this.seen, from: this.motion.isMoving ? this.motion.to : this.seen.state };
  }

  private go(state: ViewState, isSmooth: boolean): void {
    this.motion.go(state, isSmooth);
    this.owner.view.value = this.seen.state;
    if (this.motion.isMoving && this.frame === 0) this.frame = requestAnimationFrame(this.step);
  }

  private readonly step = (time: number): void => {
    this.frame = 0;
    this.motion.step(time);
    this.owner.view.value = this.seen.state;
    if (this.motion.isMoving) this.frame = requestAnimationFrame(this.step);
  };

  moveBy(dx: number, dy: number, isSmooth = false): void {
    const { view, from } = this.start();
    this.go(view.moved(from, dx, dy), isSmooth);
  }

  /** @param at what stays in its place; absent: the middle */
  zoomBy(factor: number, at?: Point, isSmooth = true): void {
    const { view, from } = this.start();
    const [x, y] = at ?? [view.width / 2, view.height / 2];
    this.go(view.zoomed(from, factor, x, y), isSmooth);
  }

  /** Shows a box of the artboard, or all of it, as large as it fits. */
  fit(box?: Box, isSmooth = true): void {
    const { view } = this.start();
    this.go(box ? view.showing(box) : view.fitted(), isSmooth);
  }

  /** A CSS pixel to an artboard unit. */
  showActualSize(): void {
    const { view, from } = this.start();
    this.zoomBy(1 / from.zoom, [view.width / 2, view.height / 2]);
  }
}

/** A step of the wheel that is felt as one, CSS pixels. */
const WHEEL_LINE = 18;
const WHEEL_PAGE = 400;
/** Exponent to a pixel, and the most pixels of one event: of a pinch on a touch pad, of a wheel. */
const PINCH = { speed: 0.01, most: 25 };
const WHEEL = { speed: 0.002, most: 300 };

export interface WheelLike {
  readonly deltaX: number;
  readonly deltaY: number;
  readonly deltaMode: number;
  readonly ctrlKey: boolean;
  readonly shiftKey: boolean;
}

/**
 * The wheel zooms about the pointer, with Shift it moves sideways. A pinch on a touch pad comes as a
 * wheel with Ctrl, in small steps.
 */
export function turnWheel(navigation: Navigation, event: WheelLike, at: Point): void {
  const unit = [1, WHEEL_LINE, WHEEL_PAGE][event.deltaMode] ?? 1;
  if (event.shiftKey && !event.ctrlKey) {
    navigation.moveBy(-(event.deltaX || event.deltaY) * unit, 0);
    return;
  }
  const { speed, most } = event.ctrlKey ? PINCH : WHEEL;
  const delta = (event.deltaY || event.deltaX) * unit;
  navigation.zoomBy(Math.exp(-Math.max(-most, Math.min(most, delta)) * speed), at, !event.ctrlKey);
}
