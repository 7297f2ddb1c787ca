// Lightness upwards, chroma across, of one hue; what sRGB lacks is hatched.
import { useEffect, useRef } from "preact/hooks";
import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { isInGamut, largestChroma, rgbFromOklch, type Oklch } from "../../geometry/color.js";
import * as en from "../../strings/en.js";
import { follow } from "../controls/follow.js";
import { decimal } from "../format.js";

const words = en.picker;
/** Chroma at the right edge: sRGB has none beyond 0.323. */
export const MOST_CHROMA = 0.33;
/** Size of the drawing; the page stretches it. */
const WIDTH = 272;
const HEIGHT = 160;

/** All colours of a hue. Outside of sRGB nothing is drawn: the hatching below shows. */
function paint(canvas: HTMLCanvasElement, hue: number) {
  const context = canvas.getContext("2d");
  if (!context) return;
  const image = context.createImageData(WIDTH, HEIGHT);
  for (let y = 0; y < HEIGHT; y += 1) {
    const l = 1 - (y + 0.5) / HEIGHT;
    for (let x = 0; x < WIDTH; x += 1) {
      const rgb = rgbFromOklch({ l, c: ((x + 0.5) / WIDTH) * MOST_CHROMA, h: hue });
      if (!isInGamut(rgb)) break;
      image.data.set([rgb.r * 255, rgb.g * 255, rgb.b * 255, 255], 4 * (y * WIDTH + x));
    }
  }
  context.putImageData(image, 0, 0);
}

const clamp = (value: number) => Math.min(Math.max(value, 0), 1);

interface PlaneProps {
  readonly color: Oklch;
  readonly onChange: (color: Oklch) => void;
}

/** The nearest that sRGB has: the point slides along the border. */
const slid = (l: number, c: number, h: number): Oklch => ({
  l,
  c: Math.min(c, largestChroma(l, h)),
  h,
});

export function Plane({ color, onChange }: PlaneProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const hue = Math.round(color.h);
  useEffect(() => {
    if (canvas.current) paint(canvas.current, hue);
  }, [hue]);
  const press = (event: TargetedPointerEvent<HTMLDivElement>) => {
    if (event.button !== 0) return;
    const plane = event.currentTarget;
    const { h } = color;
    const go = ({ clientX, clientY }: PointerEvent) => {
      const box = plane.getBoundingClientRect();
      const l = 1 - clamp((clientY - box.top) / box.height);
      onChange(slid(l, clamp((clientX - box.left) / box.width) * MOST_CHROMA, h));
    };
    go(event);
    follow(plane, event, { slop: 0, onMove: go, onEnd: (isKept) => !isKept && onChange(color) });
  };
  const key = (event: TargetedKeyboardEvent<HTMLElement>) => {
    const by = event.shiftKey ? 0.1 : 0.01;
    const l = color.l + by * (event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0);
    const c =
      color.c +
      by * MOST_CHROMA * (event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0);
    if (l === color.l && c === color.c) return;
    event.preventDefault();
    event.stopPropagation();
    onChange(slid(clamp(l), Math.max(c, 0), color.h));
  };
  const hidden = (label: string, value: number, text: string, set: (value: number) => Oklch) => (
    <input
      type="range"
      class="visually-hidden"
      aria-label={label}
      aria-valuetext={text}
      min={0}
      max={100}
      value={value * 100}
      onInput={(event) => onChange(set(Number(event.currentTarget.value) / 100))}
      onKeyDown={key}
    />
  );
  return (
    <div class="plane" onPointerDown={press}>
      <canvas ref={canvas} width={WIDTH} height={HEIGHT} aria-hidden="true" />
      <span
        class="plane-point"
        style={{ "--x": clamp(color.c / MOST_CHROMA), "--y": 1 - color.l }}
      />
      <span class="axis-name up" aria-hidden="true">
        {words.lightness}
      </span>
      <span class="axis-name across" aria-hidden="true">
        {words.chroma}
      </span>
      {hidden(words.lightness, color.l, words.percent(decimal(color.l * 100, 1)), (l) =>
        slid(l, color.c, color.h),
      )}
      {hidden(words.chroma, color.c / MOST_CHROMA, decimal(color.c, 3), (c) =>
        slid(color.l, c * MOST_CHROMA, color.h),
      )}
    </div>
  );
}
