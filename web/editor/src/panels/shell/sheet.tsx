// Phones: the panels as a sheet from below, with three tabs and four heights.
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { TargetedPointerEvent } from "preact";
import * as en from "../../strings/en.js";
import { follow } from "../controls/follow.js";
import { radioKeys } from "../controls/radio.js";
import { useShell } from "../services.js";
import { HintList, Inspector, LayersPanel } from "./part.js";

const words = en.panels;
const tabs = ["curve", "layers", "hints"] as const;
type Tab = (typeof tabs)[number];

/** Heights of what is below the tabs, CSS pixels, for a window of a height. */
const detents = (height: number): readonly number[] => {
  const rest = height - 52 - 60 - 84;
  return [0, Math.min(214, rest), Math.round(height * 0.62) - 84, rest];
};
/** CSS pixels a millisecond: faster, and the sheet goes on to the next detent. */
const FLICK = 0.4;

/** The detent that a released sheet goes to. */
function landing(height: number, speed: number, all: readonly number[]): number {
  if (Math.abs(speed) > FLICK) {
    const beyond = speed > 0 ? all.filter((d) => d > height) : all.filter((d) => d < height);
    if (beyond.length > 0) return speed > 0 ? Math.min(...beyond) : Math.max(...beyond);
  }
  return all.reduce((best, d) => (Math.abs(d - height) < Math.abs(best - height) ? d : best));
}

interface GrabberProps {
  readonly height: number;
  readonly onMove: (height: number, isHeld: boolean) => void;
  readonly onStep: () => void;
}

function Grabber({ height, onMove, onStep }: GrabberProps) {
  const hasMoved = useRef(false);
  const drag = (event: TargetedPointerEvent<HTMLButtonElement>) => {
    const from = event.clientY;
    let now = height;
    let speed = 0;
    let last = { y: from, time: event.timeStamp };
    hasMoved.current = false;
    const move = (to: PointerEvent) => {
      hasMoved.current = true;
      speed = (last.y - to.clientY) / Math.max(to.timeStamp - last.time, 1);
      last = { y: to.clientY, time: to.timeStamp };
      const all = detents(innerHeight);
      now = Math.min(Math.max(height + from - to.clientY, 0), all[all.length - 1]);
      onMove(now, true);
    };
    const end = (isKept: boolean) => {
      if (hasMoved.current)
        onMove(isKept ? landing(now, speed, detents(innerHeight)) : height, false);
    };
    follow(event.currentTarget, event, { slop: 3, onMove: move, onEnd: end });
  };
  return (
    <button
      type="button"
      class="grabber"
      aria-label={words.sheetHeight}
      onPointerDown={drag}
      onClick={() => !hasMoved.current && onStep()}
    />
  );
}

export function Sheet() {
  const { editor } = useShell();
  const tab = useSignal<Tab>("curve");
  const height = useSignal(detents(innerHeight)[1]);
  const isHeld = useSignal(false);
  const label = (name: Tab) =>
    name === "hints" ? words.hintsTab(editor.hints.value.length) : words.sheetTabs[name];
  const step = () => {
    const all = detents(innerHeight);
    height.value = all.find((detent) => detent > height.value) ?? all[0];
  };
  const choose = (name: Tab) => {
    tab.value = name;
    if (height.value === 0) height.value = detents(innerHeight)[1];
  };
  return (
    <aside class="side sheet" aria-label={words.panels} data-region>
      <Grabber
        height={height.value}
        onMove={(to, held) => {
          isHeld.value = held;
          height.value = to;
        }}
        onStep={step}
      />
      <div class="sheet-tabs" role="tablist" aria-label={words.panels} onKeyDown={radioKeys("tab")}>
        {tabs.map((name) => (
          <button
            key={name}
            type="button"
            class="segment"
            role="tab"
            id={`tab-${name}`}
            aria-controls="sheet-body"
            aria-selected={tab.value === name}
            tabIndex={tab.value === name ? 0 : -1}
            onClick={() => choose(name)}
          >
            {label(name)}
          </button>
        ))}
      </div>
      <div
        id="sheet-body"
        class={isHeld.value ? "sheet-body held" : "sheet-body"}
        role="tabpanel"
        aria-labelledby={`tab-${tab.value}`}
        style={{ "--sheet": `${height.value}px` }}
      >
        {tab.value === "curve" && <Inspector />}
        {tab.value === "layers" && <LayersPanel />}
        {tab.value === "hints" && <HintList />}
      </div>
    </aside>
  );
}
