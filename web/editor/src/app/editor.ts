// The editor's state: the drawing, what is selected and seen, and every change of them.
import { batch, computed, effect, signal, untracked, type Signal } from "@preact/signals";
import type { Affine, Box, Point } from "../geometry/affine.js";
import type { Engine, EngineCurve, EngineStatus, Hint } from "../engine/types.js";
import { openDrawing } from "../model/drawing.js";
import type {
  Attribute,
  Change,
  Drawing,
  Handle,
  Item,
  Outcome,
  Part,
  Selection,
} from "../model/types.js";
import type { Style } from "../model/commands/index.js";
import { faultOf } from "../model/faults.js";
import { inverse, type Patch } from "../source/patch.js";
import * as en from "../strings/en.js";
import { isWorthTelling } from "../model/lint-worth.js";
import { united } from "./changes.js";
import { expectDrags } from "./expected.js";
import { LiveGesture } from "./gesture.js";
import { History, type HistoryLog, type Places } from "./history.js";
import { Isolation } from "./isolation.js";
import { openSettings } from "./settings.js";
import { quickChanges } from "./sync.js";
import type {
  Dialog,
  Difference,
  Draft,
  Editor,
  ExactState,
  FileState,
  Gesture,
  PickerTarget,
  Task,
  Toast,
  ToolName,
  ViewState,
} from "./types.js";
import { artboardFromStage, Navigation, seenBox, stageFromArtboard } from "./view.js";

/** Decimals are worth writing down to this part of a pixel. */
const STEP = 1 / 1000;
/** Hints are looked for when an exact picture has stood for this long, milliseconds. */
const HINT_REST = 1000;
/** The longest time that saving waits for edits whose colours the engine still evaluates, milliseconds. */
const EDIT_WAIT = 2000;

/** The work that the editor leaves to others: the commands that menus and keys name. */
type CommandTable = Pick<ReadonlyMap<string, (editor: DrawingEditor) => void>, "get">;

