// Runs in the page of updates.mjs: the viewer's renderer with changing pictures.
import { makeTexels } from "/web/viewer/paints.js";
import { readPicture } from "/web/viewer/payload.js";
import { Renderer } from "/web/viewer/renderer.js";

const SIZE = [300, 180];

/** Counts every kind of object that a renderer makes. */
function counted(gl) {
  const live = {};
  for (const kind of [
    "Texture",
    "Framebuffer",
    "Renderbuffer",
    "Buffer",
    "Program",
    "VertexArray",
  ]) {
    live[kind] = 0;
    for (const [verb, step] of [
      ["create", 1],
      ["delete", -1],
    ]) {
      const call = gl[`${verb}${kind}`].bind(gl);
      gl[`${verb}${kind}`] = (...thing) => {
        if (verb === "create" || thing[0]) live[kind] += step;
        return call(...thing);
      };
    }
  }
  return live;
}

/** Returns the picture and the drawing parameters. */
export async function open() {
  const text = async (path) => (await fetch(path)).text();
  const canvas = document.querySelector("canvas");
  [canvas.width, canvas.height] = SIZE;
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false });
  const live = counted(gl);
  const picture = await readPicture(await text("/payload"));
  const texels = await makeTexels(gl, picture.paints);
  const [x0, y0, x1, y1] = picture.viewport;
  const zoom = Math.min(SIZE[0] / (x1 - x0), SIZE[1] / (y1 - y0));
  const frame = {
    size: SIZE,
    pixelFromArtboard: [zoom, 0, 0, zoom, -x0 * zoom, -y0 * zoom],
    desk: [0.5, 0.5, 0.5],
    mesh: false,
    lineScale: 1,
  };
  const make = (made) => new Renderer(gl, made, texels);
  return { gl, live, picture, texels, frame, make };
}

/** Returns the pictures of a renderer: coarse, with the mesh, and as fine as possible, in one array. */
function shown({ gl, frame }, renderer) {
  const byteCount = 4 * SIZE[0] * SIZE[1];
  const pixels = new Uint8Array(3 * byteCount);
  const read = (i) => {
    const part = pixels.subarray(i * byteCount, (i + 1) * byteCount);
    gl.readPixels(0, 0, SIZE[0], SIZE[1], gl.RGBA, gl.UNSIGNED_BYTE, part);
  };
  renderer.draw(frame);
  read(0);
  renderer.draw({ ...frame, mesh: true });
  read(1);
  renderer.draw(frame);
  while (renderer.canRefine) renderer.refine(frame);
  read(2);
  return pixels;
}

/** Returns the number of bytes that differ between two pictures. */
const differing = (a, b) => a.reduce((sum, value, i) => sum + (value === b[i] ? 0 : 1), 0);

/** Returns the pictures of a new renderer. */
function reference(stage, picture = stage.picture) {
  const renderer = stage.make(picture);
  const pixels = shown(stage, renderer);
  renderer.free();
  return pixels;
}

/** Returns a layer with fewer triangles, vertices and nodes, other values, and no or a wrong opacity. */
function draft(layer) {
  const part = (values, columns) =>
    values.slice(0, columns * Math.floor(values.length / columns / 3));
  const other = ({ channelCount, shaders, triangleNode, value }) => ({
    channelCount,
    shaders,
    triangleNode: part(triangleNode, 10).fill(0),
    value: part(value, channelCount).fill(0.25),
  });
  const color = other(layer.color);
  const half = {
    channelCount: 1,
    shaders: [],
    triangleNode: color.triangleNode,
    value: new Float32Array([0.5]),
  };
  return {
    ...layer,
    positions: part(layer.positions, 2),
    triangleVertex: part(layer.triangleVertex, 3).fill(0),
    edgeIsCurve: part(layer.edgeIsCurve, 3).fill(1),
    color,
    opacity: layer.opacity ? null : half,
  };
}

/** Returns ranges of a table of `count` rows in `n` pieces; `odd` chooses the odd or the even ones. */
function pieces(count, n, odd) {
  const ranges = [];
  for (let i = odd ? 1 : 0; i < n; i += 2) {
    ranges.push([Math.floor((i * count) / n), Math.floor(((i + 1) * count) / n)]);
  }
  return ranges;
}

