// The drawing that is open: where it came from, where it is saved to, and what the browser keeps of it.
import { signal, type Signal } from "@preact/signals";
import type { DrawingEditor } from "../app/editor.js";
import type { HistoryLog } from "../app/history.js";
import { Autosave, forgetDrawings, keptDrawings, recoverDrawing, type KeptHead } from "../files/autosave.js";
import { openDropped } from "../files/drop.js";
import { besideFiles, nothingBeside, type Beside } from "../files/images.js";
import { openFile, pickFile, type Opened, type Photo } from "../files/open.js";
import { newPlace, type Place } from "../files/place.js";
import { save, saveAs, type Saved } from "../files/save.js";
import { besideServed, openServed, servedName } from "../files/served.js";
import { answerOtherTabs, claim, isOpenElsewhere, type Claim } from "../files/tabs.js";
import { addReference } from "../model/commands/index.js";
import { blankText } from "../model/drawing.js";
import { SourceError } from "../source/tree.js";
import { en } from "../strings/en.js";
import { dataUri } from "./files.js";
import type { Pictures } from "./pictures.js";

const words = en.page;

/** Why a file could not be opened, and the line that is wrong. */
export interface Problem {
  readonly title: string;
  readonly reason: string;
  readonly line: number;
  readonly column: number;
  readonly source: string | null;
}

export class Documents {
  readonly problem: Signal<Problem | null> = signal(null);
  readonly kept: Signal<readonly KeptHead[]> = signal([]);
  #place: Place = newPlace("");
  #autosave: Autosave;
  #claim: Claim | null = null;
  /** Another tab goes on with the drawing: what this one kept would write over it. */
  #isTaken = false;
  #convert = (text: string) => this.editor.engine.convert(text);

