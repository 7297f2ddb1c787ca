// The results of sfumato.mjs for good and for bad input.
import {
  Attribute,
  Kind,
  loadSfumato,
  SfumatoError,
  Side,
  Status,
  Table,
} from "../../web/wasm/sfumato.mjs";
import { drawExample } from "./example.mjs";
import { check, refusal, same, textOf } from "./harness.mjs";

const CONTROLS = "tests/wasm/controls.svg";

/** Returns a line across the artboard, red above and blue below. */
function twoHalves(context) {
  const document = context.newDocument({ artboard: "0,0,64,64" });
  document.insertCurve(0, null, [-8, 32, 16, 32, 48, 32, 72, 32]);
  const stops = (...color) => ({ kind: Kind.stops, rows: [[0, ...color]] });
  document.setStops(0, 0, Side.left, Attribute.color, stops(1, 0, 0));
  document.setStops(0, 0, Side.right, Attribute.color, stops(0, 0, 1));
  return document;
}

async function testErrors(tap, sfumato) {
  await tap.test("bad input is refused with the words of the library and their place", () => {
    const context = sfumato.context();
    const text = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">\n  <g>\n</svg>';
    const error = refusal(Status.badInput, () => context.read(text, { name: "a.svg" }));
    check(error instanceof SfumatoError, "another kind of error");
    same(error.file, "a.svg", "the file");
    same(error.line, 3, "the line");
    check(error.column > 0, "no column");
    check(error.message.startsWith(`a.svg:3:${error.column}: not well-formed XML`), error.message);
    check(error.message.endsWith(error.reason), error.message);
    check(context.read(textOf(CONTROLS)).layerCount > 1, "the context reads no more");
  });
  await tap.test("a wrong option is named, of a context too", () => {
    const context = sfumato.context();
    const document = twoHalves(context);
    const solved = refusal(Status.badUsage, () => context.solve(document, { "max-eror": 1 }));
    check(solved.message.includes("max-eror"), solved.message);
    const made = refusal(Status.badUsage, () => sfumato.context("threads=many"));
    check(made.message.includes("threads"), made.message);
  });
  await tap.test("what is not there is refused", () => {
    const context = sfumato.context();
    const document = twoHalves(context);
    const picture = context.solve(document);
    refusal(Status.badUsage, () => document.points(0, 1));
    refusal(Status.badUsage, () => document.removeCurve(1, 0));
    refusal(Status.badUsage, () => picture.table(0, 7));
    same(document.layerId(1), null, "the id of no layer");
    document.free();
    document.free();
    refusal(Status.badUsage, () => context.solve(document));
  });
  await tap.test("what is of the wrong type or size is not taken for an address or a number", () => {
    const context = sfumato.context();
    const document = twoHalves(context);
    const picture = document.solve({ maxError: 1 });
    const wrong = [
      [TypeError, () => context.solve(picture)],
      [TypeError, () => context.raster(document, { width: 1, height: 1 })],
      [TypeError, () => context.solve(document, 5)],
      [TypeError, () => context.read(5)],
      [TypeError, () => document.points(-1, 0)],
      [TypeError, () => document.setPoints(0, 0, 5)],
      [RangeError, () => picture.raster({ width: 0 })],
      [SfumatoError, () => picture.raster({ width: 65536, height: 65536 })], // 2 ** 34 bytes
    ];
    for (const [Kind, body] of wrong) {
      let error = null;
      try {
        body();
      } catch (thrown) {
        error = thrown;
      }
      check(error instanceof Kind, `${body}: ${error}`);
    }
    same(picture.raster({ width: 32 }).height, 32, "the height that fits");
  });
  await tap.test("what writes files of codecs says what is there instead", () => {
    const context = sfumato.context();
    const picture = context.solve(twoHalves(context));
    const error = refusal(Status.unavailable, () => picture.export("png"));
    check(error.message.includes("sfumato_raster"), error.message);
    check(refusal(Status.badUsage, () => picture.export("pgn")).message.includes("png"), "no hint");
    const gzip = refusal(Status.unavailable, () => context.read(new Uint8Array([31, 139, 8, 0])));
    check(gzip.message.includes("gzip"), gzip.message);
  });
}

