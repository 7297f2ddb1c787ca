// All keys, to be found and changed.
import { useSignal, type Signal } from "@preact/signals";
import type { TargetedKeyboardEvent } from "preact";
import {
  keyBindings,
  keyName,
  resetKeys,
  setKeys,
  type KeyBinding,
  type KeyGroup,
} from "../../app/keys.js";
import { Icon } from "../../icons.js";
import * as en from "../../strings/en.js";
import { capsOf } from "../controls/chords.js";
import { nameOfCommand } from "../menus/names.js";
import { Frame } from "./frame.js";

const words = en.dialogs;
const groups: readonly KeyGroup[] = ["tools", "curve", "edit", "view", "arrange", "file"];

function Caps({ keys }: { readonly keys: readonly string[] }) {
  const [first] = keys;
  return first === undefined ? (
    <span class="muted">{words.noKey}</span>
  ) : (
    capsOf(first).map((cap) => <kbd key={cap}>{cap}</kbd>)
  );
}

interface KeyRowProps {
  readonly binding: KeyBinding;
  readonly isChanging: boolean;
  /** The command that waits for a key. */
  readonly waiting: Signal<string | null>;
  readonly message: Signal<string | null>;
}

const modifiers = ["Control", "Shift", "Alt", "Meta"];

function KeyRow({ binding, isChanging, waiting, message }: KeyRowProps) {
  const { command, keys } = binding;
  const name = nameOfCommand(command);
  const isWaiting = waiting.value === command;
  const take = (event: TargetedKeyboardEvent<HTMLButtonElement>) => {
    if (!isWaiting || event.key === "Tab" || modifiers.includes(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    waiting.value = null;
    if (event.key === "Escape") return;
    const taken = setKeys(command, [keyName(event)]);
    message.value =
      taken === null
        ? words.keySet(name, capsOf(keyName(event)).join(" "))
        : words.keyTaken(nameOfCommand(taken));
  };
  return (
    <div>
      <dt>{name}</dt>
      <dd>
        {isChanging ? (
          <button
            type="button"
            class={isWaiting ? "key-change waiting" : "key-change"}
            aria-label={
              isWaiting ? words.pressKeys : words.changeKeyOf(name, keys[0] ?? words.noKey)
            }
            onClick={() => {
              waiting.value = command;
              message.value = null;
            }}
            onBlur={() => {
              if (waiting.peek() === command) waiting.value = null;
            }}
            onKeyDown={take}
          >
            {isWaiting ? words.pressKeys : <Caps keys={keys} />}
          </button>
        ) : (
          <Caps keys={keys} />
        )}
      </dd>
    </div>
  );
}

const fits = (query: string, ...texts: readonly string[]) =>
  texts.some((text) => text.toLocaleLowerCase().includes(query.trim().toLocaleLowerCase()));

/** Keys that belong to the page's ways, and cannot be changed. */
function Fixed({ query }: { readonly query: string }) {
  const rows = words.fixedKeys.filter(({ name, keys }) => fits(query, name, ...keys));
  if (rows.length === 0) return null;
  return (
    <section class="keys-group">
      <h3>{words.moveAbout}</h3>
      <dl>
        {rows.map(({ name, keys }) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>
              {keys.map((key) => (
                <kbd key={key}>{key}</kbd>
              ))}
            </dd>
          </div>
        ))}
      </dl>
    </section>
  );
}

export function KeysDialog() {
  const query = useSignal("");
  const isChanging = useSignal(false);
  const waiting = useSignal<string | null>(null);
  const message = useSignal<string | null>(null);
  const found = keyBindings().filter(({ command, keys }) =>
    fits(query.value, nameOfCommand(command), ...keys),
  );
  const search = (
    <div class="field search">
      <span class="label" aria-hidden="true">
        <Icon name="search" small />
      </span>
      <input
        type="search"
        aria-label={words.findKey}
        placeholder={words.find}
        value={query.value}
        onInput={(event) => {
          query.value = event.currentTarget.value;
        }}
      />
    </div>
  );
  const foot = (
    <>
      <span class="muted foot-note" role="status">
        {message.value ?? (isChanging.value ? words.changeHint : words.macNote)}
      </span>
      <span class="spacer" />
      {isChanging.value && (
        <button type="button" class="button" onClick={resetKeys}>
          {words.resetKeys}
        </button>
      )}
      <button
        type="button"
        class={isChanging.value ? "button primary" : "button"}
        onClick={() => {
          isChanging.value = !isChanging.value;
          message.value = null;
        }}
      >
        {isChanging.value ? words.doneChanging : words.changeKeys}
      </button>
    </>
  );
  return (
    <Frame title={words.keys} class="keys" head={search} foot={foot}>
      <div class="dialog-body" tabIndex={0} role="group" aria-label={words.allKeys}>
        <div class="keys-grid">
          {groups.map((group) => {
            const rows = found.filter((binding) => binding.group === group);
            if (rows.length === 0) return null;
            return (
              <section key={group} class="keys-group">
                <h3>{words.keyGroups[group]}</h3>
                <dl>
                  {rows.map((binding) => (
                    <KeyRow
                      key={binding.command}
                      binding={binding}
                      isChanging={isChanging.value}
                      waiting={waiting}
                      message={message}
                    />
                  ))}
                </dl>
              </section>
            );
          })}
          <Fixed query={query.value} />
        </div>
      </div>
    </Frame>
  );
}
