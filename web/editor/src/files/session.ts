// The drawing that this tab has open, so that a reload shows it again.

/** In the tab's own storage: another tab begins with the first page. */
const key = "sfumato-drawing";

/** @param id of a stored drawing; null: the first page is shown */
export function rememberInTab(id: string | null): void {
  try {
    if (id === null) sessionStorage.removeItem(key);
    else sessionStorage.setItem(key, id);
  } catch {
    // Where the browser refuses, a reload shows the first page.
  }
}

/** Returns the id of the drawing that the tab had open; null: none. */
export function drawingOfTab(): string | null {
  try {
    return sessionStorage.getItem(key);
  } catch {
    return null;
  }
}