async function testLimits(tap, sfumato, module) {
  await tap.test("max-time ends a call, and the next one has time again", () => {
    const context = sfumato.context({ "max-time": 0.5 });
    const document = sfumato.context().read(textOf("examples/portrait.svg"));
    const slow = { "max-error": 0.01, scale: 8 };
    const error = refusal(Status.limit, () => context.solve(document, slow));
    check(error.message.includes("time limit of 0.5 s"), error.message);
    check(context.raster(context.solve(twoHalves(context)), { width: 2, height: 2 }), "");
  });
  await tap.test("max-memory refuses what is larger, and nothing is lost", () => {
    const context = sfumato.context({ "max-memory": 1 });
    const error = refusal(Status.limit, () => {
      context.solve(context.read(textOf("examples/portrait.svg")), "scale=8");
    });
    check(error.message.includes("memory limit of 1 MiB"), error.message);
  });
  await tap.test("memory that grows in a call leaves what is read afterwards right", async () => {
    const fresh = await loadSfumato(module);
    const context = fresh.context();
    const first = context.solve(twoHalves(context));
    const before = first.table(0, Table.vertices).data;
    const stale = first.tableView(0, Table.vertices).data;
    const bytes = fresh.memoryBytes;
    context.solve(context.read(textOf("examples/portrait.svg")), "scale=2");
    check(fresh.memoryBytes > bytes, "it did not grow");
    same(stale.length, 0, "the length of a view from before");
    same(first.tableView(0, Table.vertices).data.join(), before.join(), "the table");
  });
  await tap.test("a trap is an error, also of all later calls", async () => {
    const fresh = await loadSfumato(module);
    const context = fresh.context();
    const outside = 0xfffffff0;
    const trap = () => context.library.call("sfumato_layer_count", outside);
    check(refusal(Status.outOfMemory, trap).cause instanceof WebAssembly.RuntimeError, "the cause");
    refusal(Status.outOfMemory, () => twoHalves(context));
  });
  await tap.test("a picture and its document go back to the module's memory", () => {
    const context = sfumato.context();
    const once = () => {
      const document = context.read(textOf(CONTROLS));
      const picture = context.solve(document);
      picture.free();
      document.free();
    };
    once();
    const bytes = sfumato.memoryBytes;
    for (let i = 0; i < 20; ++i) once();
    same(sfumato.memoryBytes, bytes, "the memory");
  });
}

async function testCallbacks(tap, sfumato) {
  await tap.test("progress is reported, and may cancel", () => {
    const context = sfumato.context();
    const document = context.read(textOf(CONTROLS));
    const heard = new Map();
    context.onProgress = (stage, fraction) => heard.set(stage, fraction);
    context.solve(document);
    check(heard.get("gather") > 0 && heard.get("gather") <= 1, [...heard].join());
    context.onProgress = () => context.cancel();
    refusal(Status.cancelled, () => context.solve(document));
    context.onProgress = null;
    refusal(Status.cancelled, () => context.solve(document));
    context.resume();
    context.solve(document);
  });
  await tap.test("what a callback throws is thrown by the call", () => {
    const context = sfumato.context();
    const document = context.read(textOf(CONTROLS));
    const mine = new Error("mine");
    context.onProgress = () => {
      throw mine;
    };
    let thrown;
    try {
      context.solve(document);
    } catch (error) {
      thrown = error;
    }
    check(thrown === mine, String(thrown));
    context.onProgress = null;
    context.resume();
    context.solve(document);
  });
  await tap.test("files that a document names are asked for by their names", () => {
    const context = sfumato.context();
    const asked = [];
    const load = (href) => {
      asked.push(href);
      return null;
    };
    const text = textOf("examples/textures.svg");
    const error = refusal(Status.badInput, () => context.read(text, { name: "t.svg", load }));
    check(error.message.includes("the loader refused the file") && error.line > 0, error.message);
    check(asked.length === 1 && asked[0].endsWith(".png"), asked.join());
    refusal(Status.badInput, () => context.read(text));
    const bring = (href) => textOf(`examples/${href}`);
    refusal(Status.unavailable, () => context.read(text, { load: bring }));
    for (const name of ["hemp.png", "waves.png"]) {
      context.addImage(bring(name), { width: 1, height: 1, data: Uint8Array.of(1, 2, 3, 255) });
    }
    same(context.read(text, { load: bring }).layerCount, 1, "the number of layers");
    context.addImage(bring("hemp.png"), null);
    refusal(Status.unavailable, () => context.read(text, { load: bring }));
  });
}

/** Returns red in the middle of blue. */
function photoOf(side) {
  const data = new Uint8ClampedArray(4 * side * side);
  for (let i = 0; i < side * side; ++i) {
    const isInside = [i % side, Math.floor(i / side)].every((k) => k > side / 4 && k < 0.75 * side);
    data.set(isInside ? [220, 40, 30, 255] : [20, 60, 200, 255], 4 * i);
  }
  return { width: side, height: side, data };
}

