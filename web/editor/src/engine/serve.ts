// Answers a page's calls by a session of its own.
import { answer, Handed, type MessageEndpoint, type Note } from "./rpc.js";
import { Session, type SolveWish } from "./session.js";
import { buffersOf } from "./tables.js";
import { snapped } from "./snap.js";
import type {
  FileWish,
  FitWish,
  GivenImage,
  LayerCurves,
  QuickChange,
  RasterWish,
  RegionOperation,
  SnapWish,
  TraceWish,
} from "./types.js";

export function serve(scope: MessageEndpoint): void {
  let session: Session;
  answer(scope, {
    async start(module: WebAssembly.Module, name: string) {
      session = await Session.start(module, name);
      return session.version;
    },
    addImages: (images: readonly GivenImage[]) => session.addImages(images),
    read: (text: string) => session.read(text),
    change: (changes: readonly QuickChange[]) => session.change(changes),
    solve(wish: SolveWish) {
      const solved = session.solve(wish);
      return new Handed(solved, buffersOf(solved.layers));
    },
    expect: (curves: LayerCurves) => session.expect(curves),
    colors(layer: number, xy: Float64Array) {
      const colors = session.colors(layer, xy);
      return new Handed(colors, [colors.buffer as ArrayBuffer]);
    },
    raster(wish: RasterWish) {
      const pixels = session.raster(wish);
      return new Handed(pixels, [pixels.buffer as ArrayBuffer]);
    },
    exactLayer: (layer: number) => session.exactLayer(layer),
    payload: () => session.payload(),
    write: (wish: FileWish) => session.write(wish),
    lint: () => session.lint(),
    convert: (text: string) => session.convert(text),
    combinePaths: (operation: RegionOperation, paths: readonly string[], tolerance: number) =>
      session.combinePaths(operation, paths, tolerance),
    importSvg: (text: string) =>
      session.importSvg(text, (note) => scope.postMessage({ note } satisfies Note, [])),
    fit: (wish: FitWish) => session.fit(wish),
    snap: (wish: SnapWish) => snapped(wish),
    trace: (wish: TraceWish) =>
      session.trace(wish, (note) => scope.postMessage({ note } satisfies Note, [])),
  });
}
