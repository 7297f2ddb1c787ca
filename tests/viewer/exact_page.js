// Runs in the page of exact.mjs: gathers exact pixels of a picture.
import { Programs } from "/web/viewer/gl.js";
import { ExactPixels } from "/web/viewer/exact.js";
import { readPicture } from "/web/viewer/payload.js";

const text = async (path) => (await fetch(path)).text();

const frame = () => new Promise((resolve) => setTimeout(resolve, 1));

/** @returns pixels in the layout of the image: red, green, blue, alpha; -1: missing */
function pixelsOf(gl, exact, size) {
  const [image] = exact.images.values();
  const pixels = new Float32Array(4 * size[0] * size[1]);
  gl.bindFramebuffer(gl.FRAMEBUFFER, image.target.resolved);
  gl.readPixels(0, 0, ...size, gl.RGBA, gl.FLOAT, pixels);
  return [...pixels];
}

/**
 * Gathers the whole picture.
 * views: maps from the artboard to pixels, one after another; the last is read.
 * limit: of steps of a walk; isPaced: in shares as long as a page's.
 * @returns pixels gathered for the last view, or a reason; the compiled programs; and the shares: their pixels, how
 *   many were requested, and milliseconds
 */
export async function gathered({ size, views, limit, isPaced }) {
  const gl = document.createElement("canvas").getContext("webgl2");
  const picture = await readPicture(await text("/payload"));
  const programs = new Programs(gl);
  gl.bindVertexArray(gl.createVertexArray());
  const exact = new ExactPixels(gl, programs, picture);
  if (exact.reason) return { reason: exact.reason };
  exact.format = gl.RGBA32F;
  if (limit) exact.stepLimit = limit;
  const left = () => [...exact.images.values()].reduce((sum, { work }) => sum + work.left, 0);
  const shares = [];
  let worked = 0;
  for (const view of views) {
    exact.begin(size, view, () => [0, 0, ...size]);
    worked = left();
    while (!exact.isDone) {
      if (!isPaced) exact.pace.pixels = 1 << 14;
      const [start, before, aimed] = [performance.now(), left(), exact.pace.pixels];
      exact.step();
      while (exact.isBusy) await frame();
      shares.push({ pixels: before - left(), aimed, milliseconds: performance.now() - start });
    }
  }
  const error = gl.getError();
  const pixels = pixelsOf(gl, exact, size);
  const images = exact.images.size;
  exact.free();
  return { pixels, worked, images, error, shares, programs: [...programs.made.keys()] };
}
