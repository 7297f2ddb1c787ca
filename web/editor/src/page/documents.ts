// The drawing that is open: where it came from, where it is saved to, and what the browser keeps of it.
import { effect, signal, type Signal } from "@preact/signals";
import type { DrawingEditor } from "../app/editor.js";
import { isHistoryLog, type HistoryLog } from "../app/history.js";
import { complaintOf } from "../engine/complaint.js";
import {
  Autosave,
  forgetDrawings,
  keepPicture,
  keptDrawings,
  recoverDrawing,
  type Kept,
  type KeptEntry,
  type KeptWhere,
} from "../files/autosave.js";
import { openPieces } from "../files/drop.js";
import { isForeign } from "../files/foreign.js";
import { chooseFolder } from "../files/folder.js";
import { besideFiles, nothingBeside, type Beside } from "../files/images.js";
import { openFile, pickFile, type Opened, type OpenedDrawing, type Photo } from "../files/open.js";
import type { Piece } from "../files/pieces.js";
import { isPlace, newPlace, withExtension, type Place, type Saved } from "../files/place.js";
import { save, saveAs } from "../files/save.js";
import { drawingOfTab, rememberInTab } from "../files/session.js";
import { besideServed, openServed, servedName } from "../files/served.js";
import { answerOtherTabs, claim, isOpenElsewhere, type Claim } from "../files/tabs.js";
import { addReference, insertCentred } from "../model/commands/index.js";
import { blankText } from "../model/drawing.js";
import type { Foreign } from "../panels/services.js";
import { SourceError } from "../source/tree.js";
import * as en from "../strings/en.js";
import { dataUri } from "./files.js";
import type { Watch } from "../engine/other-text.js";
import { converted, curvesIn, type Converted } from "./foreign.js";
import { besideExamples } from "./gallery-pictures.js";
import type { Lost, Pictures } from "./pictures.js";

const words = en.page;

/** Why a file could not be opened, and the line that is wrong. */
export interface Problem {
  readonly title: string;
  readonly reason: string;
  readonly line: number;
  readonly column: number;
  readonly source: string | null;
}

/** Where a drawing comes from. */
interface Origin {
  readonly place: Place;
  /** Id of the stored drawing; absent: nothing is stored. */
  readonly id?: string;
  /** Whether a file has the stored drawing, or nothing was changed in it. */
  readonly isSafe?: boolean;
}

/** The opacity of a photo that is placed: what is drawn below it shows. */
const PLACED = 0.5;

/** Names are shown at most this long, characters. */
const LONGEST = 60;
/** Work that takes longer shows that it can be stopped, milliseconds. */
const LONG = 500;
const shortened = (name: string) => (name.length > LONGEST ? `${name.slice(0, LONGEST)}…` : name);

export class Documents {
  readonly problem: Signal<Problem | null> = signal(null);
  readonly foreign: Signal<Foreign | null> = signal(null);
  readonly kept: Signal<readonly KeptEntry[]> = signal([]);
  /** Id of the drawing whose changes were stored last; null: none yet. */
  readonly stored: Signal<string | null> = signal(null);
  #place: Place = newPlace("");
  #autosave: Autosave;
  #claim: Claim | null = null;
  /** Claims follow one another. */
  #claims: Promise<void> = Promise.resolve();
  /** Another tab goes on with the drawing: what this one kept would write over it. */
  #isTaken = false;
  /** The origin of the drawing that the editor is about to open. */
  #arriving: Origin | null = null;
  #isMissingPictures = false;
  /** Counts what was asked to be opened: the last of several wins. */
  #turn = 0;
  /** Saves follow one another: each depends on the result of the last one. */
  #saves: Promise<void> = Promise.resolve();
  #convert = (text: string) => this.editor.engine.convert(text);

