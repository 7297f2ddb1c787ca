// Exact pictures that the page has shown. Undo and redo show them again without another solve.
import type { SolveOptions, Solved } from "./session.js";
import type { FieldUpdate, LayerUpdate } from "./types.js";

/** The most bytes of texts, stacks and tables. */
const MOST_BYTES = 64 * 2 ** 20;

export interface FormerPicture {
  readonly text: string;
  readonly options: SolveOptions;
  readonly stack: Uint8Array;
  readonly stackStamp: string;
  readonly stamps: readonly string[];
  /** Whole layers, one for each stamp. */
  readonly layers: readonly LayerUpdate[];
}

export function sameOptions(a: SolveOptions | null, b: SolveOptions): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

export class FormerPictures {
  /** In the order in which they were kept, the latest last. */
  #pictures: readonly FormerPicture[] = [];
  /** The stack that the page shows. */
  #stack: Uint8Array | null = null;
  /** The layers that the page shows, by their stamps, without layers that arrived as rows. */
  #whole = new Map<string, LayerUpdate>();

  /** Notes what the page shows. */
  note({ stack, stamps, layers }: Pick<Solved, "stack" | "stamps" | "layers">): void {
    this.#stack = stack ?? this.#stack;
    for (const update of layers) if (update.isWhole) this.#whole.set(stamps[update.layer], update);
    const shown = new Set(stamps);
    this.#whole.forEach((_, stamp) => shown.has(stamp) || this.#whole.delete(stamp));
  }

  /** Keeps the exact picture that the page shows, unless a layer arrived as rows. */
  keep(text: string, options: SolveOptions, { stamps, stackStamp }: Pick<Solved, "stamps" | "stackStamp">): void {
    const layers = stamps.flatMap((stamp) => this.#whole.get(stamp) ?? []);
    this.#pictures = this.#pictures.filter((one) => one.text !== text);
    if (!this.#stack || layers.length < stamps.length) return;
    this.#pictures = [...this.#pictures, { text, options, stack: this.#stack, stackStamp, stamps, layers }];
    while (bytesOf(this.#pictures) > MOST_BYTES) this.#pictures = this.#pictures.slice(1);
  }

  /** Returns the picture of a text, if it is kept. */
  find(text: string, options: SolveOptions): FormerPicture | undefined {
    return this.#pictures.find((one) => one.text === text && sameOptions(one.options, options));
  }
}

function bytesOf(pictures: readonly FormerPicture[]): number {
  // By stamps, because pictures that share a layer share its tables.
  const layers = new Map(pictures.flatMap(({ stamps, layers }) => stamps.map((stamp, i) => [stamp, layers[i]] as const)));
  const texts = pictures.reduce((sum, { text, stack }) => sum + 2 * text.length + stack.byteLength, 0);
  return [...layers.values()].reduce((sum, layer) => sum + bytesOfLayer(layer), texts);
}

function bytesOfLayer({ positions, triangles, edges, color, opacity }: LayerUpdate): number {
  const field = (of: FieldUpdate | null) => (of ? of.nodes.byteLength + of.values.byteLength : 0);
  return positions.byteLength + triangles.byteLength + edges.byteLength + field(color) + field(opacity);
}
