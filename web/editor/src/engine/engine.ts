// The engine on the page's side. The front worker makes frames while something moves, and the exact
// picture if little is left to solve. Otherwise a back worker makes the exact picture, and then
// exchanges roles with the front worker, so that the next movement begins from it. The back worker is
// kept only if it will be needed again: two workers take twice the memory.
import type { ExactLayer } from "../../../viewer/exact_fields.js";
import type { Box } from "../geometry/affine.js";
import { detailFor, type Detail } from "./detail.js";
import { Expected } from "./expected.js";
import { FormerPictures, sameOptions } from "./former.js";
import { hintsOf } from "./hints.js";
import { Pending } from "./pending.js";
import { Rest } from "./rest.js";
import { EngineError } from "./rpc.js";
import { Seat, type Host } from "./seat.js";
import type { LintReport, Solved, SolveOptions, Way } from "./session.js";
import type {
  Engine,
  EngineCurve,
  EngineStatus,
  FileWish,
  GivenImage,
  Hint,
  LayerCurves,
  PictureUpdate,
  QuickChange,
  RasterWish,
  RegionOperation,
  WrittenFile,
} from "./types.js";

/** The time for gathering in a frame, seconds. */
const FRAME_SECONDS = 0.004;
/** How long the view must rest before the chords are refined, milliseconds. */
const VIEW_REST = 400;
/** How long a text rests before a worker solves it, if the page had its exact picture, milliseconds. */
const FORMER_REST = 1500;
/** How long a back worker stays after lint(), because its start takes long, milliseconds. */
const SPARE = 4000;
/** The most consecutive frames that gather waiting nodes. */
const MOST_ROUNDS = 120;
/** The most triangles that the front worker solves exactly: a drag that goes on waits meanwhile. */
const MOST_IN_FRONT = 20_000;
/** The same while a drag pauses. */
const MOST_HELD = 3_000;

/** The text to show. */
interface Wanted {
  readonly text: string;
  readonly moving: boolean;
  readonly serial: number;
}

export class WorkerEngine implements Engine {
  onPicture: (update: PictureUpdate) => void = () => {};
  onStatus: (status: EngineStatus) => void = () => {};