  constructor(
    private readonly editor: DrawingEditor,
    private readonly pictures: Pictures,
  ) {
    this.#autosave = new Autosave(({ kept, reason }) => this.#keptIn(kept, reason));
    editor.onEdit = () => this.#edited();
    answerOtherTabs(() => (this.#place.target.kind === "handle" ? this.#place.target.handle : null));
    addEventListener("pagehide", () => void this.#autosave.flush());
    document.addEventListener("visibilitychange", () => {
      if (document.hidden) void this.#autosave.flush();
    });
    void this.refreshKept();
  }

  async refreshKept(): Promise<void> {
    this.kept.value = await keptDrawings();
  }

  /** The drawing that `sfumato edit` serves. @returns whether there is one */
  async openServed(): Promise<boolean> {
    const name = servedName();
    if (name === null) return false;
    await this.take(await openServed(name, this.#convert), besideServed);
    return true;
  }

  /** A drawing without a file. */
  async begin(text: string, name: string, beside: Beside = nothingBeside): Promise<void> {
    await this.#show(text, newPlace(name), beside);
  }

  async choose(): Promise<void> {
    const opened = await pickFile(this.#convert);
    if (opened) await this.take(opened);
  }

  async choosePhoto(): Promise<void> {
    const opened = await pickFile(this.#convert, "photo");
    if (opened) await this.take(opened);
  }

  /** Files that were dropped or pasted: one drawing or photo, and pictures that the drawing names. */
  async drop(files: readonly File[]): Promise<void> {
    const isDrawing = ({ name, type }: File) => /\.(svgz?|xml)$/i.test(name) || type === "image/svg+xml";
    const chosen = files.find(isDrawing) ?? files[0];
    const beside = besideFiles(files.filter((file) => file !== chosen));
    await this.take(await openFile(chosen, this.#convert), beside);
  }

  /** To be called while the event of a drop is handled. */
  dropEvent(data: DataTransfer): void {
    const dropped = openDropped(data, this.#convert);
    void dropped?.then(({ opened, beside }) => this.take(opened, besideFiles(beside)));
  }

  async take(opened: Opened, beside: Beside = nothingBeside): Promise<void> {
    if (opened.kind === "problem") return this.#refuse(words.notOpened, opened.reason);
    if (opened.kind === "photo") return this.#placePhoto(opened);
    const { target } = opened.place;
    if (target.kind === "handle" && (await isOpenElsewhere(target.handle))) this.editor.say(words.otherTab);
    await this.#show(opened.text, opened.place, beside);
  }

  async #show(text: string, place: Place, beside: Beside, id?: string, log?: HistoryLog): Promise<void> {
    this.pictures.begin(beside);
    const lost = await this.pictures.take(text);
    try {
      this.editor.open(text, place.name, log);
    } catch (error) {
      return this.#refuseText(place.name, error, text);
    }
    this.#place = place;
    this.#autosave.begin(id);
    void this.#claimTab();
    const isInFile = place.target.kind !== "none";
    this.editor.file.value = { name: place.name, isChanged: id !== undefined, kept: isInFile ? "file" : "browser" };
    if (lost.length > 0) this.editor.say(words.missing(lost));
  }

  /** Two tabs that recovered one drawing would write over each other. */
  async #claimTab(take = false): Promise<void> {
    this.#claim?.release();
    this.#isTaken = false;
    const lost = () => {
      this.#isTaken = true;
      this.editor.say(words.takenByTab);
    };
    this.#claim = await claim(this.#autosave.id, lost, take);
    if (!this.#claim) {
      const run = () => void this.#claimTab(true);
      this.editor.say(words.otherTab, { label: words.takeOver, run });
    }
  }

  #refuse(title: string, reason: string, place: Partial<Problem> = {}) {
    this.problem.value = { title, reason, line: 0, column: 0, source: null, ...place };
    this.editor.dialog.value = { kind: "problem" };
  }

  #refuseText(name: string, error: unknown, text: string) {
    if (!(error instanceof SourceError)) throw error;
    const { line, column, reason } = error;
    const source = text.split(/\r\n?|\n/)[line - 1] ?? null;
    this.#refuse(words.cannotOpen(name), reason, { line, column, source });
  }

  // Photos to trace over.

  async #placePhoto({ blob, name, width, height }: Photo): Promise<void> {
    const { editor } = this;
    if (editor.welcome.value) await this.begin(blankText(width, height, null), withoutExtension(name));
    const outcome = addReference(editor.drawing, await dataUri(blob), width, height);
    if (editor.run(words.placePhoto, outcome)) editor.showReference.value = true;
  }

  // Saving.

  async save(anyway = false): Promise<void> {
    this.#saved(await save(this.editor.drawing.text, this.#place, anyway), this.editor.drawing.revision);
  }

  async saveAs(): Promise<void> {
    this.#saved(await saveAs(this.editor.drawing.text, this.#place), this.editor.drawing.revision);
  }

  #saved(saved: Saved, revision: number) {
    const { editor } = this;
    if (saved.kind === "cancelled") return;
    if (saved.kind === "problem") return editor.say(saved.reason, { label: words.saveElsewhere, run: () => void this.saveAs() });
    if (saved.kind === "changed") {
      return editor.say(saved.reason, { label: words.saveAnyway, run: () => void this.save(true) });
    }
    this.#place = saved.place;
    const isChanged = editor.drawing.revision !== revision;
    editor.file.value = { name: saved.place.name, isChanged, kept: isChanged ? editor.file.value.kept : "file" };
    editor.say(saved.kind === "saved" ? words.saved(saved.place.name) : words.downloaded(saved.place.name));
    if (saved.kind === "saved" && !isChanged) void this.#autosave.forget().then(() => this.refreshKept());
  }

  // What the browser keeps.

  #edited() {
    const { editor } = this;
    if (!this.#isTaken) this.#keep();
    if (this.pictures.hasNew(editor.drawing.text)) void this.#takePictures();
  }

  #keep() {
    const { editor } = this;
    this.#autosave.edited(() => ({
      name: editor.file.value.name,
      curves: [...editor.drawing.all()].filter(({ kind }) => kind === "curve" || kind === "stroke").length,
      text: editor.drawing.text,
      undo: editor.log,
      place: this.#place,
    }));
  }

  async #takePictures(): Promise<void> {
    const lost = await this.pictures.take(this.editor.drawing.text);
    this.editor.showAgain();
    if (lost.length > 0) this.editor.say(words.missing(lost));
  }

  #keptIn(kept: "browser" | "nowhere", reason: string | null) {
    const { file } = this.editor;
    const isNews = kept === "nowhere" && file.value.kept !== "nowhere";
    if (file.value.isChanged) file.value = { ...file.value, kept };
    if (isNews && reason) this.editor.say(reason, { label: words.saveElsewhere, run: () => void this.saveAs() });
    void this.refreshKept();
  }

  async recover(id: string): Promise<void> {
    const found = await recoverDrawing(id);
    if (!found) return this.editor.say(words.gone);
    const place = found.place as Place;
    await this.#show(found.text, place, nothingBeside, id, found.undo as HistoryLog);
  }

  async forget(id: string): Promise<void> {
    await forgetDrawings([id]);
    await this.refreshKept();
  }
}

function withoutExtension(name: string): string {
  return `${name.replace(/\.[^.]+$/, "")}.svg`;
}
