// Image-domain shaders: reads the table of paints in the form of the GPU (docs/gpu.md, "The table of paints"), and
// makes the texels of textures from their files.

import { PayloadError } from "./bytes.js";
import { TABLE_WIDTH } from "./tables.js";

/** @import { Affine } from "./affine.js" */
/** @import { ByteReader } from "./bytes.js" */

/**
 * A texture's file.
 * @typedef {object} TextureFile
 * @property {number} width texels
 * @property {number} height
 * @property {string} type
 * @property {Uint8Array<ArrayBuffer>} bytes
 */

/**
 * @typedef {object} Paint
 * @property {number} first its first texel in the table
 * @property {Affine} paintFromLayer
 * @property {TextureFile | null} file none: a gradient
 */

/** @typedef {{table: Float32Array, paint: Paint[], texelCount: number}} Paints */

const FILE_TYPES = ["image/png", "image/jpeg"];

/** The first number of a paint that is a texture. */
const TEXTURE_KIND = 2;

/** Limits: levels of the largest texture, and texels of all textures. */
const MOST_LEVELS = 64;
const MOST_TEXELS = 64e6;

/**
 * @param {ByteReader} reader
 * @returns {Paints}
 */
export function readPaints(reader) {
  const table = reader.floatPlanes(4 * reader.count(16));
  const texelCount = reader.varint();
  const paint = Array.from({ length: reader.count(1) }, () => readPaint(reader, table));
  return { table, paint, texelCount };
}

/**
 * @param {ByteReader} reader
 * @param {Float32Array} table
 * @returns {Paint}
 */
function readPaint(reader, table) {
  const first = reader.varint();
  if (4 * first > table.length) throw new PayloadError("a paint of it is not there");
  const paintFromLayer = Array.from({ length: 6 }, () => reader.finite());
  const type = reader.u8();
  if (type === 0) return { first, paintFromLayer, file: null };
  if (type > FILE_TYPES.length) throw new PayloadError("a texture of it is of no known type");
  const width = reader.varint(),
    height = reader.varint();
  if (!(width * height > 0 && width * height <= MOST_TEXELS)) {
    throw new PayloadError("a texture of it has an impossible size");
  }
  const bytes = reader.counted().slice();
  return { first, paintFromLayer, file: { width, height, type: FILE_TYPES[type - 1], bytes } };
}

/**
 * A level of a texture, as in the table.
 * @typedef {object} TextureLevel
 * @property {number} width
 * @property {number} height
 * @property {number[]} period texels of the level
 * @property {number} first its first texel
 */

/**
 * Returns the levels of a texture after checking them.
 * @param {Paints} paints
 * @param {number} first texel of the paint in the table
 * @param {TextureFile} file
 * @returns {TextureLevel[]}
 */
function textureLevels({ table, texelCount }, first, file) {
  const texel = (/** @type {number} */ i) =>
    Array.from(table.subarray(4 * (first + i), 4 * (first + i) + 4));
  const [kind, , count] = texel(0);
  const fits = (/** @type {TextureLevel} */ level) =>
    [level.width, level.height, level.first].every(Number.isInteger) &&
    level.width > 0 &&
    level.height > 0 &&
    level.first >= 0 &&
    level.first + level.width * level.height <= texelCount;
  let isWhole = kind === TEXTURE_KIND && count >= 1 && count <= MOST_LEVELS;
  const levels = Array.from({ length: isWhole ? count : 0 }, (_, i) => {
    const [width, height, column, row] = texel(1 + 2 * i);
    return { width, height, period: texel(2 + 2 * i).slice(2), first: TABLE_WIDTH * row + column };
  });
  isWhole &&=
    levels.every(fits) && levels[0].width <= file.width && levels[0].height <= file.height;
  if (!isWhole) throw new PayloadError("the levels of a texture of it do not fit");
  return levels;
}

/**
 * Returns the texels of a file: red, green, blue, alpha; not premultiplied, not converted.
 * @param {WebGL2RenderingContext} gl
 * @param {TextureFile} file
 */
async function decodedTexels(gl, file) {
  /** @type {ImageBitmapOptions} */
  const options = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
  let bitmap;
  try {
    bitmap = await createImageBitmap(new Blob([file.bytes], { type: file.type }), options);
  } catch {
    throw new PayloadError("a texture of it is damaged");
  }
  if (bitmap.width !== file.width || bitmap.height !== file.height) {
    throw new PayloadError("a texture of it has another size than it should");
  }
  const rgba = new Uint8Array(4 * file.width * file.height);
  const side = 2048;
  for (let y = 0; y < file.height; y += side) {
    for (let x = 0; x < file.width; x += side) {
      const width = Math.min(side, file.width - x),
        height = Math.min(side, file.height - y);
      const part = await createImageBitmap(bitmap, x, y, width, height, options);
      const texels = texelsOf(gl, part);
      for (let row = 0; row < height; ++row) {
        const target = 4 * ((y + row) * file.width + x);
        rgba.set(texels.subarray(4 * row * width, 4 * (row + 1) * width), target);
      }
      part.close();
    }
  }
  bitmap.close();
  return rgba;
}