async function testTraces(tap, sfumato) {
  await tap.test("a photo is traced, and each round reports its drawing", () => {
    const context = sfumato.context();
    const rounds = [];
    let lent = null;
    const drawing = context.trace(photoOf(32), { points: 300 }, (state, reached) => {
      rounds.push(state);
      lent = reached;
      check(reached.write().includes("<path"), "no curve was reached");
      same(reached.copy().curveCount(0), state.curves, "the curves of a copy");
    });
    same(drawing.artboard.join(), "0,0,32,32", "the artboard");
    same(rounds[0].psnr, 0, "the decibels before anything is fitted");
    check(rounds.at(-1).psnr > 25 && rounds.at(-1).controlPoints <= 300, JSON.stringify(rounds));
    refusal(Status.badUsage, () => lent.write());
    check(context.trace(photoOf(32), "points=300").curveCount(0) > 1, "a trace that nobody watches");
  });
  await tap.test("a drawing takes the colours of a photo", () => {
    const context = sfumato.context();
    const document = twoHalves(context);
    const photo = photoOf(32);
    photo.data.forEach((_, i) => (photo.data[i] = i % 4 === 3 ? 255 : i < 2048 ? 51 : 204));
    const fitted = context.fitColors(document, photo, { blur: "off" });
    const colorOf = (side) => fitted.stops(0, 0, side, Attribute.color).rows[0].slice(1);
    check(colorOf(Side.left).every((k) => Math.abs(k - 0.2) < 0.02), `above ${colorOf(Side.left)}`);
    check(colorOf(Side.right).every((k) => Math.abs(k - 0.8) < 0.02), `below ${colorOf(Side.right)}`);
    same(document.stops(0, 0, Side.left, Attribute.color).rows[0][1], 1, "the red of the original");
    refusal(Status.badUsage, () => context.fitColors(document, photo, "detail=1"));
  });
  await tap.test("a trace ends where its watch cancels or throws", () => {
    const context = sfumato.context();
    refusal(Status.cancelled, () => context.trace(photoOf(32), null, () => context.cancel()));
    context.resume();
    const mine = new Error("mine");
    mine.code = 77;
    const rounds = [];
    const error = refusal(77, () =>
      context.trace(photoOf(32), null, (state) => {
        rounds.push(state);
        throw mine;
      }),
    );
    check(error === mine && rounds.length === 1, `${error} after ${rounds.length} rounds`);
    context.resume();
    context.trace(photoOf(8)).free();
  });
  await tap.test("what is no photo, and options that no trace has, are refused", () => {
    const context = sfumato.context();
    refusal(Status.badUsage, () => context.trace({ ...photoOf(8), width: 9 }));
    const error = refusal(Status.badUsage, () => context.trace(photoOf(8), { detial: 1 }));
    check(error.message.includes("detail"), error.message);
  });
}

