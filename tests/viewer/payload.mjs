// The viewer's own reader, outside a browser: compared with the library's values, and given damaged data.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { isDeepStrictEqual } from "node:util";
import { PayloadError } from "../../web/viewer/bytes.js";
import { PictureReader, readStack } from "../../web/viewer/payload.js";
import { check, documentPath, randomNumbers } from "./harness.mjs";

/** A quarter of an 8-bit step. */
const LARGEST_MISS = 0.25 / 255 + 1e-7;

/** Compares the values of a layer's field at triangle t. Returns the largest difference. */
function fieldMiss(field, t, values, at) {
  let miss = 0;
  for (let slot = 0; slot < 10; ++slot) {
    const node = field.triangleNode[10 * t + slot];
    for (let c = 0; c < field.channelCount; ++c) {
      miss = Math.max(miss, Math.abs(field.value[field.channelCount * node + c] - values[at++]));
    }
  }
  return miss;
}

function checkLayer(layer, values, at) {
  const { color, opacity } = layer;
  const [triangleCount, colorChannels, opacityChannels] = values.subarray(at, at + 3);
  check(layer.triangleVertex.length === 3 * triangleCount, "the number of triangles");
  check(color.channelCount === colorChannels, "the channels of colour");
  check((opacity?.channelCount ?? 0) === opacityChannels, "the channels of opacity");
  const [x0, y0, x1, y1] = layer.bounds;
  const extent = Math.max(x1 - x0, y1 - y0);
  at += 3;
  for (let t = 0; t < triangleCount; ++t) {
    for (let k = 0; k < 3; ++k) {
      for (let axis = 0; axis < 2; ++axis) {
        const vertex = layer.triangleVertex[3 * t + k];
        const position = layer.positions[2 * vertex + axis] + layer.origin[axis];
        check(Math.abs(position - values[at++]) <= extent * 2 ** -22, `a corner of triangle ${t}`);
      }
    }
    for (const field of opacity ? [color, opacity] : [color]) {
      check(fieldMiss(field, t, values, at) <= LARGEST_MISS, `a node of triangle ${t}`);
      at += 10 * field.channelCount;
    }
  }
  return at;
}

const DAMAGES = 3000;

/** Reads a picture with changed bytes: it must be read, or refused with a message. */
function feedDamage(bytes, readPicture) {
  const random = randomNumbers(7);
  let refused = 0;
  for (let i = 0; i < DAMAGES; ++i) {
    const damaged = bytes.slice(
      0,
      i % 10 === 0 ? random.next().value % bytes.length : bytes.length,
    );
    for (let k = random.next().value % 4; k >= 0 && damaged.length > 0; --k) {
      damaged[random.next().value % damaged.length] = random.next().value & 255;
    }
    try {
      readPicture(damaged);
    } catch (error) {
      if (!(error instanceof PayloadError)) throw error;
      refused += 1;
    }
  }
  check(refused > DAMAGES / 10, `only ${refused} of ${DAMAGES} were refused`);
}

/** Expects that a stack has everything of its picture except the tables' content. */
function checkStack(stack, picture) {
  const layers = picture.layers.map(({ order, color, opacity }) => ({
    order,
    colorShaders: color.shaders,
    opacityShaders: opacity && opacity.shaders,
  }));
  const expected = { ...picture, layers };
  delete expected.exact;
  check(isDeepStrictEqual(stack, expected), "the stack is not the picture's");
}

function checkRefused(read, message) {
  try {
    read();
  } catch (error) {
    check(error instanceof PayloadError && error.message === message, error.message);
    return;
  }
  throw new Error(`not refused: ${message}`);
}

export async function testPayload(tap, { dump, command }) {
  const read = (document) => {
    const files = ["payload", "values", "stack"].map((name) => command.file(`picture.${name}`));
    execFileSync(dump, [documentPath(document), ...files]);
    const [payload, values, stack] = files;
    const bytes = new Uint8Array(readFileSync(payload));
    const raw = readFileSync(values);
    return {
      bytes,
      stack: new Uint8Array(readFileSync(stack)),
      values: new Float64Array(raw.buffer.slice(raw.byteOffset, raw.byteOffset + raw.length)),
    };
  };
  for (const document of [
    "../shared/scenes/lady_bug.xml",
    "examples/fish.svg",
    "tests/wasm/controls.svg",
  ]) {
    await tap.test(
      `the viewer reads ${document.split("/").at(-1)} within a quarter of a step`,
      () => {
        const { bytes, values } = read(document);
        const picture = new PictureReader(bytes).run();
        const end = picture.layers.reduce((at, layer) => checkLayer(layer, values, at), 0);
        check(end === values.length, "the number of values");
      },
    );
  }
  for (const document of ["tests/viewer/small.svg", "tests/viewer/compositing.svg"]) {
    await tap.test(`the stack of ${document.split("/").at(-1)} is its picture's`, () => {
      const { bytes, stack } = read(document);
      checkStack(readStack(stack), new PictureReader(bytes).run());
    });
  }
  await tap.test("damaged bytes are refused, never a crash", () => {
    const { bytes, stack } = read("tests/viewer/small.svg");
    feedDamage(bytes, (damaged) => new PictureReader(damaged).run());
    feedDamage(stack, readStack);
  });
  await tap.test("a picture is not taken for a stack, nor a stack for a picture", () => {
    const { bytes, stack } = read("tests/viewer/small.svg");
    checkRefused(() => readStack(bytes), "its version is 1, not 129");
    checkRefused(() => new PictureReader(stack).run(), "its version is 129, not 1");
  });
}