/**
 * Reads pixels through a texture, because a 2D canvas would multiply by alpha.
 * @param {WebGL2RenderingContext} gl
 * @param {ImageBitmap} bitmap
 */
function texelsOf(gl, bitmap) {
  const texture = gl.createTexture(),
    framebuffer = gl.createFramebuffer();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const texels = new Uint8Array(4 * bitmap.width * bitmap.height);
  gl.readPixels(0, 0, bitmap.width, bitmap.height, gl.RGBA, gl.UNSIGNED_BYTE, texels);
  gl.deleteFramebuffer(framebuffer);
  gl.deleteTexture(texture);
  return texels;
}

/**
 * Returns, along one axis, the texels of the previous level under each texel of a level, with shares that add up to
 * 1. Texels of the first level end at whole numbers; texels of the other levels divide the extent evenly.
 * @param {number} sourceCount
 * @param {boolean} sourceEven
 * @param {number} count
 * @param {number} extent
 */
function overlapsOf(sourceCount, sourceEven, count, extent) {
  const border = (
    /** @type {number} */ i,
    /** @type {number} */ n,
    /** @type {boolean} */ even,
  ) => {
    if (i === n) return extent;
    return even ? (extent * i) / n : i;
  };
  let first = 0;
  return Array.from({ length: count }, (_, i) => {
    const low = border(i, count, true),
      high = border(i + 1, count, true);
    while (first + 1 < sourceCount && border(first + 1, sourceCount, sourceEven) <= low) first += 1;
    const share = [];
    for (let k = first; k < sourceCount; ++k) {
      const from = Math.max(low, border(k, sourceCount, sourceEven));
      const to = Math.min(high, border(k + 1, sourceCount, sourceEven));
      if (k > first && !(to > from)) break;
      share.push((to - from) / (high - low));
    }
    return { first, share };
  });
}

/**
 * Fills a level with the area mean of the previous level.
 * @param {Uint16Array} texels of all levels
 * @param {TextureLevel} source
 * @param {TextureLevel} level
 * @param {number[]} extent of the texture, texels
 * @param {boolean} even whether the source's texels divide the extent evenly
 */
function fillLevel(texels, source, level, extent, even) {
  const columns = overlapsOf(source.width, even, level.width, extent[0]);
  const rows = overlapsOf(source.height, even, level.height, extent[1]);
  let out = 4 * level.first;
  for (const row of rows) {
    for (const column of columns) {
      const sum = [0.5, 0.5, 0.5, 0.5];
      row.share.forEach((down, j) => {
        let at = 4 * (source.first + (row.first + j) * source.width + column.first);
        for (const across of column.share) {
          for (let c = 0; c < 4; ++c) sum[c] += down * across * texels[at++];
        }
      });
      for (let c = 0; c < 4; ++c) texels[out++] = Math.min(sum[c], 65535);
    }
  }
}

/**
 * Returns all texels of all textures: 16 bits, colour times alpha, and alpha.
 * @param {WebGL2RenderingContext} gl
 * @param {Paints} paints
 */
export async function makeTexels(gl, paints) {
  // Levels add a third, and levels of a large period little more.
  if (paints.texelCount > 2 * MOST_TEXELS) throw new PayloadError("its textures are too large");
  const texels = new Uint16Array(4 * paints.texelCount);
  for (const { first, file } of paints.paint) {
    if (!file) continue;
    const levels = textureLevels(paints, first, file);
    fillBase(texels, levels[0], await decodedTexels(gl, file), file.width);
    const extent = levels[0].period;
    for (let i = 1; i < levels.length; ++i) {
      fillLevel(texels, levels[i - 1], levels[i], extent, i > 1);
    }
  }
  return texels;
}

/**
 * @param {Uint16Array} texels
 * @param {TextureLevel} level
 * @param {Uint8Array} rgba
 * @param {number} width of the file
 */
function fillBase(texels, level, rgba, width) {
  let out = 4 * level.first;
  for (let y = 0; y < level.height; ++y) {
    for (let at = 4 * y * width; at < 4 * (y * width + level.width); at += 4) {
      const alpha = rgba[at + 3];
      for (let c = 0; c < 3; ++c) {
        texels[out++] = Math.floor((2 * 257 * rgba[at + c] * alpha + 255) / 510);
      }
      texels[out++] = 257 * alpha;
    }
  }
}
