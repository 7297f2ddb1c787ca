// The site without a network: tools/service-worker.js keeps its files in this browser.
import { isOneFile } from "../engine/host.js";

/** Has the browser keep the site. One file needs nothing of the kind. */
export function keepOffline(): void {
  if (isOneFile || !isSecureContext || import.meta.env.DEV) return;
  navigator.serviceWorker?.register(new URL("sw.js", document.baseURI)).catch(() => undefined);
}
