// Exact pixels of the stage (docs/viewer.md, "Exact pixels"): once the picture rests, the engine returns the
// curves of its layers, and the viewer's renderer gathers from them.
import { exactPixels, isSoftware } from "../../../viewer/exact.js";
import type { ExactLayer } from "../../../viewer/exact_fields.js";
import type { Frame, Renderer } from "../../../viewer/renderer.js";
import type { Editor, ExactState } from "../app/types.js";

/** How long the picture must rest, milliseconds. */
const REST = 400;
/** When an engine that was busy is asked again, milliseconds. */
const AGAIN = 250;

/** A layer's curves, and which of its versions they are of. */
interface Known {
  readonly version: number;
  readonly layer: ExactLayer | null;
  /** Why the engine could not give them; empty: it could. */
  readonly failure: string;
}

/** The picture that the stage draws. */
export interface Shown {
  readonly layerCount: number;
  /** A number that grows with each change of a layer. */
  version(layer: number): number;
  /** Time of the last change, by performance.now(). */
  readonly changedAt: number;
}

export class ExactStage {
  readonly #editor: Editor;
  readonly #shown: Shown;
  /** Asks for the next frame. */
  readonly #wake: () => void;
  readonly #known: Known[] = [];
  #isAsking = false;
  /** Whether the context draws in software; null: not known yet. */
  #isSoftware: boolean | null = null;

  constructor(editor: Editor, shown: Shown, wake: () => void) {
    this.#editor = editor;
    this.#shown = shown;
    this.#wake = wake;
  }

  /** Another context from now on. */
  reset(): void {
    this.#isSoftware = null;
  }

  /** Something else is to be seen. */
  leave(): void {
    if (this.#editor.exactState.peek().kind === "exact") this.#tell({ kind: "gathering", share: 0 });
  }

  /** Where patches are as fine as they get. @returns whether there is more to do in the next frame */
  step(renderer: Renderer, frame: () => Frame): boolean {
    if (!this.#isWanted(renderer)) return this.#turnOff(renderer);
    const { exact } = renderer;
    if (exact?.reason && !exact.isTooLarge) return false;
    const isResting = performance.now() - this.#shown.changedAt > REST;
    const layers = isResting ? this.#layers() : null;
    if (!layers) {
      this.#tell({ kind: "gathering", share: 0 });
      if (isResting) void this.#ask();
      return !isResting;
    }
    const failed = this.#known.find(({ failure }) => failure !== "");
    if (failed) {
      this.#tell({ kind: "none", reason: failed.failure });
      return false;
    }
    if (!renderer.exact) renderer.setExact(exactPixels(layers));
    renderer.gatherMore(frame());
    renderer.showGathered();
    this.#tell(stateOf(renderer));
    return renderer.canGather || renderer.hasUnshown || renderer.canRefine;
  }

  #isWanted({ gl }: Renderer): boolean {
    const wish = this.#editor.settings.exactPixels.peek();
    this.#isSoftware ??= isSoftware(gl);
    return wish === "on" || (wish === "auto" && !this.#isSoftware);
  }

  #turnOff(renderer: Renderer): boolean {
    renderer.setExact(null);
    this.#tell({ kind: "off" });
    return false;
  }

  #tell(state: ExactState) {
    const { exactState } = this.#editor;
    const before = exactState.peek();
    const detail = (of: ExactState) => (of.kind === "gathering" ? Math.floor(100 * of.share) : of.kind === "none" && of.reason);
    if (before.kind !== state.kind || detail(before) !== detail(state)) exactState.value = state;
  }

  /** Of all layers; null: some are still to come. */
  #layers(): (ExactLayer | null)[] | null {
    const { layerCount } = this.#shown;
    this.#known.length = Math.min(this.#known.length, layerCount);
    for (let i = 0; i < layerCount; ++i) if (!this.#isKnown(i)) return null;
    return this.#known.map(({ layer }) => layer);
  }

  #isKnown(layer: number): boolean {
    return this.#known[layer]?.version === this.#shown.version(layer);
  }

  /** The engine for the layers that are not known, one after another. */
  async #ask(): Promise<void> {
    const { engine, status } = this.#editor;
    // Once the picture is exact, it makes a frame.
    if (this.#isAsking || status.peek().kind !== "exact") return;
    this.#isAsking = true;
    for (let i = 0; i < this.#shown.layerCount; ++i) {
      if (this.#isKnown(i)) continue;
      const version = this.#shown.version(i);
      try {
        const layer = await engine.exactLayer(i);
        if (layer === "busy") {
          await new Promise((resolve) => setTimeout(resolve, AGAIN));
          break;
        }
        this.#known[i] = { version, layer, failure: "" };
      } catch (error) {
        this.#known[i] = { version, layer: null, failure: (error as Error).message };
      }
    }
    this.#isAsking = false;
    this.#wake();
  }
}

function stateOf(renderer: Renderer): ExactState {
  const { exact } = renderer;
  if (exact?.reason) return { kind: "none", reason: exact.reason };
  const share = exact && renderer.isGathering ? exact.progress : 0;
  const isDone = share === 1 && !renderer.hasUnshown && !renderer.canRefine;
  return isDone ? { kind: "exact" } : { kind: "gathering", share: Math.min(share, 0.99) };
}
