// Radio groups made of buttons: one of them is in the tab order, arrows choose.
import type { TargetedKeyboardEvent } from "preact";

type Direction = "both" | "vertical" | "horizontal";

const stepOf = (key: string, direction: Direction) => {
  if (direction !== "vertical" && key === "ArrowLeft") return -1;
  if (direction !== "vertical" && key === "ArrowRight") return 1;
  if (direction !== "horizontal" && key === "ArrowUp") return -1;
  if (direction !== "horizontal" && key === "ArrowDown") return 1;
  return 0;
};

/** onKeyDown of the group. `role`: that of its members. */
export function radioKeys(role: "radio" | "tab" = "radio", direction: Direction = "both") {
  return (event: TargetedKeyboardEvent<HTMLElement>) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const step = stepOf(event.key, direction);
    if (step === 0 && event.key !== "Home" && event.key !== "End") return;
    const members = [...event.currentTarget.querySelectorAll<HTMLElement>(`[role=${role}]`)].filter(
      (member) => member.offsetParent !== null,
    );
    if (members.length === 0) return;
    const at = members.indexOf(document.activeElement as HTMLElement);
    const next = event.key === "Home" ? 0 : event.key === "End" ? members.length - 1 : at + step;
    const target = members[(next + members.length) % members.length];
    event.preventDefault();
    event.stopPropagation();
    target.focus();
    target.click();
  };
}
