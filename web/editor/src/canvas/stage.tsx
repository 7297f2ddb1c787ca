// The stage: the picture's <canvas>, the handles above it, and what pointers and keys do there.
import { effect, untracked, useSignalEffect } from "@preact/signals";
import { useLayoutEffect, useMemo, useRef } from "preact/hooks";
import type { Editor, ToolName } from "../app/types.js";
import type { Point } from "../geometry/affine.js";
import * as en from "../strings/en.js";
import { Canvas } from "./canvas.js";
import "./canvas.css";
import { cssCursor } from "./cursors.js";
import type { PointerKind } from "./hit.js";
import { pressKey, releaseKey } from "./keyboard.js";
import { Overlay } from "./overlay.js";
import { Ground } from "./photos.js";
import { Pointers, type StagePointer } from "./pointers.js";
import { NO_SKETCH } from "./sketch.js";
import { makeTools } from "./tools/index.js";
import type { KeyPress, Tool } from "./tools/tool.js";
import { turnWheel, type Navigation } from "../app/view.js";
import { Rulers } from "./guides/rulers.js";
import { keyOf, letGoOfParts } from "./walk.js";

export interface StageProps {
  readonly editor: Editor;
  readonly navigation: Navigation;
  /** The canvas to draw into, once; null when it goes. Its size in pixels is the renderer's matter. */
  readonly onCanvas: (canvas: HTMLCanvasElement | null) => void;
  /** Opens the context menu at a place in the window, CSS pixels. */
  readonly onMenu: (x: number, y: number) => void;
}

/** One canvas with its tools for the life of an editor. */
interface Parts {
  readonly canvas: Canvas;
  readonly pointers: Pointers;
  readonly tool: () => Tool;
  readonly leave: (name: ToolName) => void;
}

function makeParts(editor: Editor, navigation: Navigation): Parts {
  const canvas = new Canvas(editor, navigation);
  const tools = makeTools(canvas);
  const tool = () => tools[editor.tool.peek()];
  return {
    canvas,
    tool,
    pointers: new Pointers(canvas, tool),
    leave: (name) => tools[name].leave?.(),
  };
}

export function Stage({ editor, navigation, onCanvas, onMenu }: StageProps) {
  const parts = useMemo(() => makeParts(editor, navigation), [editor, navigation]);
  const { canvas, pointers } = parts;
  const root = useRef<HTMLDivElement>(null);
  useStageSize(editor, root);
  useListeners(parts, root);
  useToolChanges(editor, parts);
  useFocus(canvas, root);
  return (
    <div
      ref={root}
      class="canvas-stage"
      role="application"
      aria-label={en.canvas.name}
      aria-description={en.canvas.describe}
      tabIndex={0}
      style={`cursor:${cssCursor(pointers.cursor.value)}`}
      onContextMenu={(event) => {
        event.preventDefault();
        onMenu(event.clientX, event.clientY);
      }}
    >
      <Ground canvas={canvas} />
      <CanvasElement onCanvas={onCanvas} />
      <Overlay canvas={canvas} />
      {editor.settings.rulers.value && <Rulers canvas={canvas} />}
    </div>
  );
}

function CanvasElement({
  onCanvas,
}: {
  readonly onCanvas: (canvas: HTMLCanvasElement | null) => void;
}) {
  const element = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    onCanvas(element.current);
    return () => onCanvas(null);
  }, [onCanvas]);
  return <canvas ref={element} aria-hidden="true" />;
}

function placeOf(root: HTMLElement | null, event: MouseEvent): Point {
  const box = root?.getBoundingClientRect();
  return [event.clientX - (box?.left ?? 0), event.clientY - (box?.top ?? 0)];
}

function useStageSize(editor: Editor, root: { current: HTMLDivElement | null }): void {
  useLayoutEffect(() => {
    const element = root.current;
    if (!element) return undefined;
    const measure = () => {
      const { width, height } = element.getBoundingClientRect();
      const { width: w, height: h } = editor.stage.peek();
      if (width !== w || height !== h) editor.stage.value = { width, height };
    };
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    measure();
    return () => observer.disconnect();
  }, [editor, root]);
}

function kindOf(event: PointerEvent): PointerKind {
  return event.pointerType === "pen" || event.pointerType === "touch" ? event.pointerType : "mouse";
}