async function testWork(tap, sfumato, module) {
  await tap.test("the program of the document draws its horizon", async () => {
    const pixels = await drawExample(module);
    const at = (x, y) => [...pixels.subarray(4 * (400 * y + x), 4 * (400 * y + x) + 3)].join();
    check(pixels.length === 4 * 400 * 300, `${pixels.length} bytes`);
    same(at(0, 0), "248,190,187", "the sky's first pixel");
    same(at(200, 299), "28,43,31", "the land");
  });
  await tap.test("the version and the ABI are those of the header", () => {
    const cmake = textOf("CMakeLists.txt").toString();
    same(sfumato.version, /VERSION (\d+\.\d+\.\d+)/.exec(cmake)[1], "the version");
    same(sfumato.abi, 1, "the ABI");
  });
  await tap.test("a document that is built has the pixels of its sides", () => {
    const context = sfumato.context();
    const picture = context.solve(twoHalves(context));
    const pixels = context.raster(picture, { width: 8, height: 8, format: "rgb8" });
    check(pixels[0] > 240 && pixels[2] < 15, "red is not above");
    check(pixels[7 * 24] < 15 && pixels[7 * 24 + 2] > 240, "blue is not below");
    const fine = context.raster(picture, { width: 8, height: 8, format: "rgb16" });
    check(fine.length === pixels.length && fine[0] > 240 * 257, "16 bits");
  });
  await tap.test("what was set is read back, and SVG is written that reads back the same", () => {
    const context = sfumato.context();
    const document = twoHalves(context);
    const { kind, rows } = document.stops(0, 0, Side.left, Attribute.color);
    same(JSON.stringify([kind, rows]), "[2,[[0,1,0,0]]]", "the stops");
    same(document.points(0, 0).join(), "-8,32,16,32,48,32,72,32", "the points");
    const text = document.write();
    const again = context.read(text);
    same(again.write(), text, "the text");
    same(again.artboard.join(), "0,0,64,64", "the artboard");
    const copy = document.copy();
    document.removeCurve(0, 0);
    same(copy.curveCount(0) - document.curveCount(0), 1, "the curves of the copy more");
  });
  await tap.test("a curve has a weight", () => {
    const document = sfumato.context().read(textOf(CONTROLS));
    same(document.weight(1, 0), 1, "the weight of a curve without one");
    document.setWeight(1, 0, 2.5);
    same(document.weight(1, 0), 2.5, "the weight that was set");
    refusal(Status.badInput, () => document.setWeight(1, 0, 0));
    refusal(Status.badUsage, () => document.weight(9, 0));
  });
  await tap.test("curves lead back to their elements, also when others come and go", () => {
    const context = sfumato.context();
    const bytes = textOf(CONTROLS);
    const document = context.read(bytes);
    const { byteOffset, subpath } = document.curveSource(1, 1);
    same(bytes.subarray(byteOffset, byteOffset + 20).toString(), '<path d="M5 20 C25 8', "the text");
    same(subpath, 0, "the subpath");
    document.insertCurve(1, 0, document.points(1, 0));
    same(document.curveSource(1, 0), null, "the source of a new curve");
    same(document.curveSource(1, 2).byteOffset, byteOffset, "the offset after an insertion");
    document.removeCurve(1, 1);
    same(document.curveSource(1, 1).byteOffset, byteOffset, "the offset after a removal");
    refusal(Status.badUsage, () => document.curveSource(1, 2));
  });
  await tap.test("a drag says what is new, and ends as a fresh solution", () => {
    const context = sfumato.context();
    const document = context.read(textOf(CONTROLS));
    const picture = context.solve(document);
    document.setPoints(1, 1, document.points(1, 1).map((x) => x + 0.5));
    context.solveAgain(document, picture, { quick: true });
    same(picture.changes(0, Table.colorValues).length, 0, "the new rows of another layer");
    const { rows } = picture.table(1, Table.colorValues);
    check(picture.statistics.nodes > 0, "the nodes of a frame are counted");
    same(picture.changes(1, Table.colorValues).join(), `0,${rows}`, "the new rows");
    context.solveAgain(document, picture);
    const { curves, gatherSeconds } = picture.statistics;
    same(curves, document.curveCount(1), "the curves that were solved");
    check(gatherSeconds > 0, "the host's clock times the steps");
    const fresh = context.solve(document).table(1, Table.colorValues);
    same(picture.table(1, Table.colorValues).data.join(), fresh.data.join(), "the values");
  });
  await tap.test("a frame has as much time as it is given", () => {
    const context = sfumato.context();
    const document = context.read(
      '<svg xmlns="http://www.w3.org/2000/svg" xmlns:sf="urn:sfumato:1" viewBox="0 0 96 96">' +
        '<g sf:diffuse="true"><path d="M10 20C40 10 60 30 86 18" sf:left="#fff" sf:right="#036"/>' +
        '<path d="M12 50C30 70 60 30 84 52" sf:left="red" sf:right="gold"/></g></svg>',
    );
    const picture = context.solve(document);
    const move = () => document.setPoints(0, 0, document.points(0, 0).map((x) => x + 1));
    move();
    context.solveAgain(document, picture, { seconds: 60 });
    same(picture.statistics.waitingNodes, 0, "the nodes that wait within a minute");
    move();
    context.solveAgain(document, picture, { seconds: 0 });
    check(picture.statistics.waitingNodes > 0, "without time nodes wait");
    context.solveAgain(document, picture, { seconds: 60 });
    same(picture.statistics.waitingNodes, 0, "the nodes that wait behind a minute");
    refusal(Status.badUsage, () => context.solveAgain(document, picture, { seconds: -1 }));
  });
  await tap.test("frames of a film go on with the mesh of the one before", () => {
    const context = sfumato.context();
    const document = context.read(textOf(CONTROLS));
    const picture = context.solve(document, { coherent: true });
    const layers = picture.layerCount;
    document.setPoints(1, 1, document.points(1, 1).map((x) => x + 0.5));
    context.solveNext(document, picture);
    const { keptLayers, continuedLayers, begunLayers } = picture.statistics;
    same(keptLayers + continuedLayers + begunLayers, layers, "the layers of a frame");
    same(continuedLayers, 1, "the layers that go on");
    const still = context.solve(document);
    refusal(Status.badUsage, () => context.solveNext(document, still));
    picture.free();
    still.free();
  });
  await tap.test("warnings of the reader are heard", () => {
    const context = sfumato.context();
    context.read('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"/>', { name: "e.svg" });
    same(context.warnings.length, 2, "the number of warnings");
    check(context.warnings[1].startsWith("e.svg:1:1: the document has no layer"), "the words");
    context.read(textOf(CONTROLS));
    same(context.warnings.length, 0, "the number of warnings of the next document");
  });
}

export async function testCalls(tap, sfumato, module) {
  await testWork(tap, sfumato, module);
  await testTraces(tap, sfumato);
  await testErrors(tap, sfumato);
  await testLimits(tap, sfumato, module);
  await testCallbacks(tap, sfumato);
}
