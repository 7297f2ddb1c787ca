// The numbers of a colour in the model that was chosen.
import { hsvFromRgb, rgbFromHsv, type Oklch, type Rgb } from "../../geometry/color.js";
import * as en from "../../strings/en.js";
import { NumberField } from "../controls/field.js";
import type { Sink } from "../controls/sink.js";

const words = en.picker;

export interface ModelProps {
  readonly color: Rgb;
  /** The same in OKLCH. A colour that became grey keeps its former hue. */
  readonly polar: Oklch;
  readonly onPolar: (polar: Oklch) => void;
  readonly onColor: (color: Rgb) => void;
}

interface Channel {
  readonly label: string;
  readonly name: string;
  readonly value: number;
  readonly digits: number;
  readonly max: number;
  readonly step: number;
  readonly set: (value: number) => void;
}

function oklch({ polar, onPolar }: ModelProps): readonly Channel[] {
  return [
    {
      label: "L",
      name: words.lightness,
      value: polar.l * 100,
      digits: 1,
      max: 100,
      step: 1,
      set: (v) => onPolar({ ...polar, l: v / 100 }),
    },
    {
      label: "C",
      name: words.chroma,
      value: polar.c,
      digits: 3,
      max: 0.4,
      step: 0.01,
      set: (c) => onPolar({ ...polar, c }),
    },
    {
      label: "H",
      name: words.hue,
      value: polar.h,
      digits: 1,
      max: 360,
      step: 1,
      set: (h) => onPolar({ ...polar, h }),
    },
  ];
}

function hsv({ color, onColor }: ModelProps): readonly Channel[] {
  const now = hsvFromRgb(color);
  return [
    {
      label: "H",
      name: words.hue,
      value: now.h,
      digits: 1,
      max: 360,
      step: 1,
      set: (h) => onColor(rgbFromHsv({ ...now, h })),
    },
    {
      label: "S",
      name: words.saturation,
      value: now.s * 100,
      digits: 1,
      max: 100,
      step: 1,
      set: (s) => onColor(rgbFromHsv({ ...now, s: s / 100 })),
    },
    {
      label: "V",
      name: words.value,
      value: now.v * 100,
      digits: 1,
      max: 100,
      step: 1,
      set: (v) => onColor(rgbFromHsv({ ...now, v: v / 100 })),
    },
  ];
}

function rgb({ color, onColor }: ModelProps): readonly Channel[] {
  return (["r", "g", "b"] as const).map((channel) => ({
    label: channel.toUpperCase(),
    name: words.channels[channel],
    value: color[channel] * 255,
    digits: 0,
    max: 255,
    step: 1,
    set: (value) => onColor({ ...color, [channel]: value / 255 }),
  }));
}

const models = { oklch, hsv, rgb } as const;

/** Within the picker all changes are one step: nothing to begin or keep. */
function direct(set: (value: number) => void, now: number): Sink<number> {
  return { set, begin: () => ({ show: set, keep: () => undefined, drop: () => set(now) }) };
}

export function ModelFields(props: ModelProps & { readonly model: keyof typeof models }) {
  return (
    <div class="four">
      {models[props.model](props).map((channel) => (
        <NumberField
          key={channel.label}
          label={channel.label}
          name={channel.name}
          value={channel.value}
          digits={channel.digits}
          min={0}
          max={channel.max}
          step={channel.step}
          sink={direct(channel.set, channel.value)}
        />
      ))}
    </div>
  );
}
