// Follows light from a window through a scene of solids on a table before a wall.
import { Samples } from "./random.mjs";
import { hitSolid, surface } from "./solid.mjs";

const BOUNCES = 5;
const OFFSET = 4e-3;  // of rays from what they leave
const MIRROR = 0.08;  // rougher gloss asks the window itself for light
const CLAMP = 3;  // of indirect light, so that no single path makes a bright speck

const add = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0]];
const unit = (a) => {
  const k = 1 / Math.hypot(a[0], a[1], a[2]);
  return [a[0] * k, a[1] * k, a[2] * k];
};

/** The nearest hit of a ray: { t, solid }, where the table and the wall have no solid. */
function trace(scene, origin, direction) {
  let [t, solid] = [Infinity, null];
  if (direction[1] < 0 && origin[2] - origin[1] / direction[1] * direction[2] < scene.tableZ) {
    t = -origin[1] / direction[1];
  }
  if (direction[2] < 0) t = Math.min(t, (scene.wallZ - origin[2]) / direction[2]);
  for (const one of scene.solids) {
    const hit = hitSolid(one, origin, direction, t);
    if (hit >= 0) [t, solid] = [hit, one];
  }
  return { t, solid };
}

function isBlocked(scene, origin, direction, length) {
  return scene.solids.some((one) => hitSolid(one, origin, direction, length) >= 0);
}