  constructor(
    private readonly editor: DrawingEditor,
    private readonly pictures: Pictures,
  ) {
    this.#autosave = new Autosave((where) => this.#keptIn(where));
    editor.onEdit = () => this.#edited();
    editor.onUnseen = () => this.#tellUnseen();
    editor.onOpen = (name) => this.#adopt(this.#arriving ?? { place: newPlace(name) });
    effect(() => {
      // The problem of an earlier file no longer matters.
      if (editor.dialog.value?.kind !== "problem") this.problem.value = null;
      if (editor.dialog.value?.kind !== "foreign") this.foreign.value = null;
    });
    this.#forgetAtHome();
    answerOtherTabs(() => (this.#place.target.kind === "handle" ? this.#place.target.handle : null));
    addEventListener("pagehide", () => void this.#autosave.flush());
    document.addEventListener("visibilitychange", () => {
      if (document.hidden) void this.#autosave.flush();
    });
    addEventListener("beforeunload", (event) => {
      const { isChanged, kept } = editor.file.peek();
      // Nodes of an unfinished curve are stored nowhere.
      const hasDraft = (editor.draft.peek()?.undoLabel ?? null) !== null;
      if (hasDraft || (isChanged && kept === "nowhere")) event.preventDefault();
    });
    void this.refreshKept();
  }

  async refreshKept(): Promise<void> {
    this.kept.value = await keptDrawings();
  }

  /** After the person has gone to the first page, a reload shows it, too. */
  #forgetAtHome() {
    let wasOpen = false;
    effect(() => {
      const isOpen = !this.editor.welcome.value;
      if (wasOpen && !isOpen) rememberInTab(null);
      wasOpen = isOpen;
    });
  }

  /** Opens the drawing that `sfumato edit` serves, or the drawing that this tab had open before a reload. */
  async openFirst(): Promise<void> {
    const name = servedName();
    if (name !== null) return this.take(await openServed(name, this.#convert), besideServed);
    const id = drawingOfTab();
    if (id === null) return;
    const turn = this.#turn;
    const found = await recoverDrawing(id);
    // The person may have opened another one meanwhile.
    if (turn !== this.#turn) return;
    if (found) await this.#showKept(found);
    if (this.editor.welcome.peek()) rememberInTab(null);
  }

  /** A drawing of the gallery. */
  async beginExample(text: string, name: string): Promise<void> {
    await this.#show(text, { place: { ...newPlace(name), isExample: true } }, besideExamples);
  }

  /** A drawing without a file. */
  async begin(text: string, name: string, beside: Beside = nothingBeside): Promise<void> {
    await this.#show(text, { place: newPlace(name) }, beside);
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

  async takeDropped(pieces: readonly Piece[]): Promise<void> {
    const { opened, beside } = await openPieces(pieces, this.#convert);
    await this.take(opened, besideFiles(beside));
  }

  async take(opened: Opened, beside: Beside = nothingBeside): Promise<void> {
    if (opened.kind === "problem") return this.#refuse(words.notOpened, opened.reason);
    if (opened.kind === "photo") return this.#takePhoto(opened);
    if (isForeign(opened.text)) return this.#ask(opened, beside);
    await this.#open(opened, beside);
  }

  async #open({ text, place }: OpenedDrawing, beside: Beside): Promise<void> {
    const { target } = place;
    if (target.kind === "handle" && (await isOpenElsewhere(target.handle))) this.editor.say(words.otherTab);
    await this.#show(text, { place }, beside);
  }

  // Files of other programs.

  /** Asks what is to be done with a file that holds no curves; nothing is opened until then. */
  #ask(opened: OpenedDrawing, beside: Beside) {
    const { welcome, dialog } = this.editor;
    this.foreign.value = {
      name: opened.place.name,
      convert: (watch) => this.#convertForeign(opened, beside, watch),
      insert: welcome.peek() ? null : (watch) => this.#insertForeign(opened, beside, watch),
      open: () => this.#open(opened, beside),
    };
    dialog.value = { kind: "foreign" };
  }

  #converted(text: string, beside: Beside, watch: Watch): Promise<Converted> {
    return converted(this.editor.engine, this.pictures, text, beside, watch);
  }

  /** Its shapes as a drawing without a file: saving must not write over the other program's. */
  async #convertForeign({ text, place }: OpenedDrawing, beside: Beside, watch: Watch): Promise<void> {
    const asked = this.foreign.peek();
    const made = await this.#converted(text, beside, watch);
    // The person may have left the dialog.
    if (this.foreign.peek() !== asked) return;
    await this.#show(made.text, { place: newPlace(withExtension(place.name, "svg")) }, beside);
    this.#tellConverted(place.name, made);
  }

  /** Its shapes as layers of the present drawing, in one step of undo. */
  async #insertForeign({ text, place }: OpenedDrawing, beside: Beside, watch: Watch): Promise<void> {
    const asked = this.foreign.peek();
    const { drawing } = this.editor;
    const made = await this.#converted(text, beside, watch);
    if (this.foreign.peek() !== asked || this.editor.drawing !== drawing) return;
    this.editor.dialog.value = null;
    this.#insert(words.insertLayers, place.name, made);
  }

  /** Puts SVG text of another program into the drawing. */
  pasteForeign(text: string): Promise<void> {
    const pasted = this.#pasteForeign(text);
    this.editor.awaitEdit(pasted);
    return pasted;
  }

  async #pasteForeign(text: string): Promise<void> {
    const { drawing, task } = this.editor;
    const stop = new AbortController();
    const shown = setTimeout(() => (task.value = { text: words.converting, stop: () => stop.abort() }), LONG);
    try {
      const watch = { signal: stop.signal, onProgress: () => undefined };
      const made = await this.#converted(text, nothingBeside, watch);
      if (this.editor.drawing === drawing) this.#insert(en.commands.paste, words.pastedName, made);
    } catch (error) {
      if (!stop.signal.aborted) this.#refuse(words.nothingPasted, complaintOf(error));
    } finally {
      clearTimeout(shown);
      task.value = null;
    }
  }

  #insert(label: string, name: string, made: Converted) {
    const { editor } = this;
    const outcome = insertCentred(editor.drawing, made.text, editor.activeLayer?.handle ?? null);
    if (editor.run(label, outcome)) this.#tellConverted(name, made);
  }

