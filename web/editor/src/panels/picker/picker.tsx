// The colour picker: a popover beside what it colours.
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import type { TargetedKeyboardEvent, TargetedPointerEvent } from "preact";
import { inGamut, oklchFromRgb, type Oklch, type Rgb } from "../../geometry/color.js";
import { hexOf } from "../../geometry/colortext.js";
import { remember } from "../../app/colors.js";
import { nameOfSide } from "../../app/side-names.js";
import type { PickerTarget } from "../../app/types.js";
import { swatchesOf } from "../../model/swatches.js";
import * as en from "../../strings/en.js";
import { colorsOf } from "../color.js";
import { IconButton } from "../controls/button.js";
import { follow } from "../controls/follow.js";
import { HexField } from "../controls/hex.js";
import { isPhone } from "../controls/media.js";
import { Select } from "../controls/select.js";
import { Slider } from "../controls/slider.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import { Alpha } from "./alpha.js";
import { ModelFields } from "./models.js";
import { left, usePlace } from "./place.js";
import { Plane } from "./plane.js";
import { useSession, type Session } from "./session.js";

const words = en.picker;
/** Colours of the document that are offered. */
const MOST = 24;
/** Chroma below this says nothing of the hue. */
const GREY = 0.002;

const hueTrack = "linear-gradient(90deg in oklch longer hue, oklch(.68 .16 0), oklch(.68 .16 360))";

/** OKLCH of the colour; of a grey, with the hue that was there before. */
function usePolar(color: Rgb): { polar: Oklch; setHue: (hue: number) => void } {
  const hue = useRef<number | null>(null);
  const exact = oklchFromRgb(color);
  if (
    exact.c > GREY &&
    (hue.current === null || Math.abs(((exact.h - hue.current + 540) % 360) - 180) > 1.5)
  )
    hue.current = exact.h;
  const setHue = (to: number) => {
    hue.current = to;
  };
  return { polar: { ...exact, h: hue.current ?? exact.h }, setHue };
}

function Swatches({
  title,
  colors,
  now,
  onChoose,
}: {
  title: string;
  colors: readonly Rgb[];
  now: Rgb;
  onChoose: (color: Rgb) => void;
}) {
  if (colors.length === 0) return null;
  return (
    <div>
      <h3 class="swatch-title">{title}</h3>
      <div class="swatches">
        {colors.map((color) => (
          <button
            key={hexOf(color)}
            type="button"
            class="swatch"
            style={{ "--c": hexOf(color) }}
            aria-label={hexOf(color)}
            aria-pressed={hexOf(color) === hexOf(now)}
            data-tip={hexOf(color)}
            onClick={() => onChoose(color)}
          />
        ))}
      </div>
    </div>
  );
}

/** The picker's name and heading: it colours a stop, several stops, or a whole side. */
function titlesOf({ side, stops }: PickerTarget, { item, list }: Session): { readonly title: string; readonly head: string } {
  const name = nameOfSide(item, side);
  const count = list.stops.length;
  if (!stops) return { title: words.titleOfSide(name), head: words.headOfSide(name) };
  if (stops.length > 1) {
    return { title: words.titleOfSeveral(name, stops.length), head: words.headOfSeveral(name, stops.length) };
  }
  return { title: words.title(name, stops[0] + 1), head: words.head(name, stops[0] + 1, count) };
}

/** New above, old below; a click on the lower half goes back. */
function Compare({ session }: { readonly session: Session }) {
  return (
    <span class="compare">
      <i style={{ "--c": hexOf(session.color) }} />
      <button
        type="button"
        style={{ "--c": hexOf(session.before) }}
        aria-label={words.goBack(hexOf(session.before))}
        data-tip={words.goBack(hexOf(session.before))}
        onClick={() => session.show({ color: session.before })}
      />
    </span>
  );
}

type EyeDropper = new () => {
  open(options: { signal: AbortSignal }): Promise<{ sRGBHex: string }>;
};

/** From the screen where the browser can, else from the picture. */
function usePick(onColor: (color: Rgb) => void) {
  const { services } = useShell();
  const abort = useRef(new AbortController());
  useEffect(() => () => abort.current.abort(), []);
  return async () => {
    abort.current.abort();
    abort.current = new AbortController();
    const { signal } = abort.current;
    const Dropper = (window as { EyeDropper?: EyeDropper }).EyeDropper;
    if (!Dropper) {
      const picked = await services.pickColor(signal);
      if (picked) onColor(picked);
      return;
    }
    const picked = await new Dropper().open({ signal }).catch(() => null);
    const value = picked ? Number.parseInt(picked.sRGBHex.slice(1), 16) : null;
    if (value !== null)
      onColor({ r: (value >> 16) / 255, g: ((value >> 8) & 255) / 255, b: (value & 255) / 255 });
  };
}