/** Fills ranges of an array, whose length is final, from another array. */
function copied(target, source, columns, ranges) {
  const values = target.length === source.length ? target : new source.constructor(source.length);
  for (const [from, to] of ranges) {
    values.set(source.subarray(from * columns, to * columns), from * columns);
  }
  return values;
}

/** Turns a draft of a layer into the layer, in steps with their ranges. */
function finish(renderer, layer, wanted) {
  const update = (delta) => renderer.updateLayer(layer, delta);
  const all = (values, columns) => [[0, values.length / columns]];
  layer.positions = wanted.positions;
  layer.triangleVertex = wanted.triangleVertex;
  layer.edgeIsCurve = wanted.edgeIsCurve;
  layer.color = { ...wanted.color, value: new Float32Array(wanted.color.value.length) };
  layer.opacity = wanted.opacity;
  update({
    vertices: all(wanted.positions, 2),
    triangles: all(wanted.triangleVertex, 3),
    curveEdges: all(wanted.edgeIsCurve, 3),
    colorNodes: all(wanted.color.triangleNode, 10),
    colorValues: all(wanted.color.value, wanted.color.channelCount),
  });
  for (const odd of [false, true]) {
    const { channelCount, value } = wanted.color;
    const colorValues = pieces(value.length / channelCount, 30, odd);
    layer.color.value = copied(layer.color.value, value, channelCount, colorValues);
    update({ colorValues });
  }
}

/** Updates drafts to the picture. Returns how many bytes differ from a new one, before and after. */
export function byUpdates(stage) {
  const expected = reference(stage);
  const layers = stage.picture.layers.map(draft);
  const renderer = stage.make({ ...stage.picture, layers });
  const before = differing(shown(stage, renderer), expected);
  layers.forEach((layer, i) => finish(renderer, layer, stage.picture.layers[i]));
  const after = differing(shown(stage, renderer), expected);
  renderer.free();
  return { before, after };
}

/** Shows other stacks, then the picture's. Returns differing bytes, and textures made for layers that it kept. */
export function byStacks(stage) {
  const { picture, texels, live } = stage;
  const expected = reference(stage);
  const [, ...fewer] = picture.layers;
  const half = picture.stack.filter((item) => item.kind === "instance" && item.layer > 0);
  const lower = half.map((item) => ({ ...item, layer: item.layer - 1 }));
  const bare = { ...picture, layers: fewer, stack: lower };
  const renderer = stage.make(picture);
  const states = [];
  for (let i = 0; i < 3; ++i) {
    renderer.setPicture(bare, texels);
    const isStale = renderer.canRefine;
    const before = differing(shown(stage, renderer), expected);
    const textures = live.Texture;
    renderer.setPicture(picture, texels);
    const made = live.Texture - textures;
    states.push({ isStale, before, made, after: differing(shown(stage, renderer), expected) });
  }
  renderer.setPicture(bare, texels);
  const bareMiss = differing(shown(stage, renderer), reference(stage, bare));
  renderer.free();
  return { states, bareMiss };
}

/** Returns the GPU objects after the first frames, after many changes, and after the end. */
export function manyChanges(stage) {
  const { picture, texels, live, frame } = stage;
  const begin = { ...live };
  const renderer = stage.make(picture);
  const turned = { ...picture, stack: picture.stack.filter(({ kind }) => kind === "stroke") };
  const turn = () => {
    for (const next of [turned, picture]) {
      renderer.setPicture(next, texels);
      renderer.draw({ ...frame, mesh: true });
    }
  };
  turn();
  const first = { ...live };
  for (let i = 0; i < 20; ++i) {
    for (const layer of picture.layers) {
      for (let k = 0; k < 20; ++k) renderer.updateLayer(layer, { colorValues: [[k, k + 3]] });
    }
    turn();
  }
  const last = { ...live };
  renderer.free();
  return { begin, first, last, end: { ...live } };
}