  #tellConverted(name: string, { curves, leftOut }: Converted) {
    if (leftOut.length === 0) return this.editor.say(words.converted(shortened(name), curves));
    const show = () => this.#refuse(words.leftOutOf(shortened(name)), leftOut.join("\n"));
    this.editor.say(words.convertedPartly(shortened(name), curves), { label: words.showLeftOut, run: show });
  }

  async #show(text: string, origin: Origin, beside: Beside, log?: HistoryLog): Promise<void> {
    const turn = ++this.#turn;
    await this.editor.completeEdits();
    if (turn !== this.#turn) return;
    const besideBefore = this.pictures.begin(beside);
    const lost = await this.pictures.take(text);
    if (turn !== this.#turn) return;
    this.#arriving = origin;
    try {
      this.editor.open(text, origin.place.name, log);
    } catch (error) {
      this.pictures.begin(besideBefore);
      return this.#refuseText(origin.place.name, error, text);
    } finally {
      this.#arriving = null;
    }
    const { name, target } = origin.place;
    const isChanged = origin.id !== undefined && !origin.isSafe;
    this.editor.file.value = { name, isChanged, kept: isChanged || target.kind === "none" ? "browser" : "file" };
    this.editor.dialog.value = null;
    this.#tellLost(lost);
  }

  /** The editor opens a drawing; the one before it is still there. */
  #adopt({ place, id, isSafe }: Origin) {
    if (!this.#arriving) {
      this.#turn += 1;
      this.pictures.begin(nothingBeside);
    }
    this.#autosave.begin(id, isSafe);
    this.#place = place;
    this.#isTaken = false;
    // The command serves its drawing again after a reload.
    if (place.target.kind !== "served") {
      rememberInTab(this.#autosave.id);
      if (id === undefined) this.#autosave.safe(this.#state);
    }
    void this.#claimTab();
  }

  /** Two tabs that work on one drawing would write over each other. */
  #claimTab(take = false): Promise<void> {
    const key = this.#place.target.kind === "served" ? document.baseURI : this.#autosave.id;
    return (this.#claims = this.#claims.then(() => this.#claimKey(key, take)));
  }

  async #claimKey(key: string, take: boolean): Promise<void> {
    await this.#claim?.release();
    const lose = (text: string) => {
      this.#isTaken = true;
      this.#autosave.drop();
      this.editor.file.value = { ...this.editor.file.value, kept: "nowhere", lost: "elsewhere" };
      this.editor.say(text, { label: words.takeOver, run: () => void this.#takeOver() });
    };
    this.#claim = await claim(key, () => lose(words.takenByTab), take);
    if (!this.#claim) lose(words.otherTab);
  }

  async #takeOver(): Promise<void> {
    await this.#claimTab(true);
    const { file } = this.editor;
    this.#isTaken = false;
    file.value = { ...file.value, kept: "browser" };
    if (file.value.isChanged) this.#keep();
  }

  /** Shows at once why nothing of the drawing is visible, unless a message about missing pictures already did. */
  #tellUnseen() {
    const { dialog } = this.editor;
    if (!this.#isMissingPictures && dialog.peek() === null) dialog.value = { kind: "problem" };
  }

  #tellLost({ missing, broken }: Lost) {
    this.#isMissingPictures = missing.length > 0;
    if (missing.length > 0) {
      const action = { label: words.chooseFolder, run: () => void this.#chooseFolder() };
      this.editor.say(words.missing(missing.map(shortened)), action);
    } else if (broken > 0) {
      this.editor.say(words.brokenPictures(broken));
    }
  }

  /** Looks for the drawing's pictures in a folder that the person grants. */
  async #chooseFolder(): Promise<void> {
    const folder = await chooseFolder().catch(() => null);
    if (!folder) return;
    this.pictures.begin(folder);
    await this.#takePictures();
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

  // Photos to trace over, or by curves.

  /** The dialog that traces takes it, where that is open. */
  async #takePhoto(photo: Photo): Promise<void> {
    const { editor } = this;
    const traced = { blob: photo.blob, name: photo.name, artboardFromPhoto: null };
    if (editor.dialog.peek()?.kind === "trace") {
      editor.dialog.value = { kind: "trace", photo: traced };
    } else if (await this.#placePhoto(photo)) {
      editor.say(words.photoPlaced, { label: words.traceIt, run: () => editor.command("trace-photo") });
    }
  }

  /** @returns whether it lies on the drawing */
  async #placePhoto({ blob, name, width, height }: Photo): Promise<boolean> {
    const { editor } = this;
    if (editor.welcome.value) await this.begin(blankText(width, height, null), withoutExtension(name));
    const outcome = addReference(editor.drawing, await dataUri(blob), width, height, PLACED);
    const isPlaced = editor.run(words.placePhoto, outcome);
    if (isPlaced) editor.showReference.value = true;
    return isPlaced;
  }

  // Saving.

  save(anyway = false): Promise<void> {
    return this.#saveBy((text, place) => save(text, place, anyway));
  }

  saveAs(): Promise<void> {
    return this.#saveBy(saveAs);
  }

  #saveBy(write: (text: string, place: Place) => Promise<Saved>): Promise<void> {
    const saved = this.#saves.then(async () => {
      await this.editor.completeEdits();
      const { text, revision } = this.editor.drawing;
      const place = this.#place;
      this.#saved(await write(text, place), place, revision);
    });
    this.#saves = saved.catch(() => undefined);
    return saved;
  }

  #saved(saved: Saved, from: Place, revision: number) {
    const { editor } = this;
    if (saved.kind === "cancelled") return;
    const elsewhere = { label: words.saveElsewhere, run: () => void this.saveAs() };
    if (saved.kind === "problem") return editor.say(this.#withKept(saved.reason), elsewhere);
    if (saved.kind === "changed") {
      return editor.say(this.#withKept(saved.reason), { label: words.saveAnyway, run: () => void this.save(true) });
    }
    editor.say(saved.kind === "saved" ? words.saved(saved.place.name) : words.downloaded(saved.place.name));
    // Another drawing was opened in the meantime.
    if (this.#place !== from) return;
    this.#place = saved.place;
    const isChanged = editor.drawing.revision !== revision;
    const { kept, isWaiting } = editor.file.value;
    editor.file.value = { name: saved.place.name, ...(isChanged ? { isChanged, kept, isWaiting } : { isChanged, kept: "file" }) };
    if (saved.kind === "saved" && !isChanged) void this.#isSaved(saved.place);
  }

  /** A file has the drawing: lists show it no longer. */
  async #isSaved({ target }: Place): Promise<void> {
    if (target.kind === "served") await this.#autosave.forget();
    else {
      this.#autosave.safe(this.#state);
      await this.#autosave.flush();
    }
    await this.refreshKept();
  }

  #withKept(reason: string): string {
    return this.editor.file.value.kept === "browser" ? `${reason} ${words.keptHere}` : reason;
  }

  // Drawings stored in the browser.

  #edited() {
    const { editor } = this;
    if (!this.#isTaken) this.#keep();
    else if (!editor.toast.value) editor.say(words.takenByTab, { label: words.takeOver, run: () => void this.#takeOver() });
    if (this.pictures.hasNew(editor.drawing.text)) void this.#takePictures();
  }

  #keep() {
    const { editor } = this;
    editor.file.value = { ...editor.file.value, isWaiting: true };
    this.#autosave.edited(this.#state);
  }

  readonly #state = () => {
    const { file, drawing, log } = this.editor;
    return { name: file.value.name, curves: curvesIn(drawing), text: drawing.text, undo: log, place: this.#place };
  };

  async #takePictures(): Promise<void> {
    const lost = await this.pictures.take(this.editor.drawing.text);
    this.editor.showAgain();
    this.#tellLost(lost);
  }

  #keptIn(where: KeptWhere) {
    const { file } = this.editor;
    const isNews = file.value.kept !== "nowhere";
    const { isWaiting } = this.#autosave;
    if (file.value.isChanged) file.value = { ...file.value, ...where, isWaiting };
    if (where.kept === "nowhere" && isNews) {
      this.editor.say(en.files.notKept[where.lost], { label: words.saveElsewhere, run: () => void this.saveAs() });
    }
    if (where.kept === "browser") this.stored.value = this.#autosave.id;
    void this.refreshKept();
  }

  async recover(id: string): Promise<void> {
    // The drawing itself may have been left with changes that are not stored yet.
    await this.#autosave.flush();
    const found = await recoverDrawing(id);
    if (!found) return this.editor.say(words.gone);
    await this.#showKept(found);
  }

  /** A damaged history is left out; so is a damaged place, without which the drawing has no file. */
  async #showKept({ id, name, text, undo, place, isSafe }: Kept): Promise<void> {
    const from = isPlace(place) ? place : newPlace(name);
    const log = isHistoryLog(undo) ? undo : undefined;
    await this.#show(text, { place: from, id, isSafe }, from.isExample ? besideExamples : nothingBeside, log);
  }

  /** Id of the drawing that is open, if its changes are stored; null: they are not, or the first page is shown. */
  get storedNow(): string | null {
    const { id } = this.#autosave;
    return this.stored.peek() === id && !this.editor.welcome.peek() ? id : null;
  }

  /** Stores a picture of the drawing for lists of stored drawings. */
  async keepPicture(picture: Blob): Promise<void> {
    await keepPicture(this.#autosave.id, picture);
    await this.refreshKept();
  }

  async forget(id: string): Promise<void> {
    await forgetDrawings([id]);
    if (id === this.stored.peek()) this.stored.value = null;
    await this.refreshKept();
  }
}

function withoutExtension(name: string): string {
  return `${name.replace(/\.[^.]+$/, "")}.svg`;
}
