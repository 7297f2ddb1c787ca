// The picture as the viewer's renderer takes it, put together of the engine's updates.
import { readStack } from "../../../viewer/payload.js";
import type { Picture } from "../../../viewer/payload.js";
import { LayerMirror, type LayerChange, type MirroredLayer } from "../engine/mirror.js";
import type { LayerUpdate, PictureUpdate } from "../engine/types.js";

type Layer = Picture["layers"][number];
type Stack = ReturnType<typeof readStack>;

/** A layer whose object stays the same while its tables change: by it the renderer knows it. */
interface SceneLayer {
  readonly mirror: LayerMirror;
  readonly layer: Layer;
}

export interface SceneChange {
  /** Whether there is another stack, or other layers. */
  readonly isOther: boolean;
  readonly layers: readonly { readonly layer: Layer; readonly change: LayerChange }[];
}

export class Scene {
  picture: Picture | null = null;
  #layers: SceneLayer[] = [];
  #stack: Stack | null = null;

  /** @throws PayloadError where the engine sent what cannot be read */
  take(update: PictureUpdate): SceneChange {
    const count = this.#layers.length;
    if (update.stack) this.#stack = readStack(update.stack);
    const layers = update.layers.map((of) => ({ layer: this.#layerOf(of).layer, change: this.#change(of) }));
    this.#layers.length = update.layerCount;
    const isOther = update.stack !== null || this.#layers.length !== count;
    if (this.#stack) this.#fit(this.#stack, isOther);
    return { isOther, layers };
  }

  #layerOf({ layer }: LayerUpdate): SceneLayer {
    return (this.#layers[layer] ??= { mirror: new LayerMirror(), layer: {} as Layer });
  }

  #change(update: LayerUpdate): LayerChange {
    const { mirror, layer } = this.#layers[update.layer];
    const change = mirror.change(update);
    const tables: MirroredLayer = mirror.tables(update);
    Object.assign(layer, tables);
    return change;
  }

  /** Orders and shaders of layers stand in the stack. */
  #fit(stack: Stack, isOther: boolean) {
    this.#layers.forEach(({ layer }, i) => {
      const { order, colorShaders, opacityShaders } = stack.layers[i];
      layer.order = order;
      layer.color = { ...layer.color, shaders: colorShaders };
      layer.opacity = layer.opacity && { ...layer.opacity, shaders: opacityShaders ?? [] };
    });
    if (!isOther && this.picture) return;
    this.picture = { ...stack, layers: this.#layers.map(({ layer }) => layer) };
  }
}
