// F6 goes to the next region of the page, Shift F6 to the one before; each region remembers its focus.
const remembered = new WeakMap<Element, HTMLElement>();
const tabbable = 'button:not(:disabled):not([tabindex="-1"]), input:not(:disabled), [tabindex="0"]';

const visible = (element: HTMLElement) => element.getClientRects().length > 0;

function focusIn(region: HTMLElement) {
  const last = remembered.get(region);
  if (last?.isConnected && visible(last)) return last.focus();
  const first = [...region.querySelectorAll<HTMLElement>(tabbable)].find(visible);
  if (first) return first.focus();
  region.tabIndex = -1;
  region.focus();
}

/** Listens until the function that it returns is called. */
export function watchRegions(): () => void {
  const focus = (event: FocusEvent) => {
    const region = (event.target as Element).closest?.("[data-region]");
    if (region) remembered.set(region, event.target as HTMLElement);
  };
  const key = (event: KeyboardEvent) => {
    if (event.key !== "F6" || document.querySelector("dialog[open]")) return;
    const regions = [...document.querySelectorAll<HTMLElement>("[data-region]")].filter(visible);
    if (regions.length === 0) return;
    event.preventDefault();
    const at = regions.findIndex((region) => region.contains(document.activeElement));
    const step = event.shiftKey ? -1 : 1;
    focusIn(regions[at < 0 ? 0 : (at + step + regions.length) % regions.length]);
  };
  document.addEventListener("focusin", focus);
  document.addEventListener("keydown", key);
  return () => {
    document.removeEventListener("focusin", focus);
    document.removeEventListener("keydown", key);
  };
}
