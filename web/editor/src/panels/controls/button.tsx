// Buttons with an icon, and what a tooltip needs to know of them.
import type { TargetedMouseEvent } from "preact";
import { Icon, type IconName } from "../../icons.js";
import { useShell } from "../services.js";
import { chordOf } from "./chords.js";

/** Attributes that give an element its name and its tooltip, with the key of `command`. */
export function useTip(label: string, command?: string) {
  const chord = chordOf(command);
  return {
    "aria-label": chord ? `${label} (${chord})` : label,
    "data-tip": label,
    ...(chord ? { "data-tip-key": chord } : {}),
  };
}

interface IconButtonProps {
  readonly icon: IconName;
  readonly label: string;
  /** Whose key stands in the tooltip; pressed, it is called where there is no onClick. */
  readonly command?: string;
  readonly small?: boolean;
  readonly pressed?: boolean;
  readonly expanded?: boolean;
  readonly disabled?: boolean;
  readonly popup?: "menu" | "dialog";
  readonly class?: string;
  readonly onClick?: (event: TargetedMouseEvent<HTMLButtonElement>) => void;
}

export function IconButton(props: IconButtonProps) {
  const { editor } = useShell();
  const tip = useTip(props.label, props.command);
  const names = ["icon-button", props.small ? "small" : "", props.class ?? ""]
    .filter(Boolean)
    .join(" ");
  return (
    <button
      type="button"
      class={names}
      {...tip}
      aria-pressed={props.pressed}
      aria-expanded={props.expanded}
      aria-haspopup={props.popup}
      disabled={props.disabled}
      onClick={(event) =>
        props.onClick ? props.onClick(event) : props.command && editor.command(props.command)
      }
    >
      <Icon name={props.icon} />
    </button>
  );
}