  readonly #host: Host;
  readonly #mostInFront: number;
  #front: Seat;
  #back: Seat | null = null;
  #wanted: Wanted = { text: "", moving: false, serial: -1 };
  /** Changes that bring the front worker's document up to the wanted text. */
  #pending = new Pending();
  /** Stamps of the tables that the page shows, and the serial of their text. */
  #shown: readonly string[] = [];
  #shownStack = "";
  #shownSerial = -1;
  /** Serial of the text and options of the last exact picture that was shown. */
  #exactSerial = -1;
  #exactOptions: SolveOptions | null = null;
  /** Serial of the last text that failed. */
  #badSerial = -1;
  readonly #former = new FormerPictures();
  #detail: Detail | null = null;
  #images: GivenImage[] = [];
  #frames: Promise<void> | null = null;
  #isSettling = false;
  /** Whether the exact picture waits for the frames to end. */
  #isExactReady = false;
  #timer = 0;
  #dismissal = 0;
  /** Solved.unsettled of the last picture. */
  #unsettled = Infinity;
  /** Solved.largest of the last exact picture. */
  #largest = Infinity;
  /** Called for each picture. */
  #onShown: () => void = () => {};
  readonly #rest = new Rest();
  readonly #expected = new Expected(
    () => this.#idleSeat,
    (seat) => this.#lose(seat),
  );
  #seatCount = 0;
  #isFree = false;

  constructor(host: Host, mostInFront = MOST_IN_FRONT) {
    this.#host = host;
    this.#mostInFront = mostInFront;
    this.#front = this.#newSeat();
  }

  get version(): string {
    return this.#front.version;
  }

  get index(): { readonly serial: number; readonly curves: readonly EngineCurve[] } {
    const { readSerial, curves } = this.#front;
    return { serial: readSerial, curves };
  }

  #newSeat(): Seat {
    return new Seat(this.#host, `w${this.#seatCount++}`);
  }

  get images(): readonly GivenImage[] {
    return this.#images;
  }

  /** Adds images that later texts may name. */
  addImages(images: readonly GivenImage[]): void {
    this.#images.push(...images);
  }

  show(text: string, moving: boolean, quick?: readonly QuickChange[]): number {
    this.#pending.add(quick);
    // The number of the expected curve may now belong to another curve.
    if (!quick) this.#expected.set(null);
    this.#wanted = { text, moving, serial: this.#wanted.serial + 1 };
    if (!moving && this.#showFormer()) {
      // Curves may have other numbers in this text.
      if (!quick) this.#idle().catch((error) => this.#complain(error, this.#front, this.#wanted.serial));
      return this.#wanted.serial;
    }
    this.onStatus({ kind: "refining", milliseconds: 0 });
    this.#follow();
    this.#settleAfter(this.#rest.afterChange(moving));
    return this.#wanted.serial;
  }

  /** Shows the exact picture of the wanted text if the page has it. Returns whether it does. */
  #showFormer(): boolean {
    const { text, serial } = this.#wanted;
    const former = this.#former.find(text, this.#options);
    if (!former) return false;
    const { stamps, stackStamp } = former;
    const layers = former.layers.map((one, layer) => ({ ...one, layer })).filter((_, i) => stamps[i] !== this.#shown[i]);
    const stack = stackStamp === this.#shownStack ? null : former.stack;
    // The page shows these tables already, as at the end of a drag: only the workers need the text.
    if (layers.length === 0 && !stack) return false;
    this.#unsettled = layers.reduce((sum, { triangleRows }) => sum + triangleRows, 0);
    this.#shown = stamps;
    this.#shownStack = stackStamp;
    this.#shownSerial = serial;
    this.#former.note({ stack, stamps, layers });
    this.onPicture({ serial, stack, layers, layerCount: stamps.length, isExact: true });
    this.onStatus({ kind: "exact", milliseconds: 0 });
    this.#settleAfter(FORMER_REST);
    return true;
  }

  look(pixelsPerUnit: number, seen: Box, artboard: Box): void {
    const detail = detailFor(pixelsPerUnit, seen, artboard, this.#detail);
    if (detail === this.#detail) return;
    const isFirst = this.#detail === null;
    this.#detail = detail;
    if (!isFirst) this.#settleAfter(VIEW_REST);
  }

  // Frames: one at a time, of the latest text.

  #follow() {
    this.#frames ??= this.#follows().finally(() => {
      this.#frames = null;
      if (this.#isFrameWanted) this.#follow();
    });
  }

  get #isFrameWanted(): boolean {
    const { serial } = this.#wanted;
    return !this.#isFree && this.#shownSerial < serial && this.#badSerial < serial;
  }

  async #follows(): Promise<void> {
    const seat = this.#front;
    let { serial } = this.#wanted;
    try {
      await seat.ready;
      while (seat === this.#front && this.#isFrameWanted) {
        serial = this.#wanted.serial;
        await this.#frame(seat);
      }
    } catch (error) {
      this.#complain(error, seat, serial);
    }
  }

  async #frame(seat: Seat): Promise<void> {
    const wanted = this.#wanted;
    await this.#bring(seat, wanted, this.#pending.take());
    const way: Way = { kind: "quick", seconds: FRAME_SECONDS };
    const options = this.#exactOptions ?? this.#options;
    let solved = await this.#solve(seat, way, options);
    this.#publish(solved, wanted, false);
    // Gathers the waiting nodes while no new text is wanted.
    const isLast = () => this.#wanted === wanted && !this.#isExactReady;
    for (let i = 0; i < MOST_ROUNDS && solved.waiting > 0 && isLast(); ++i) {
      solved = await this.#solve(seat, way, options);
      this.#publish(solved, wanted, false);
    }
  }

  get #options(): SolveOptions {
    return this.#detail?.options ?? {};
  }

  async #bring(seat: Seat, { text, serial }: Wanted, changes: readonly QuickChange[] | null) {
    await seat.bring(text, serial, changes, this.#images);
  }

  async #solve(seat: Seat, way: Way, options: SolveOptions): Promise<Solved> {
    seat.isExact = false;
    seat.expected = null;
    const solved = await seat.link.call<Solved>("solve", {
      way,
      options,
      have: this.#shown,
      haveStack: this.#shownStack,
    });
    seat.isExact = way.kind === "exact";
    return solved;
  }

  #publish(solved: Solved, wanted: Wanted, isExact: boolean) {
    // The page may already show the kept picture of a later text.
    if (wanted.serial < this.#shownSerial) return;
    this.#shown = solved.stamps;
    this.#shownStack = solved.stackStamp;
    this.#shownSerial = wanted.serial;
    this.#unsettled = solved.unsettled;
    this.#onShown();
    const { stack, layers, stamps } = solved;
    this.#former.note(solved);
    this.onPicture({ serial: wanted.serial, stack, layers, layerCount: stamps.length, isExact });
    const kind = isExact ? "exact" : "refining";
    this.onStatus({ kind, milliseconds: solved.milliseconds });
  }

  // Exact pictures: once the text rests.

  #settleAfter(milliseconds: number) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#settle(), milliseconds) as never;
  }

  get #isSettleWanted(): boolean {
    const { serial } = this.#wanted;
    const isExact = this.#exactSerial === serial && sameOptions(this.#exactOptions, this.#options);
    return !this.#isFree && serial >= 0 && this.#badSerial < serial && !isExact;
  }

  async #settle(): Promise<void> {
    if (this.#isSettling || !this.#isSettleWanted) return;
    // A drag that pauses may go on at any time.
    const wait = this.#wouldHoldUp ? this.#rest.left() : 0;
    if (wait > 0) return this.#settleAfter(wait);
    this.#isSettling = true;
    const [seat, options] = [this.#front, this.#options];
    if (await this.#isForFront(seat, options)) await this.#settleInFront(seat, options);
    else await this.#settleInBack();
    this.#isSettling = false;
    if (this.#isSettleWanted) this.#settleAfter(this.#rest.again(this.#wanted.moving));
    else void this.#expected.prepare();
  }

  /** Whether a drag that goes on would wait for the exact picture, because no back worker makes it. */
  get #wouldHoldUp(): boolean {
    return this.#wanted.moving && !this.#isBackNeeded && this.#unsettled > MOST_HELD;
  }

  async #isForFront(seat: Seat, options: SolveOptions): Promise<boolean> {
    if (!sameOptions(seat.exactFor, options)) return false;
    // The drag then goes on in the front worker, where it began.
    if (this.#wanted.moving) return !this.#isBackNeeded;
    return this.#isLittle();
  }

  /** Returns whether little is left to solve exactly, as the first frame of a text reports. */
  async #isLittle(): Promise<boolean> {
    if (this.#frames && this.#shownSerial !== this.#wanted.serial) {
      const shown = new Promise<void>((resolve) => (this.#onShown = resolve));
      await Promise.race([this.#frames, shown]);
    }
    return this.#unsettled <= this.#mostInFront;
  }

  /** Ends the frames. Their waiting nodes stay ungathered: the exact picture follows. */
  async #framesEnd(): Promise<void> {
    this.#isExactReady = true;
    await this.#frames;
    this.#isExactReady = false;
  }

  /** Makes the exact picture in the front worker. Frames wait meanwhile. */
  async #settleInFront(seat: Seat, options: SolveOptions): Promise<void> {
    await this.#framesEnd();
    const wanted = this.#wanted;
    if (seat !== this.#front || this.#frames || this.#shownSerial !== wanted.serial) return;
    this.#frames = this.#settleFront(seat, wanted, options).finally(() => {
      this.#frames = null;
      if (this.#isFrameWanted) this.#follow();
    });
    await this.#frames;
  }

  async #settleFront(seat: Seat, wanted: Wanted, options: SolveOptions): Promise<void> {
    try {
      // The page needs the numbers of the curves in the text that rests.
      if (seat.readSerial !== wanted.serial || seat.isChanged) {
        await seat.bring(wanted.text, wanted.serial, null, this.#images, wanted.moving);
      }
      const solved = await this.#solve(seat, { kind: "exact" }, options);
      if (this.#wanted === wanted) this.#publishExact(solved, wanted, options);
    } catch (error) {
      this.#complain(error, seat, wanted.serial);
    }
  }

  async #settleInBack(): Promise<void> {
    const seat = (this.#back ??= this.#newSeat());
    let { serial } = this.#wanted;
    try {
      await seat.ready;
      serial = this.#wanted.serial;
      await this.#settleIn(seat, this.#wanted, this.#options);
    } catch (error) {
      this.#complain(error, seat, serial);
    }
  }

  async #settleIn(seat: Seat, wanted: Wanted, options: SolveOptions): Promise<void> {
    if (seat.serial !== wanted.serial || seat.isChanged) await this.#bring(seat, wanted, null);
    const before = this.#shown;
    let solved = await this.#solve(seat, { kind: "exact" }, options);
    await this.#framesEnd();
    if (this.#wanted !== wanted) return;
    // If frames have changed the page's tables meanwhile, gets the differences again.
    const { milliseconds } = solved;
    if (this.#shown !== before) {
      solved = { ...(await this.#solve(seat, { kind: "exact" }, options)), milliseconds };
    }
    if (this.#wanted !== wanted) return;
    if (wanted.moving && sameOptions(this.#front.exactFor, options)) {
      seat.exactFor = options;
      this.#publishExact(solved, wanted, options);
    } else {
      this.#exchange(seat, solved, wanted, options);
    }
  }

  #exchange(seat: Seat, solved: Solved, wanted: Wanted, options: SolveOptions) {
    this.#back = this.#front;
    this.#front = seat;
    seat.exactFor = options;
    this.#pending.reset();
    this.#publishExact(solved, wanted, options);
    // An error here recurs in the next call of this worker, which reports it.
    if (this.#isBackNeeded) this.#warm(this.#back, wanted, options).catch(() => {});
    else this.#dismissBack();
  }

  /** Whether an edit of one layer can need the back worker. */
  get #isBackNeeded(): boolean {
    return this.#largest > this.#mostInFront;
  }

  #publishExact(solved: Solved, wanted: Wanted, options: SolveOptions) {
    this.#exactSerial = wanted.serial;
    this.#exactOptions = options;
    this.#largest = solved.largest;
    this.#publish(solved, wanted, true);
    if (this.#shownSerial === wanted.serial) this.#former.keep(wanted.text, options, solved);
  }

  #dismissBack() {
    void this.#back?.link.endWhenIdle();
    this.#back = null;
  }

  #dismissSpare() {
    if (!this.#isSettling && !this.#isBackNeeded) this.#dismissBack();
  }

  /** Makes an exact picture in the back worker. Its next exact pictures then only need to solve edits. */
  async #warm(seat: Seat, wanted: Wanted, options: SolveOptions): Promise<void> {
    await seat.ready;
    if (this.#wanted !== wanted || sameOptions(seat.exactFor, options)) return;
    seat.exactFor = options;
    if (seat.serial !== wanted.serial || seat.isChanged) await this.#bring(seat, wanted, null);
    await this.#solve(seat, { kind: "exact" }, options);
  }

  /** @param serial of the text that failed; newer texts may have followed */
  #complain(error: unknown, seat: Seat, serial: number) {
    if (this.#isFree) return;
    const problem = EngineError.of(error);
    this.#badSerial = Math.max(this.#badSerial, serial);
    this.#pending.lose();
    if (!problem.isOfText) this.#replace(seat);
    if (serial < this.#wanted.serial) return;
    const { reason, line, column } = problem;
    if (seat.isStarted) this.onStatus({ kind: "problem", reason, line, column });
    else this.onStatus({ kind: "failed", reason });
  }

  /** Replaces a worker whose module has run out of memory or has trapped. */
  #replace(seat: Seat) {
    seat.end();
    if (seat === this.#back) this.#back = null;
    else this.#front = this.#newSeat();
  }

  /** Replaces the front worker, unless that was replaced already. */
  #lose(seat: Seat) {
    if (!this.#isFree && seat === this.#front) this.#replace(seat);
  }

  // Preparation of the next drag.

  expect(curves: LayerCurves | null): void {
    this.#expected.set(curves);
  }

  /** The front worker, if it is idle and its picture is exact; otherwise null. */
  get #idleSeat(): Seat | null {
    const seat = this.#front;
    const isBusy = this.#frames !== null || this.#isSettling || this.#isSettleWanted || seat.link.isBusy;
    return isBusy || !seat.isExact ? null : seat;
  }

  // Requests about the text that is shown.

  /** Returns the front worker, once it has the present text. */
  async #idle(): Promise<Seat> {
    await this.#frames;
    const seat = this.#front;
    await seat.ready;
    if (seat.serial !== this.#wanted.serial || seat.isChanged) {
      this.#pending.reset();
      await this.#bring(seat, this.#wanted, null);
    }
    return seat;
  }

  async #ask<Value>(name: string, ...given: unknown[]): Promise<Value> {
    return (await this.#idle()).link.call<Value>(name, ...given);
  }

  colors(layer: number, xy: Float64Array): Promise<Float32Array> {
    return this.#ask("colors", layer, xy);
  }

  raster(wish: RasterWish): Promise<Uint8ClampedArray<ArrayBuffer> | Uint16Array<ArrayBuffer>> {
    return this.#ask("raster", wish);
  }

  async exactLayer(layer: number): Promise<ExactLayer | null | "busy"> {
    const [seat, wanted] = [this.#idleSeat, this.#wanted];
    if (!seat) return "busy";
    try {
      const exact = await seat.link.call<ExactLayer | null>("exactLayer", layer);
      return this.#wanted === wanted && seat === this.#front ? exact : "busy";
    } catch (error) {
      if (!EngineError.of(error).isOfText) this.#lose(seat);
      throw error;
    }
  }

  payload(): Promise<Uint8Array> {
    return this.#ask("payload");
  }

  write(wish: FileWish): Promise<WrittenFile> {
    return this.#ask("write", wish);
  }

  /** Runs in the idle back worker, so that frames do not wait. */
  async lint(): Promise<readonly Hint[] | null> {
    if (this.#isSettling || this.#isSettleWanted || this.#wanted.serial < 0) return null;
    const seat = (this.#back ??= this.#newSeat());
    const wanted = this.#wanted;
    try {
      await seat.ready;
      if (seat.serial !== wanted.serial || seat.isChanged) await this.#bring(seat, wanted, null);
      const report = await seat.link.call<LintReport>("lint");
      return this.#wanted === wanted ? hintsOf(report, seat.curves) : null;
    } finally {
      clearTimeout(this.#dismissal);
      if (!this.#isFree) this.#dismissal = setTimeout(() => this.#dismissSpare(), SPARE) as never;
    }
  }

  async convert(text: string): Promise<string> {
    const seat = this.#front;
    await seat.ready;
    return seat.link.call("convert", text);
  }

  async combinePaths(operation: RegionOperation, paths: readonly string[], tolerance: number): Promise<string> {
    const seat = this.#front;
    await seat.ready;
    return seat.link.call("combinePaths", operation, paths, tolerance);
  }

  free(): void {
    this.#isFree = true;
    clearTimeout(this.#timer);
    clearTimeout(this.#dismissal);
    this.#front.end();
    this.#back?.end();
  }
}
