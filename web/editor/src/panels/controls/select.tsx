// One of many: a button that opens a menu of them.
import { Icon } from "../../icons.js";
import { openMenu } from "./menu.js";

interface SelectProps<Value> {
  readonly label: string;
  readonly choices: readonly { readonly value: Value; readonly label: string }[];
  readonly value: Value | null;
  /** The text shown where value is null. */
  readonly mixed?: string;
  readonly grow?: boolean;
  readonly onChange: (value: Value) => void;
}

export function Select<Value extends string>({
  label,
  choices,
  value,
  mixed,
  grow,
  onChange,
}: SelectProps<Value>) {
  const now = choices.find((choice) => choice.value === value)?.label ?? mixed ?? "";
  const items = choices.map((choice) => ({
    label: choice.label,
    checked: choice.value === value,
    run: () => onChange(choice.value),
  }));
  return (
    <button
      type="button"
      class={grow ? "select grow" : "select"}
      aria-haspopup="menu"
      aria-label={`${label}: ${now}`}
      onClick={(event) => openMenu(label, items, event.currentTarget)}
    >
      {now}
      <Icon name="chevron-down" small />
    </button>
  );
}