/** A direction about n, as often as its cosine says. */
function scattered(n, samples) {
  const [a, r] = [2 * Math.PI * samples.next(), samples.next()];
  const side = unit(cross(Math.abs(n[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0], n));
  const other = cross(n, side);
  const k = Math.sqrt(r);
  return add(add(add([0, 0, 0], side, k * Math.cos(a)), other, k * Math.sin(a)), n,
    Math.sqrt(1 - r));
}

/** Returns the direction of a ray after reflection by a gloss of some roughness. */
function mirrored(direction, n, roughness, samples) {
  const [a, r] = [2 * Math.PI * samples.next(), samples.next()];
  const spread = roughness * Math.sqrt(r / (1.02 - r));
  const side = unit(cross(Math.abs(n[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0], n));
  const h = unit(add(add(n, side, spread * Math.cos(a)), cross(n, side), spread * Math.sin(a)));
  return unit(add(direction, h, -2 * dot(direction, h)));
}

/** Returns the light of the window at a point of it, u and v from 0 to 1: panes between bars. */
function windowLight(window, u, v) {
  const bar = (w, count) => Math.abs(w * count - Math.round(w * count)) / count;
  const isBar = bar(u, window.panes[0]) < 0.022 || bar(v, window.panes[1]) < 0.014;
  return isBar ? 0.03 : 0.72 + 0.55 * v;
}

/** Light of the room from a direction, with the window or without. */
function roomLight(scene, origin, direction, withWindow) {
  const { window } = scene;
  const facing = dot(direction, window.normal);
  if (withWindow && facing < 0) {
    const t = dot(add(window.at, origin, -1), window.normal) / facing;
    const p = add(add(origin, direction, t), window.at, -1);
    const u = dot(p, window.right) / dot(window.right, window.right) + 0.5;
    const v = dot(p, window.up) / dot(window.up, window.up) + 0.5;
    if (t > 0 && u > 0 && u < 1 && v > 0 && v < 1) {
      return window.color.map((c) => c * windowLight(window, u, v));
    }
  }
  return scene.room(direction);
}

/** How strongly a rough gloss (the GGX distribution) sends light from one direction to another. */
function glint(n, to, eye, roughness) {
  const h = unit(add(to, eye));
  const spread = roughness * roughness;
  const k = dot(n, h) ** 2 * (spread - 1) + 1;
  return spread / (Math.PI * k * k) / (4 * Math.max(dot(n, to), dot(n, eye), 0.05));
}

/** Light of the window that a surface sends towards `eye`, matt and glossy. */
function fromWindow(scene, point, n, eye, { color, mirror, roughness }, samples) {
  const { window } = scene;
  const [u, v] = [samples.next(), samples.next()];
  const to = add(add(add(window.at, window.right, u - 0.5), window.up, v - 0.5), point, -1);
  const length = Math.hypot(...to);
  const direction = to.map((x) => x / length);
  const [here, there] = [dot(direction, n), -dot(direction, window.normal)];
  if (here <= 0 || there <= 0 || isBlocked(scene, point, direction, length)) return [0, 0, 0];
  const area = Math.hypot(...window.right) * Math.hypot(...window.up);
  const k = windowLight(window, u, v) * here * there * area / (length * length);
  const gloss = roughness > MIRROR ? mirror * glint(n, direction, eye, roughness) : 0;
  return window.color.map((c, i) => c * k * ((1 - mirror) * color[i] / Math.PI + gloss));
}

/** Returns the surface at a hit: { n, color, gloss, roughness }. */
function look(scene, hit, point) {
  if (hit.solid) {
    const { p, n } = surface(hit.solid, point);
    const found = hit.solid.material(p, n);
    return { ...found, n: found.bump ? unit(add(n, found.bump)) : n };
  }
  return point[1] < 1e-4 ? { n: [0, 1, 0], ...scene.table(point) }
    : { n: [0, 0, 1], ...scene.wall(point) };
}

/**
 * Returns the light that comes back along a ray. It leaves out light that reaches a matt surface
 * from the window by a mirror: that would make bright specks.
 */
function light(scene, origin, direction, samples) {
  let [sum, weight, seesWindow] = [[0, 0, 0], [1, 1, 1], true];
  for (let bounce = 0; bounce < BOUNCES; ++bounce) {
    const hit = trace(scene, origin, direction);
    if (hit.t > 60) {
      const found = roomLight(scene, origin, direction, seesWindow);
      return sum.map((s, i) => s + weight[i] * Math.min(found[i], seesWindow ? Infinity : CLAMP));
    }
    const point = add(origin, direction, hit.t);
    const { n, color, gloss, roughness } = look(scene, hit, point);
    const from = add(point, n, OFFSET);
    const toEye = Math.max(0, -dot(direction, n));
    const mirror = gloss + (1 - gloss) * (1 - toEye) ** 5 * (1 - 0.7 * roughness);
    const chance = gloss ? 0.35 + 0.5 * mirror : 0;
    const eye = direction.map((v) => -v);
    const direct = fromWindow(scene, from, n, eye, { color, mirror, roughness }, samples);
    sum = sum.map((s, i) => s + weight[i] * Math.min(direct[i], bounce ? CLAMP : Infinity));
    if (samples.next() < chance) {
      direction = mirrored(direction, n, roughness, samples);
      if (dot(direction, n) <= 0) return sum;
      weight = weight.map((w) => w * mirror / chance);
      seesWindow &&= roughness <= MIRROR;
    } else {
      weight = weight.map((w, i) => w * color[i] * (1 - mirror) / (1 - chance));
      direction = scattered(n, samples);
      seesWindow = false;
    }
    origin = from;
    const survives = Math.min(1, 1.5 * Math.max(...weight));
    if (samples.next() >= survives) return sum;
    weight = weight.map((w) => w / survives);
  }
  return sum;
}

/** Calls visit(x, y, colour) for the pixels of every `stride`th row from `first`; linear light. */
export function photograph(scene, size, count, visit, first = 0, stride = 1) {
  const [width, height] = size;
  const { camera } = scene;
  const ahead = unit(add(camera.target, camera.at, -1));
  const right = unit(cross(ahead, [0, 1, 0]));
  const up = cross(right, ahead);
  const samples = new Samples();
  for (let y = first; y < height; y += stride) {
    for (let x = 0; x < width; ++x) {
      let sum = [0, 0, 0];
      for (let i = 0; i < count; ++i) {
        samples.begin(x, y, i);
        const u = ((x + samples.next()) / width - 0.5) * camera.width;
        const v = (0.5 - (y + samples.next()) / height) * camera.width * height / width;
        const [a, r] = [2 * Math.PI * samples.next(), camera.lens * Math.sqrt(samples.next())];
        const focus = add(add(add(camera.at, ahead, camera.focus), right, u * camera.focus), up,
          v * camera.focus);
        const eye = add(add(camera.at, right, r * Math.cos(a)), up, r * Math.sin(a));
        sum = add(sum, light(scene, eye, unit(add(focus, eye, -1)), samples));
      }
      visit(x, y, sum.map((s) => s / count));
    }
  }
}