function Body({ session }: { readonly session: Session }) {
  const { editor } = useShell();
  const { colorModel, recent } = editor.settings;
  const { color } = session;
  const { polar, setHue } = usePolar(color);
  const showPolar = (to: Oklch) => {
    setHue(to.h);
    session.show({ color: inGamut(to) });
  };
  const setHueTo = (h: number) => showPolar({ ...polar, h });
  const choose = (to: Rgb) => {
    session.show({ color: to });
    remember(editor.settings, to);
  };
  const hueSink = {
    set: setHueTo,
    begin: () => ({ show: setHueTo, keep: () => undefined, drop: () => undefined }),
  };
  return (
    <div class="picker-body">
      <Plane color={polar} onChange={showPolar} />
      <div class="bars">
        <div class="bars-sliders">
          <Slider
            label={words.hue}
            value={polar.h}
            min={0}
            max={360}
            step={1}
            text={words.degrees(decimal(polar.h, 0))}
            track={hueTrack}
            sink={hueSink}
          />
          <Alpha session={session} />
        </div>
        <Compare session={session} />
      </div>
      <div class="row">
        <Select
          label={words.model}
          value={colorModel.value}
          choices={[
            { value: "oklch", label: "OKLCH" },
            { value: "hsv", label: "HSV" },
            { value: "rgb", label: "RGB" },
          ]}
          onChange={(model) => {
            colorModel.value = model;
          }}
        />
        <HexField grow marked name={words.hex} value={color} onChange={(to) => session.show({ color: to })} />
      </div>
      <ModelFields
        model={colorModel.value}
        color={color}
        polar={polar}
        onPolar={showPolar}
        onColor={(to) => session.show({ color: to })}
      />
      <Swatches
        title={words.palette}
        colors={swatchesOf(editor.drawing).map((swatch) => swatch.color)}
        now={color}
        onChoose={choose}
      />
      <Swatches title={words.recent} colors={recent.value} now={color} onChoose={choose} />
      <Swatches
        title={words.inPicture}
        colors={colorsOf(editor.drawing, MOST)}
        now={color}
        onChoose={choose}
      />
      <button type="button" class="button none-button" onClick={session.open}>
        <span class="swatch none" />
        {words.none}
      </button>
    </div>
  );
}

function Popover({ target }: { readonly target: PickerTarget }) {
  const { editor } = useShell();
  const popover = useRef<HTMLElement>(null);
  const opener = useRef<Element | null>(null);
  const session = useSession(editor, target);
  const phone = isPhone().value;
  const pick = usePick((color) => session?.show({ color }));
  usePlace(editor, target, popover, phone);
  useLayoutEffect(() => {
    opener.current = document.activeElement;
    const element = popover.current;
    element?.focus();
    // If the user has gone to another field, the focus stays there.
    const hadFocus = () => element?.contains(document.activeElement);
    return () => void (hadFocus() && (opener.current as HTMLElement | null)?.focus?.());
  }, []);
  useEffect(() => {
    if (!session) editor.picker.value = null;
  }, [session === null]);
  if (!session) return null;
  const { title, head } = titlesOf(target, session);
  const drag = (event: TargetedPointerEvent<HTMLElement>) => {
    if (event.button !== 0 || phone || (event.target as Element).closest("button")) return;
    const box = popover.current!.getBoundingClientRect();
    const grip = [event.clientX - box.left, event.clientY - box.top];
    const move = (to: PointerEvent) => {
      left.value = [to.clientX - grip[0], to.clientY - grip[1]];
      popover.current!.style.left = `${left.value[0]}px`;
      popover.current!.style.top = `${left.value[1]}px`;
    };
    follow(event.currentTarget, event, { slop: 2, onMove: move, onEnd: () => undefined });
  };
  const key = (event: TargetedKeyboardEvent<HTMLElement>) => {
    if (event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    session.close();
  };
  return (
    <section
      class="popover picker"
      role="dialog"
      aria-label={title}
      tabIndex={-1}
      ref={popover}
      data-region
      onKeyDown={key}
    >
      <div class="popover-head" onPointerDown={drag}>
        <h2>{head}</h2>
        <IconButton small icon="pipette" label={words.pick} onClick={() => void pick()} />
        <IconButton small icon="x" label={words.close} onClick={session.close} />
      </div>
      <Body session={session} />
    </section>
  );
}

export function Picker() {
  const { editor } = useShell();
  const target = editor.picker.value;
  return target && <Popover target={target} />;
}
