// Puts the editor together: the first page at once, and what works on drawings (work.tsx) after it.
import { computed, signal } from "@preact/signals";
import { render } from "preact";
import { DrawingEditor } from "./app/editor.js";
import { listenToKeys } from "./app/keyboard.js";
import { WorkerEngine } from "./engine/engine.js";
import { pageHost } from "./engine/page-host.js";
import { keepOffline } from "./files/offline.js";
import { drawingOfTab } from "./files/session.js";
import { blankText } from "./model/drawing.js";
import { listenToDrops } from "./page/drops.js";
import { examplesOf } from "./page/examples.js";
import { listenToPastes } from "./page/pastes.js";
import { App } from "./panels/app.js";
import { fetchParts } from "./panels/shell/part.js";
import * as en from "./strings/en.js";
import "./style/index.css";
import type { Work } from "./work.js";

const engine = new WorkerEngine(pageHost);
const editor = new DrawingEditor(engine, null, blankText(800, 600, null));
const later = signal<Work | null>(null);
/** Whether the drawing that this tab had open is on its way: the first page would only flash up. */
const isReturning = signal(drawingOfTab() !== null);

/** Keys, buttons, and what is dropped or pasted before it wait. */
async function fetchWork(): Promise<Work> {
  const { begin, commandsOf } = await import("./work.js");
  const work = begin(editor, engine);
  later.value = work;
  // An early request is separate from this: if it fails, the rest still works.
  queueMicrotask(() => editor.learn(commandsOf(work.documents)));
  void work.documents.openFirst().finally(() => (isReturning.value = false));
  return work;
}

const missing = () => editor.say(en.page.partsMissing);

const work = fetchWork();
const documents = work.then((there) => there.documents);
// A request for a file that does not arrive gets a message.
documents.catch(() => {
  isReturning.value = false;
  editor.learn({ get: () => missing });
});
const parts = fetchParts(work);
const recent = computed(() =>
  (later.value?.documents.kept.value ?? []).map(({ id, name, time, picture }) => ({
    name,
    time,
    picture,
    open: () => void later.value?.documents.recover(id),
  })),
);

listenToKeys(editor);
listenToDrops((pieces) => {
  documents.then((there) => there.takeDropped(pieces), missing);
});
listenToPastes((pasted) => {
  work.then((there) => there.paste(pasted), missing);
});
render(
  <App
    editor={editor}
    later={later}
    isReturning={isReturning}
    examples={examplesOf(documents)}
    recent={recent}
  />,
  document.getElementById("app")!,
);
// A script that drives the page finds all of it there.
void parts.then(() => work).then((there) => there.publish(), () => undefined);
keepOffline();
