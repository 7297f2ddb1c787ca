// The code that the editor needs from the first drawing on, in a separate file: the first page does not wait
// for it.
import { listenToCopying } from "./app/clipboard.js";
import { commandTable } from "./app/commands.js";
import type { DrawingEditor } from "./app/editor.js";
import { PictureCanvas } from "./canvas/renderer.js";
import { Stage } from "./canvas/stage.js";
import { Thumbs } from "./canvas/thumbs.js";
import type { WorkerEngine } from "./engine/engine.js";
import { publish } from "./page/api.js";
import { fileCommands } from "./page/commands.js";
import { watchDifference } from "./page/difference.js";
import { Documents } from "./page/documents.js";
import { takePasted } from "./page/pasted.js";
import type { Pasted } from "./page/pastes.js";
import { KeptPictures } from "./page/kept-pictures.js";
import { Pictures } from "./page/pictures.js";
import { servicesOf } from "./page/services.js";
import type { Later } from "./panels/app.js";
import { Menus } from "./panels/controls/menu.js";
import { prepareTour } from "./panels/tour/start.js";
import { Workplace } from "./panels/workplace.js";
import * as en from "./strings/en.js";

export interface Work extends Later {
  readonly documents: Documents;
  paste(pasted: Pasted): void;
  /** Hands the page to scripts. */
  publish(): void;
}

export function begin(editor: DrawingEditor, engine: WorkerEngine): Work {
  const documents = new Documents(editor, new Pictures(engine));
  const picture = new PictureCanvas(editor, en.page.graphics);
  const thumbs = new Thumbs(editor, picture);
  engine.onPicture = (update) => picture.take(update);
  const attach = (canvas: HTMLCanvasElement | null) => picture.attach(canvas);
  listenToCopying(editor);
  prepareTour(editor);
  watchDifference(editor);
  new KeptPictures(editor, documents, picture);
  return {
    documents,
    services: servicesOf(editor, documents, picture, thumbs),
    paste: (pasted) => takePasted(editor, documents, pasted),
    Menus,
    Workplace: () => (
      <Workplace>
        <Stage editor={editor} navigation={editor.navigation} onCanvas={attach} onMenu={() => {}} />
      </Workplace>
    ),
    publish: () =>
      publish(editor, documents, async () => {
        await editor.settled();
        await picture.drawn();
      }),
  };
}

/** Returns the commands that menus and keys name. */
export const commandsOf = (documents: Documents) => commandTable(fileCommands(() => documents));
