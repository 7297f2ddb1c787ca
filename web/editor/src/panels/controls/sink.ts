// Where a control's values go: into the drawing, as steps of undo, or into a setting.
import type { Signal } from "@preact/signals";
import type { Editor } from "../../app/types.js";
import type { Drawing, Outcome } from "../../model/types.js";

/** One movement of the pointer. */
export interface Movement<Value> {
  show(value: Value): void;
  keep(): void;
  drop(): void;
}

export interface Sink<Value> {
  /**
   * A value at once. `merges`: one step of undo together with those just before (held arrow keys).
   */
  set(value: Value, merges?: boolean): void;
  begin(): Movement<Value>;
}

/** `label` names the step of undo, `make` what a value means for the drawing. */
export function edits<Value>(
  editor: Editor,
  label: string,
  make: (value: Value, before: Drawing) => Outcome | null,
): Sink<Value> {
  return {
    set: (value, merges) =>
      void editor.run(label, make(value, editor.drawing), merges ? label : undefined),
    begin: () => {
      const gesture = editor.gesture(label);
      return {
        show: (value) => gesture.show((before) => make(value, before)),
        keep: () => gesture.keep(),
        drop: () => gesture.drop(),
      };
    },
  };
}

export function setting<Value>(signal: Signal<Value>): Sink<Value> {
  const set = (value: Value) => {
    signal.value = value;
  };
  return {
    set,
    begin: () => {
      const before = signal.peek();
      return { show: set, keep: () => undefined, drop: () => set(before) };
    },
  };
}

/** The same values, otherwise measured: percentages of what the drawing has from 0 to 1. */
export function mapped<From, To>(sink: Sink<To>, map: (value: From) => To): Sink<From> {
  return {
    set: (value, merges) => sink.set(map(value), merges),
    begin: () => {
      const movement = sink.begin();
      return {
        show: (value) => movement.show(map(value)),
        keep: movement.keep,
        drop: movement.drop,
      };
    },
  };
}
