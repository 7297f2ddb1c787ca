// Puts the editor together.
import { render } from "preact";
import { commandTable } from "./app/commands.js";
import { listenToClipboard } from "./app/clipboard.js";
import { DrawingEditor } from "./app/editor.js";
import { listenToKeys } from "./app/keyboard.js";
import { PictureCanvas } from "./canvas/renderer.js";
import { Stage } from "./canvas/stage.js";
import { Thumbs } from "./canvas/thumbs.js";
import { WorkerEngine } from "./engine/engine.js";
import { createWorker, getModule } from "./engine/host.js";
import { keepOffline } from "./files/offline.js";
import { blankText } from "./model/drawing.js";
import { publish } from "./page/api.js";
import { fileCommands } from "./page/commands.js";
import { Documents } from "./page/documents.js";
import { listenToDrops } from "./page/drops.js";
import { Pictures } from "./page/pictures.js";
import { servicesOf } from "./page/services.js";
import { App } from "./panels/app.js";
import { fetchParts } from "./panels/shell/part.js";
import { en } from "./strings/en.js";
import "./style/index.css";

const engine = new WorkerEngine({ module: getModule, worker: createWorker });
const pictures = new Pictures(engine);
const commands = commandTable(fileCommands(() => documents));
const editor = new DrawingEditor(engine, commands, blankText(800, 600, null));
const documents: Documents = new Documents(editor, pictures);
const picture = new PictureCanvas(editor, en.page.graphics);
const thumbs = new Thumbs(editor, picture);
engine.onPicture = (update) => picture.take(update);

const attach = (canvas: HTMLCanvasElement | null) => picture.attach(canvas);
const stage = (
  <Stage
    editor={editor}
    navigation={editor.navigation}
    onCanvas={attach}
    onMenu={() => {}}
  />
);

listenToKeys(editor);
listenToDrops(documents);
listenToClipboard(editor, (files) => void documents.drop(files));
render(<App editor={editor} services={servicesOf(editor, documents, thumbs)} stage={stage} />, document.getElementById("app")!);
// Whoever drives the page finds all of it there.
void fetchParts().then(() =>
  publish(editor, documents, async () => {
    await editor.settled();
    await picture.drawn();
  }),
);
void documents.openServed();
keepOffline();
