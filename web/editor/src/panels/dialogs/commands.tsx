// Finds a command by its name and runs it.
import { useSignal } from "@preact/signals";
import { useId, useLayoutEffect, useRef } from "preact/hooks";
import type { TargetedKeyboardEvent } from "preact";
import { Icon } from "../../icons.js";
import * as en from "../../strings/en.js";
import { chordOf } from "../controls/chords.js";
import { commandsOf, matching, type NamedCommand } from "../menus/all.js";
import { useShell } from "../services.js";
import { Frame } from "./frame.js";

const words = en.dialogs;

interface RowProps {
  readonly id: string;
  readonly entry: NamedCommand;
  readonly isActive: boolean;
  readonly run: (entry: NamedCommand) => void;
}

function Row({ id, entry, isActive, run }: RowProps) {
  const { label, menu, command, checked, disabled, reason } = entry;
  const chord = chordOf(command);
  const row = useRef<HTMLLIElement>(null);
  useLayoutEffect(() => {
    if (isActive) row.current?.scrollIntoView({ block: "nearest" });
  }, [isActive]);
  return (
    <li
      ref={row}
      id={id}
      role="option"
      class="command"
      aria-selected={isActive}
      aria-disabled={disabled}
      onClick={() => run(entry)}
    >
      <span class="menu-mark">{checked && <Icon name="check" small />}</span>
      <span class="menu-label">
        {label}
        {disabled && reason && <small class="menu-reason">{reason}</small>}
      </span>
      <span class="muted">{menu}</span>
      {chord && <span class="menu-chord">{chord}</span>}
    </li>
  );
}

export function CommandsDialog() {
  const { editor } = useShell();
  const query = useSignal("");
  const active = useSignal(0);
  const input = useRef<HTMLInputElement>(null);
  const id = useId();
  const found = matching(commandsOf(editor), query.value);
  const at = Math.min(active.value, found.length - 1);
  // After the frame has taken the focus.
  useLayoutEffect(() => input.current?.focus(), []);
  const run = (entry: NamedCommand | undefined) => {
    if (!entry || entry.disabled) return;
    editor.dialog.value = null;
    entry.run(editor);
  };
  const key = (event: TargetedKeyboardEvent<HTMLInputElement>) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by !== undefined && found.length > 0) active.value = (at + by + found.length) % found.length;
    else if (event.key === "Enter") run(found[at]);
    else return;
    event.preventDefault();
  };
  return (
    <Frame title={words.commands} class="commands">
      <div class="dialog-body">
        <div class="field search">
          <span class="label" aria-hidden="true">
            <Icon name="search" small />
          </span>
          <input
            ref={input}
            type="text"
            role="combobox"
            aria-label={words.commands}
            aria-expanded="true"
            aria-controls={`${id}-list`}
            aria-activedescendant={found[at] && `${id}-${at}`}
            placeholder={words.findCommand}
            autocomplete="off"
            value={query.value}
            onInput={(event) => {
              query.value = event.currentTarget.value;
              active.value = 0;
            }}
            onKeyDown={key}
          />
        </div>
        <ul id={`${id}-list`} class="command-list" role="listbox" aria-label={words.commands}>
          {found.map((entry, index) => (
            <Row
              key={`${entry.menu} ${entry.label}`}
              id={`${id}-${index}`}
              entry={entry}
              isActive={index === at}
              run={run}
            />
          ))}
        </ul>
        <p class="muted" role="status">
          {found.length === 0 ? words.noCommand : ""}
        </p>
      </div>
    </Frame>
  );
}