function pointerOf(root: HTMLElement, event: PointerEvent): StagePointer {
  // Safari knows no coalesced events.
  const moments = event.type === "pointermove" ? (event.getCoalescedEvents?.() ?? []) : [];
  return {
    id: event.pointerId,
    kind: kindOf(event),
    button: event.button,
    at: placeOf(root, event),
    pressure: event.pressure,
    shift: event.shiftKey,
    alt: event.altKey,
    ctrl: event.ctrlKey || event.metaKey,
    time: event.timeStamp,
    trail: moments.map((moment) => ({
      at: placeOf(root, moment),
      time: moment.timeStamp,
      pressure: moment.pressure,
    })),
  };
}

function keyOfEvent(event: KeyboardEvent): KeyPress {
  return {
    key: event.key,
    shift: event.shiftKey,
    alt: event.altKey,
    ctrl: event.ctrlKey || event.metaKey,
  };
}

/** Listeners of the element itself: wheel and touch have to be able to prevent. */
function useListeners(parts: Parts, root: { current: HTMLDivElement | null }): void {
  useLayoutEffect(() => {
    const element = root.current;
    if (!element) return undefined;
    const { pointers, canvas, tool } = parts;
    const stop = new AbortController();
    const on = <K extends keyof HTMLElementEventMap>(
      name: K,
      act: (event: HTMLElementEventMap[K]) => void,
    ) => element.addEventListener(name, act, { signal: stop.signal, passive: false });
    on("pointerdown", (event) => {
      if (pointers.down(pointerOf(element, event)) && event.isTrusted)
        element.setPointerCapture(event.pointerId);
    });
    on("mousedown", (event) => {
      // The middle button would scroll. The others are left alone: they give the stage the focus.
      if (event.button === 1) event.preventDefault();
    });
    on("auxclick", (event) => {
      // Firefox on Linux would paste what is selected anywhere.
      if (event.button === 1) event.preventDefault();
    });
    on("pointermove", (event) => pointers.move(pointerOf(element, event)));
    on("pointerup", (event) => pointers.up(pointerOf(element, event)));
    on("pointercancel", (event) => pointers.lost(event.pointerId));
    on("lostpointercapture", (event) => pointers.lost(event.pointerId));
    on("pointerleave", () => pointers.leave());
    on("wheel", (event) => {
      event.preventDefault();
      turnWheel(canvas.navigation, event, placeOf(element, event));
    });
    // Safari's own pinch would zoom the page.
    element.addEventListener("gesturestart", (event) => event.preventDefault(), {
      signal: stop.signal,
    });
    on("keydown", (event) => {
      if (event.defaultPrevented || !pressKey(canvas, pointers, tool(), keyOfEvent(event))) return;
      event.preventDefault();
      event.stopPropagation();
    });
    on("keyup", (event) => releaseKey(pointers, tool(), keyOfEvent(event)));
    on("focusin", ({ target }) => {
      const key = target instanceof SVGElement && target.dataset.mark;
      if (key) canvas.grips.focused(key);
    });
    on("blur", () => pointers.space(false));
    return () => stop.abort();
  }, [parts, root]);
}

/**
 * Finishes a tool's pending work at once when another tool is chosen: a frame later the pointer may already
 * be down with the new one.
 */
function useToolChanges(editor: Editor, parts: Parts): void {
  useLayoutEffect(() => {
    let last = editor.tool.peek();
    return effect(() => {
      const now = editor.tool.value;
      if (now !== last) untracked(() => changeTool(editor, parts, last, now));
      last = now;
    });
  }, [editor, parts]);
}

function changeTool(editor: Editor, { pointers, leave, canvas }: Parts, from: ToolName, to: ToolName): void {
  pointers.cancel();
  leave(from);
  const { draft } = canvas.sketch.peek();
  canvas.sketch.value = { ...NO_SKETCH, draft };
  // The box surrounds whole items.
  if (to === "select") letGoOfParts(editor);
}

/** While the stage has the focus, it stands on the mark that is chosen, so that its name is read. */
function useFocus(canvas: Canvas, root: { current: HTMLDivElement | null }): void {
  useSignalEffect(() => {
    const chosen = canvas.marks.value.find((mark) => mark.isChosen);
    const element = root.current;
    if (!element?.contains(document.activeElement)) return;
    // The marks of now are drawn after this.
    requestAnimationFrame(() => {
      // Somebody may have gone to a field in the meantime.
      if (!element.contains(document.activeElement)) return;
      const mark = chosen && element.querySelector<SVGGElement>(`[data-mark="${keyOf(chosen)}"]`);
      if (mark) mark.focus({ preventScroll: true });
      else if (document.activeElement !== element) element.focus({ preventScroll: true });
    });
  });
}
