// From linear light to the bytes of a photo.
import { normal } from "./random.mjs";

/** Highlights roll off, as on film. */
function tone(light) {
  const x = Math.max(0, light);
  return Math.min(1, (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14));
}

const code = (v) => (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);

/**
 * The picture as PPM. `light`: red, green and blue of each pixel; `exposure`: a factor of it;
 * `grain`: its standard deviation in code values of 255.
 */
export function develop(light, [width, height], { exposure, grain }) {
  const head = Buffer.from(`P6\n${width} ${height}\n255\n`);
  const bytes = Buffer.alloc(3 * width * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const far = ((x + 0.5) / width - 0.5) ** 2 + ((y + 0.5) / height - 0.5) ** 2;
      const falloff = exposure * (1 - 0.45 * far);
      const speck = grain * normal(x, y, 0);
      for (let c = 0; c < 3; ++c) {
        const at = 3 * (y * width + x) + c;
        const value = 255 * code(tone(light[at] * falloff));
        const shown = value + speck + 0.4 * grain * normal(x, y, 1 + c);
        bytes[at] = Math.min(255, Math.max(0, Math.round(shown)));
      }
    }
  }
  return Buffer.concat([head, bytes]);
}