export class DrawingEditor implements Editor {
  readonly engine: Engine;
  readonly settings = openSettings();
  readonly navigation: Navigation;
  readonly opened = signal(0);
  readonly selection: Signal<Selection> = signal<Selection>([]);
  readonly #isolation = new Isolation(() => this.drawing);
  readonly isolated = this.#isolation.handle;
  readonly tool = signal<ToolName>("select");
  readonly attribute = signal<Attribute>("color");
  readonly hovered = signal<Handle | null>(null);
  readonly view = signal<ViewState>({ x: 0, y: 0, zoom: 1 });
  readonly stage = signal({ width: 1, height: 1 });
  readonly pointer = signal<Point | null>(null);
  readonly status = signal<EngineStatus>({ kind: "empty" });
  readonly hints = signal<readonly Hint[]>([]);
  readonly hintsKnown = computed(() => this.#hintedRevision.value === this.#revision.value);
  readonly hintsShown = signal(false);
  readonly file = signal<FileState>({ name: "", isChanged: false, kept: "nowhere" });
  readonly draft = signal<Draft | null>(null);
  readonly toast = signal<Toast | null>(null);
  readonly task = signal<Task | null>(null);
  readonly dialog = signal<Dialog>(null);
  readonly picker = signal<PickerTarget | null>(null);
  readonly copiedStyle = signal<Style | null>(null);
  readonly exactState = signal<ExactState>({ kind: "off" });
  readonly showMesh = signal(false);
  readonly showOutlines = signal(false);
  readonly showReference = signal(true);
  readonly showDifference = signal(false);
  readonly difference = signal<Difference | null>(null);
  readonly hideHandles = signal(false);
  readonly welcome = signal(true);
  readonly tour = signal<number | null>(null);
  readonly announcement = signal("");
  /** Called when the text has changed and rests. */
  onEdit: () => void = () => {};
  /** Called when a drawing that was opened cannot be drawn. */
  onUnseen: () => void = () => {};
  /** Called before another drawing replaces this one, whatever opens it. */
  onOpen: (name: string) => void = () => {};

  #drawing: Drawing;
  readonly #revision = signal(0);
  readonly #history = new History();
  #gesture: LiveGesture | null = null;
  /** Edits that are on their way. */
  readonly #coming = new Set<Promise<void>>();
  #commands: CommandTable | null;
  /** Commands that were requested before any were available. */
  #asked: string[] = [];
  /** Elements by their place, in the texts that the engine was given. */
  #snapshots = new Map<number, ReadonlyMap<number, Handle>>();
  #known = { serial: -1, curves: new Map<Handle, EngineCurve[]>() };
  /** The view that shows the whole artboard; the user's own view is another. */
  #fitted: ViewState | null = null;
  #hintTimer = 0;
  /** Whether the drawing could be drawn since it was opened. */
  #wasDrawn = false;
  /** The revision of the drawing that the hints describe. */
  readonly #hintedRevision = signal(-1);

  /** @param commands null: they come later, by learn() */
  constructor(engine: Engine, commands: CommandTable | null, text: string) {
    this.engine = engine;
    this.#commands = commands;
    this.#drawing = openDrawing(text);
    engine.onStatus = (status) => this.#hearStatus(status);
    this.navigation = new Navigation(this);
    effect(() => this.#keepFitted());
    effect(() => this.#look());
    expectDrags(this, (handle) => this.#engineCurves(handle));
  }

  get drawing(): Drawing {
    this.#revision.value;
    return this.#drawing;
  }

  readonly undoLabel = computed(() => this.draft.value?.undoLabel ?? this.#history.undoLabel.value);
  readonly redoLabel = computed(() => {
    const draft = this.draft.value;
    return draft ? draft.redoLabel : this.#history.redoLabel.value;
  });

  // Documents.

  /** @throws SourceError; what was open stays */
  open(text: string, name: string, log: HistoryLog = { done: [], undone: [] }): void {
    const drawing = openDrawing(text);
    this.#endGesture();
    this.draft.peek()?.drop();
    this.onOpen(name);
    batch(() => {
      this.#drawing = drawing;
      this.#history.restore(log);
      this.selection.value = [];
      this.#isolation.set(null);
      this.hovered.value = null;
      this.picker.value = null;
      this.hints.value = [];
      this.file.value = { name, isChanged: false, kept: "browser" };
      this.welcome.value = false;
      this.#revision.value += 1;
      this.fit();
    });
    this.#wasDrawn = false;
    this.opened.value = this.#showText(false);
  }

  /** The engine has what it lacked before. */
  showAgain(): void {
    this.#showText(false);
  }

  get log(): HistoryLog {
    return this.#history.log;
  }

  // Edits.

  run(label: string, outcome: Outcome | null, merge = ""): boolean {
    if (!outcome || outcome.patch.length === 0 || !this.#mayEdit()) return false;
    this.#endGesture();
    const before = this.#places();
    const change = this.#drawing.apply(outcome.patch);
    if (this.#refuses(change, outcome.patch, before)) return false;
    this.#record(label, outcome, before, merge && this.#mergeKey(merge, change));
    this.#changed(change, false);
    return true;
  }

  /** Reverts an edit that would make the drawing impossible to show, and says why. Returns whether it did. */
  #refuses(change: Change, patch: Patch, before: Places): boolean {
    const fault = faultOf(this.#drawing, change);
    if (fault === null) return false;
    const back = this.#drawing.apply(inverse(patch));
    if (faultOf(this.#drawing, back) !== null) {
      // The text was like this before.
      this.#drawing.apply(patch);
      return false;
    }
    this.say(en.commands.faults[fault]);
    batch(() => {
      this.#changed(united([change, back]), false);
      // An item that was moved there and back is a different item now.
      this.#select(before);
    });
    return true;
  }

  /** Edits of other objects, or other parts of one, are steps of their own. */
  #mergeKey(merge: string, { touched }: Change): string {
    return JSON.stringify([merge, this.selection.peek(), [...touched.keys()]]);
  }

  #mayEdit(): boolean {
    const { readOnly } = this.#drawing;
    if (readOnly) this.say(readOnly);
    return !readOnly;
  }

  #record(label: string, outcome: Outcome, before: Places, merge: string) {
    batch(() => {
      if (outcome.select) this.#selectMade(outcome.select);
      else this.#prune();
      this.#history.push({ label, patch: outcome.patch, before, after: this.#places() }, merge);
      this.file.value = { ...this.file.value, isChanged: true };
    });
  }

  /** A gesture that is still open (the picker's) is a step of its own before the next edit. */
  #endGesture() {
    this.#gesture?.keep();
    this.#gesture = null;
  }

  gesture(label: string): Gesture {
    this.#endGesture();
    const before = this.#places();
    this.#gesture = new LiveGesture({
      drawing: this.#drawing,
      apply: (patch: Patch) => this.#drawing.apply(patch),
      changed: (changes, moving) => this.#changed(united(changes), moving),
      keep: (outcome, change) => {
        if (this.#refuses(change, outcome.patch, before)) return;
        this.#record(label, outcome, before, "");
        this.#changed({ isStructural: false, touched: new Map() }, false);
      },
    });
    if (!this.#mayEdit()) this.#gesture.isOver = true;
    return this.#gesture;
  }

  get isInGesture(): boolean {
    return this.#gesture !== null && !this.#gesture.isOver;
  }

  awaitEdit(work: Promise<unknown>): void {
    const end = () => void this.#coming.delete(coming);
    const coming: Promise<void> = work.then(end, end);
    this.#coming.add(coming);
  }

  /** Does something after the edits that are on their way. @returns false: there are none */
  #isPutOff(act: () => void): boolean {
    if (this.#coming.size === 0) return false;
    void Promise.all(this.#coming).then(act);
    return true;
  }

  /**
   * Adds the draft of a tool to the drawing, and waits until all edits are complete. Call it before the
   * text is saved, or another drawing is opened.
   * @param most milliseconds
   */
  async completeEdits(most = EDIT_WAIT): Promise<void> {
    this.draft.peek()?.finish();
    if (this.#coming.size === 0) return;
    await Promise.race([Promise.all(this.#coming), new Promise((resolve) => setTimeout(resolve, most))]);
  }

  undo(): void {
    const draft = this.draft.peek();
    if (draft && draft.undoLabel !== null) return draft.undo();
    if (this.#isPutOff(() => this.undo())) return;
    draft?.drop();
    this.#endGesture();
    this.#replay(this.#history.undo());
  }

  redo(): void {
    const draft = this.draft.peek();
    if (draft) {
      if (draft.redoLabel !== null) draft.redo();
      return;
    }
    if (this.#isPutOff(() => this.redo())) return;
    this.#endGesture();
    this.#replay(this.#history.redo());
  }

  #replay(steps: readonly { readonly patch: Patch; readonly select: Places }[]) {
    if (steps.length === 0) return;
    batch(() => {
      const changes = steps.map(({ patch }) => this.#drawing.apply(patch));
      this.#select(steps.at(-1)!.select);
      this.file.value = { ...this.file.value, isChanged: true };
      this.#changed(united(changes), false);
    });
  }

  /** Notifies the engine and all observers that the text has changed. */
  #changed(change: Change, moving: boolean) {
    batch(() => {
      this.#revision.value += 1;
      if (change.isStructural) this.#prune();
      this.#isolation.follow();
    });
    const quick = quickChanges(this.#drawing, change, (handle) => this.#engineCurves(handle));
    this.#showText(moving, quick);
    if (!moving) this.onEdit();
  }

  /** @returns its number */
  #showText(moving: boolean, quick?: ReturnType<typeof quickChanges>): number {
    const serial = this.engine.show(this.#drawing.text, moving, quick);
    // The engine takes only the change from quick moves, and reads only the last text.
    if (quick && moving) return serial;
    // The engine names places in this text. They are looked up when it has read the text, perhaps after other
    // edits.
    const places = new Map<number, Handle>();
    for (const item of this.#drawing.all()) places.set(item.element.range.start, item.handle);
    this.#snapshots.set(serial, places);
    return serial;
  }

  // The engine's numbers.

  #engineCurves(handle: Handle): readonly EngineCurve[] {
    const { serial, curves } = this.engine.index;
    if (serial !== this.#known.serial) this.#learn(serial, curves);
    return this.#known.curves.get(handle) ?? [];
  }

  #learn(serial: number, curves: readonly EngineCurve[]) {
    const places = this.#snapshots.get(serial);
    const known = new Map<Handle, EngineCurve[]>();
    for (const curve of curves) {
      const handle = places?.get(curve.offset);
      if (handle === undefined) continue;
      known.set(handle, [...(known.get(handle) ?? []), curve]);
    }
    this.#known = { serial, curves: known };
    for (const old of this.#snapshots.keys()) if (old < serial) this.#snapshots.delete(old);
  }

  /** The engine's number of a layer, or null where it has no curves. */
  engineLayer(layer: Item): number | null {
    for (const child of layer.children) {
      const isShown = child.kind === "curve" || child.kind === "use";
      const found = isShown ? this.#engineCurves(child.handle)[0]?.layer : this.engineLayer(child);
      if (found !== undefined && found !== null) return found;
    }
    return null;
  }

  #hearStatus(status: EngineStatus) {
    this.status.value = status;
    if (status.kind === "exact") this.#wasDrawn = true;
    if (status.kind === "problem" && !this.#wasDrawn) this.onUnseen();
    clearTimeout(this.#hintTimer);
    if (status.kind === "exact") this.#hintTimer = setTimeout(() => void this.#lookForHints(), HINT_REST) as never;
  }

  async #lookForHints(): Promise<void> {
    const revision = this.#revision.peek();
    try {
      const hints = await this.engine.lint();
      if (!hints || this.#revision.peek() !== revision) return;
      batch(() => {
        this.hints.value = hints.filter((hint) => isWorthTelling(this.#drawing, hint, this.activeLayer));
        this.#hintedRevision.value = revision;
      });
    } catch {
      // An unreadable text has a status that says so.
      this.hints.value = [];
    }
  }

  // Selection.

  #places(): Places {
    return untracked(() => this.selection.value).flatMap(({ handle, part }) => {
      const item = this.#drawing.item(handle);
      return item ? [{ at: item.element.range.start, part }] : [];
    });
  }

  #select(places: readonly { readonly at: number; readonly part?: Part }[]) {
    this.selection.value = places.flatMap(({ at, part = { kind: "whole" } }) => {
      const item = this.#drawing.itemAt(at);
      return item ? [{ handle: item.handle, part }] : [];
    });
  }

  /** Selects what an edit has made. An object outside the isolated item ends the isolation. */
  #selectMade(places: readonly { readonly at: number; readonly part?: Part }[]) {
    this.#select(places);
    const isWithin = ({ handle }: { readonly handle: Handle }) => this.#isolation.has(this.#drawing.item(handle) ?? null);
    if (!this.selection.value.every(isWithin)) this.isolate(null);
  }

  isolate(handle: Handle | null): void {
    const before = this.isolated.value;
    this.#isolation.set(handle);
    const now = this.isolated.value;
    const item = now === null ? undefined : this.#drawing.item(now);
    if (now !== before) this.announcement.value = en.commands.isolation(item?.name ?? null);
  }

  /** Removes items that no longer exist from the selection. */
  #prune() {
    const { value } = this.selection;
    const there = value.filter(({ handle }) => this.#drawing.item(handle));
    if (there.length < value.length) this.selection.value = there;
    const { hovered, picker } = this;
    if (hovered.value !== null && !this.#drawing.item(hovered.value)) hovered.value = null;
    if (picker.value && !this.#drawing.item(picker.value.handle)) picker.value = null;
  }

  get activeLayer(): Item | null {
    const { drawing } = this;
    for (const { handle } of [...this.selection.value].reverse()) {
      let item: Item | null = drawing.item(handle) ?? null;
      while (item && item.kind !== "layer") item = item.parent;
      if (item && !item.locked && this.#isolation.has(item)) return item;
    }
    const isFree = (item: Item) => item.kind === "layer" && !item.locked && !item.hidden && this.#isolation.has(item);
    const layers = [...drawing.all()].filter(isFree);
    return layers.at(-1) ?? null;
  }

  step(item: Item | null): number {
    const [a, b, c, d] = item?.artboardFromItem ?? [1, 0, 0, 1];
    const scale = Math.sqrt(Math.abs(a * d - b * c)) || 1;
    return STEP / (this.view.value.zoom * scale);
  }

  /** When what is shown is the exact picture, or cannot be. */
  settled(): Promise<void> {
    return new Promise((resolve) => {
      const stop = effect(() => {
        if (this.status.value.kind === "refining") return;
        resolve();
        queueMicrotask(() => stop());
      });
    });
  }

  // View.

  artboardFromStage(): Affine {
    const { width, height } = this.stage.value;
    return artboardFromStage(this.view.value, width, height);
  }

  stageFromArtboard(): Affine {
    const { width, height } = this.stage.value;
    return stageFromArtboard(this.view.value, width, height);
  }

  fit(box?: Box): void {
    this.navigation.fit(box, false);
    this.#fitted = box ? null : this.view.peek();
  }

  zoomBy(factor: number, at?: Point): void {
    this.navigation.zoomBy(factor, at);
  }

  /** The artboard stays fitted while the window changes, until the user moves the view. */
  #keepFitted() {
    void this.stage.value;
    if (this.#fitted && this.#fitted === this.view.peek()) untracked(() => this.fit());
  }

  #look() {
    const ratio = globalThis.devicePixelRatio || 1;
    const { view, stage, drawing } = this;
    this.engine.look(view.value.zoom * ratio, seenBox(view.value, stage.value), drawing.artboard);
  }

  // Commands and words.

  command(name: string): void {
    if (this.#commands) this.#commands.get(name)?.(this);
    else if (!this.#asked.includes(name)) this.#asked.push(name);
  }

  /** Takes the commands, and runs those that were requested before, in order. */
  learn(commands: CommandTable): void {
    this.#commands = commands;
    for (const name of this.#asked.splice(0)) this.command(name);
  }

  say(text: string, action: Toast["action"] = null): void {
    this.toast.value = { text, action };
    this.announcement.value = text;
  }
}
