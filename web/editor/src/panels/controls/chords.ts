// Keys of commands, as people and assistive technology read them.
import { keyLabel, keysOf } from "../../app/keys.js";

/** Caps of one key: "Ctrl+Shift+Z" is Ctrl, Shift, Z. "+" itself stands last. */
export function capsOf(key: string): readonly string[] {
  const parts = key.endsWith("+")
    ? [...key.slice(0, -1).split("+").filter(Boolean), "+"]
    : key.split("+");
  return parts.map((part) => keyLabel(part === "Shift" ? "⇧" : part));
}

/** The first key of a command in one line, or null. */
export function chordOf(command: string | undefined): string | null {
  const [first] = command ? keysOf(command) : [];
  return first === undefined ? null : capsOf(first).join(" ");
}

/** The same for aria-keyshortcuts: "Control+Z". */
export function ariaChord(command: string): string | undefined {
  const keys = keysOf(command);
  return keys.length > 0 ? keys.map((key) => key.replace("Ctrl", "Control")).join(" ") : undefined;
}
