// The tools and the commands of the menus in one list, by name.
import type { Editor } from "../../app/types.js";
import * as en from "../../strings/en.js";
import type { MenuItem } from "../controls/menu.js";
import { mainMenu } from "./main.js";

export interface NamedCommand {
  readonly label: string;
  /** The menu that has it. */
  readonly menu: string;
  readonly command?: string;
  readonly checked?: boolean;
  readonly disabled?: boolean;
  readonly reason?: string | null;
  readonly run: (editor: Editor) => void;
}

function flattened(items: readonly MenuItem[], menu: string): readonly NamedCommand[] {
  return items.flatMap((item) => {
    if (item === "line") return [];
    if (item.items) return flattened(item.items, item.label);
    const { label, command, run, checked, disabled, reason } = item;
    const call = (editor: Editor) => (run ? run() : command && editor.command(command));
    return [{ label, menu, command, checked, disabled, reason, run: call }];
  });
}

export function commandsOf(editor: Editor): readonly NamedCommand[] {
  const tools = Object.entries(en.panels.tool).map(([tool, label]) => {
    const command = `tool-${tool}`;
    return { label, menu: en.panels.tools, command, run: (to: Editor) => to.command(command) };
  });
  const all = [...tools, ...flattened(mainMenu(editor, false), en.panels.help)];
  return all.filter(({ command }) => command !== "commands");
}

/** Returns the commands that contain all words of a query. Commands that begin with it come first. */
export function matching(commands: readonly NamedCommand[], query: string): readonly NamedCommand[] {
  const wanted = query.trim().toLocaleLowerCase();
  const parts = wanted.split(/\s+/);
  const has = ({ label, menu }: NamedCommand) => {
    const text = `${label} ${menu}`.toLocaleLowerCase();
    return parts.every((part) => text.includes(part));
  };
  const begins = ({ label }: NamedCommand) => label.toLocaleLowerCase().startsWith(wanted);
  const found = commands.filter(has);
  return [...found.filter(begins), ...found.filter((command) => !begins(command))];
}
