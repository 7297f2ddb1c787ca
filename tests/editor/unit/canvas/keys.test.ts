// Keys: each has one meaning, and the key codes of keyboards are recognised.
import { describe, expect, it } from "vitest";
import { commandTable } from "../../../../web/editor/src/app/commands.js";
import { defaultKeys, keyName } from "../../../../web/editor/src/app/keys.js";

/** Returns an event as keyboards send it. */
const sent = (key: string, more: Partial<KeyboardEvent> = {}) =>
  ({ key, code: "", ctrlKey: false, altKey: false, shiftKey: false, metaKey: false, ...more }) as KeyboardEvent;

describe("keys", () => {
  it("each has one meaning", () => {
    const all = defaultKeys.flatMap(({ keys }) => keys);
    expect(all.filter((key, i) => all.indexOf(key) !== i)).toEqual([]);
  });

  it("each command has a meaning", () => {
    const photos = ["difference", "colors-from-photo", "blur-from-photo", "snap-to-photo"];
    const ofPage = ["open", "save", "save-as", "paste", ...photos];
    const table = commandTable([]);
    const unknown = defaultKeys.filter(({ command }) => !table.has(command) && !ofPage.includes(command));
    expect(unknown.map(({ command }) => command)).toEqual([]);
  });

  it("are written as people write them", () => {
    expect(keyName(sent("z", { ctrlKey: true }))).toBe("Ctrl+Z");
    expect(keyName(sent("Z", { ctrlKey: true, shiftKey: true }))).toBe("Ctrl+Shift+Z");
    expect(keyName(sent("?", { shiftKey: true }))).toBe("?");
    expect(keyName(sent("+", { shiftKey: true }))).toBe("+");
    expect(keyName(sent("!", { code: "Digit1", shiftKey: true }))).toBe("Shift+1");
    expect(keyName(sent("Delete"))).toBe("Delete");
    expect(keyName(sent("]", { ctrlKey: true }))).toBe("Ctrl+]");
    expect(keyName(sent("ArrowUp", { shiftKey: true }))).toBe("Shift+ArrowUp");
  });
});
