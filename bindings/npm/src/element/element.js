// <sfumato-picture src="a.svg" alt="…" interactive><img src="a.png" alt="…"></sfumato-picture>
// docs/npm.md describes the behaviour. Outside a browser the module can be imported and does nothing.
import { View } from "../../../../web/viewer/view.js";
import { Motion } from "../../../../web/viewer/motion.js";
import { SfumatoError, Status } from "../../../../web/wasm/error.mjs";
import { Access } from "./access.js";
import { Gestures } from "./gestures.js";
import { Load, refused } from "./load.js";
import { hasLayout, hasSight, observe, unobserve } from "./screen.js";
import { dress } from "./styles.js";

/** @import { Picture } from "../../../../web/viewer/payload.js" */
/** @import { ViewState } from "../../../../web/viewer/view.js" */

export { SfumatoError, Status };

/** @type {import("./start-worker.js").Addresses} */
const addresses = { worker: null, wasm: null };

/** The drawing code; null until it is needed. @type {typeof import("./drawing.js") | null} */
let drawing = null;

async function loadDrawing() {
  // Bundlers split the code here.
  drawing ??= await import("./drawing.js");
  return drawing;
}

const isBrowser = typeof HTMLElement !== "undefined" && typeof customElements !== "undefined";
const Base = /** @type {typeof HTMLElement} */ (isBrowser ? HTMLElement : class {});

/** How long a hint is shown, milliseconds. */
const HINT_TIME = 1200;
/** For print: pixels per CSS pixel (1/96 of an inch), and the limit for the longer side. */
const PAPER_RATIO = 4;
const PAPER_SIDE = 2400;
/** Number of elements out of sight that keep their pixels. */
const MOST_HIDDEN = 8;

/** Elements out of sight that have pixels, the one seen last at the end. @type {Set<SfumatoPicture>} */
const hidden = new Set();

/** The attributes that decide what is loaded. */
const sources = ["src", "max-error", "max-time", "import"];

const isApple = () => /Mac|iP(hone|ad|od)/.test(navigator.platform);

class SfumatoPicture extends Base {
  static observedAttributes = [...sources, "alt", "aria-label", "interactive", "mesh", "background"];

  /** The texts of hints; a page in another language sets its own. */
  static words = {
    wheel: () => `${isApple() ? "⌘" : "Ctrl"} + wheel zooms`,
    touch: () => "Two fingers move and zoom",
  };

  /** Address of worker.js, if it is not beside this script. */
  static get workerUrl() {
    return addresses.worker;
  }
  static set workerUrl(address) {
    addresses.worker = address;
  }

  /** Address of sfumato-solver.wasm, if it is not beside worker.js. */
  static get wasmUrl() {
    return addresses.wasm;
  }
  static set wasmUrl(address) {
    addresses.wasm = address;
  }

  /** Number of frames shown so far. */
  frames = 0;
  /** The content that the reader ignored, one message each. @type {readonly string[]} */
  warnings = [];

  #root = this.attachShadow({ mode: "open", delegatesFocus: true });
  #canvas = document.createElement("canvas");
  #slot = document.createElement("slot");
  #hint = document.createElement("p");
  /** As large as the canvas, also while the canvas is hidden. */
  #box = document.createElement("div");
  /** CSS pixels, and device pixels where the browser tells them. @type {{css: number[], device: number[] | null} | null} */
  #size = null;
  #access = new Access(this);
  /** @type {Load | null} */
  #load = null;
  /** @type {Picture | null} */
  #picture = null;
  #view = new View([0, 0, 1, 1], () => false);
  #motion = new Motion(this.#view);
  /** A view that was set before there was a picture. @type {Partial<ViewState> | null} */
  #wanted = null;
  /** @type {Gestures | null} */
  #gestures = null;
  #isFitted = true;
  #isSeen = false;
  #isDirty = true;
  #isFine = false;
  #hasPixels = false;
  #hintTimer = 0;
  #client = this.#asClient();

  constructor() {
    super();
    dress(this.#root);
    this.#canvas.setAttribute("part", "canvas");
    this.#canvas.hidden = true;
    this.#box.id = "box";
    this.#hint.id = "hint";
    this.#hint.setAttribute("part", "hint");
    this.#hint.setAttribute("aria-hidden", "true");
    this.#root.append(this.#box, this.#canvas, this.#slot, this.#hint);
    this.#slot.addEventListener("slotchange", () => this.#name());
    this.addEventListener("keydown", (event) => {
      if (event.target === this) this.#gestures?.key(event);
    });
  }

  /**
   * Resolves when the first frame is shown, or when the picture is loaded if the element is out of sight. Rejects
   * if there will be no picture.
   * @returns {Promise<void>}
   */
  get ready() {
    if (!this.hasAttribute("src")) return refused(new DOMException("The element has no src.", "EncodingError"));
    this.#load ??= new Load();
    const { ready } = this.#load;
    // As decode() of an image, this loads an element that is in no document.
    if (!this.isConnected) void this.#start();
    return ready;
  }

  get src() {
    return this.getAttribute("src") ?? "";
  }
  set src(address) {
    this.setAttribute("src", address);
  }

  get alt() {
    return this.getAttribute("alt") ?? "";
  }
  set alt(words) {
    this.setAttribute("alt", words);
  }

  get interactive() {
    return this.#is("interactive");
  }
  set interactive(is) {
    this.toggleAttribute("interactive", Boolean(is));
  }

  get mesh() {
    return this.#is("mesh");
  }
  set mesh(is) {
    this.toggleAttribute("mesh", Boolean(is));
  }

  get import() {
    return this.#is("import");
  }
  set import(is) {
    this.toggleAttribute("import", Boolean(is));
  }

  /**
   * The artboard point in the middle, and CSS pixels per user unit; null before the picture is loaded.
   * @returns {Partial<ViewState> | null}
   */
  get view() {
    return this.#picture && { ...this.#view.state };
  }
  set view(state) {
    if (!state) return;
    if (!this.#picture) {
      this.#wanted = { ...this.#wanted, ...state };
      return;
    }
    this.#isFitted = false;
    this.#motion.go({ ...this.#view.state, ...state }, false);
    this.#change();
  }

  /** Shows the whole page. */
  fit() {
    this.#wanted = null;
    this.#fit(false);
  }

  connectedCallback() {
    this.#name();
    observe(this, this.#box);
    if (!this.#load?.isLive) this.#load = this.hasAttribute("src") ? new Load() : null;
    if (this.#isSeen) void this.#start(); // moved: the observer has nothing new to report
    if (this.#picture) {
      drawing?.clients.add(this.#client);
      this.#change();
    }
    if (!hasSight || this.getAttribute("loading") === "eager") this.see(true);
  }

  /** A move in the document removes the element and adds it again, in one step. */
  disconnectedCallback() {
    queueMicrotask(() => {
      if (!this.isConnected) this.#depart();
    });
  }

  /** Browsers with moveBefore() then call neither of the two above. */
  connectedMoveCallback() {}

  /**
   * @param {string} name
   * @param {string | null} before
   * @param {string | null} now
   */
  attributeChangedCallback(name, before, now) {
    const isAgain = name === "src" && this.#load?.state === "failed";
    if (before === now && !isAgain) return;
    if (name === "src") this.#reload();
    else if (sources.includes(name)) this.#load?.state === "waiting" || this.#reload();
    else if (name === "mesh" || name === "background") this.#change();
    else if (name === "interactive") this.#listen();
    else this.#name();
  }

  /** For screen.js: records whether the element is on the screen or near it. @param {boolean} is */
  see(is) {
    this.#isSeen = is;
    if (is) {
      hidden.delete(this);
      void this.#start();
      if (this.#picture && (this.#isDirty || !this.#isFine)) drawing?.ask(this.#client);
      return;
    }
    drawing?.unask(this.#client);
    if (this.#picture) this.#load?.shown();
    if (!this.#hasPixels) return;
    hidden.add(this);
    for (const oldest of hidden) {
      if (hidden.size <= MOST_HIDDEN) break;
      hidden.delete(oldest);
      oldest.#dropPixels();
    }
  }

  /** For screen.js: takes the size that the browser reports, or the pixel ratio. @param {ResizeObserverEntry} [entry] */
  measure(entry) {
    if (entry) {
      const { width, height } = entry.contentRect;
      if (width === 0 || height === 0) return; // it has no box now
      const [device] = entry.devicePixelContentBoxSize ?? [];
      this.#size = { css: [width, height], device: device ? [device.inlineSize, device.blockSize] : null };
    }
    this.#resize();
  }

  /** For paper.js: loads a picture that was never near the screen, because paper shows all. */
  loadForPrint() {
    if (this.#picture) return null;
    const loading = this.#start();
    return this.#load?.state === "loading" ? loading : null;
  }

  /** For paper.js: draws no frames until a promise settles. @param {Promise<unknown>} end */
  pause(end) {
    drawing?.pauseUntil(end);
  }

  /** For paper.js: after printing. */
  printed() {
    this.#root.getElementById("paper")?.remove();
  }

  /** For pictures.js: whether the drawing is wanted soon. */
  get isNear() {
    return this.#isSeen;
  }

  /** Whether a boolean attribute is set. Some frameworks write "false". @param {string} name */
  #is(name) {
    return (this.getAttribute(name) ?? "false") !== "false";
  }

  #name() {
    if (this.isConnected) this.#access.update(this.#gestures?.area ?? null);
  }

  /** Returns the element as the stage sees it. */
  #asClient() {
    const element = this;
    return {
      get picture() {
        return element.#picture;
      },
      get isMoving() {
        return element.#motion.isMoving;
      },
      get isDirty() {
        return element.#isDirty;
      },
      set isDirty(is) {
        element.#isDirty = is;
      },
      get isFine() {
        return element.#isFine;
      },
      frame: () => this.#frame(),
      step: (/** @type {number} */ now) => {
        this.#motion.step(now);
        this.#isDirty = true;
      },
      show: (/** @type {OffscreenCanvas | HTMLCanvasElement} */ drawn, /** @type {boolean} */ isFine) =>
        this.#show(drawn, isFine),
      fail: (/** @type {unknown} */ error) => this.#fail(error),
    };
  }

  /** Ends the present load and starts another one. Called when an attribute that decides what is loaded changes. */
  #reload() {
    this.#load?.end("The element loads another picture.");
    this.#forget();
    this.#isFitted = true;
    this.#load = this.hasAttribute("src") ? new Load() : null;
    if (this.#isSeen) void this.#start();
  }

  /** The element has left the document. As an image does, it keeps a picture that it has loaded. */
  #depart() {
    unobserve(this, this.#box);
    clearTimeout(this.#hintTimer);
    this.#isSeen = false;
    hidden.delete(this);
    drawing?.leave(this.#client);
    this.#dropPixels();
    if (this.#picture) {
      this.#load?.shown();
      this.#load?.release();
    } else if (this.#load?.isLive) {
      this.#load.end("The element was removed from the document.");
    }
  }

  #forget() {
    drawing?.leave(this.#client);
    hidden.delete(this);
    this.#picture = null;
    this.warnings = [];
    this.#dropPixels();
    this.#listen();
  }

  /** Loads the picture, unless that has begun. Resolves at the end, also after a failure. */
  async #start() {
    const load = this.#load;
    if (load?.state === "waiting") {
      load.state = "loading";
      load.work = this.#bring(load);
    }
    await load?.work;
  }

  /** @param {Load} load */
  async #bring(load) {
    try {
      if (!hasLayout) throw new SfumatoError(Status.unavailable, "pictures are drawn in browsers only");
      if (this.src === "") throw new SfumatoError(Status.badUsage, "src is empty");
      const wish = {
        address: new URL(this.src, document.baseURI).href,
        maxError: this.getAttribute("max-error"),
        maxTime: this.getAttribute("max-time"),
        imports: this.import,
      };
      const { prepare, shared } = await loadDrawing();
      if (!load.isLive) return;
      const entry = shared(wish, addresses, this);
      load.release = () => entry.release(this);
      const { picture, warnings } = await entry.shown;
      if (load.isLive) await prepare(picture);
      if (load.isLive) this.#open(load, picture, warnings);
    } catch (error) {
      if (load.isLive) this.#fail(error);
    }
  }

  /**
   * @param {Load} load
   * @param {Picture} picture
   * @param {readonly string[]} warnings
   */
  #open(load, picture, warnings) {
    load.state = "open";
    this.#picture = picture;
    this.warnings = warnings;
    this.#view = new View(picture.viewport, () => false);
    this.#motion = new Motion(this.#view);
    if (this.isConnected) drawing?.clients.add(this.#client);
    else load.release();
    this.#resize();
    if (this.#wanted) this.view = this.#wanted;
    this.#wanted = null;
    this.#listen();
    if (!this.#isSeen) load.shown();
  }

  #listen() {
    this.#gestures?.free();
    this.#gestures = null;
    if (this.interactive && this.#picture) {
      this.#gestures = new Gestures(this.#motion, {
        changed: () => {
          this.#isFitted = false;
          this.#change();
        },
        fit: () => this.#fit(true),
        takesWheel: () => this.getAttribute("wheel") === "zoom",
        hint: (what) => this.#say(SfumatoPicture.words[what]()),
      });
      this.#hint.before(this.#gestures.area);
    }
    this.#name();
  }

  /** @param {boolean} smooth */
  #fit(smooth) {
    this.#motion.go(this.#view.fitted(), smooth);
    this.#isFitted = true;
    this.#change();
  }

  #resize() {
    const view = this.#view;
    const { css: [width, height] } = this.#size ?? { css: [this.clientWidth, this.clientHeight] };
    [view.width, view.height] = [Math.max(1, width), Math.max(1, height)];
    view.ratio = this.#pixels()[0] / view.width;
    if (this.#isFitted) this.#motion.go(view.fitted(), false);
    this.#change();
  }

  /** Returns the width and height in device pixels. */
  #pixels() {
    const { width, height } = this.#view;
    const ratio = this.ownerDocument.defaultView?.devicePixelRatio || 1;
    const computed = [width, height].map((length) => Math.max(1, Math.round(length * ratio)));
    const device = this.#size?.device;
    // The browser's own number is right where a side has a fraction. An emulated ratio does not affect it.
    return device && Math.abs(device[0] - computed[0]) <= 1 && Math.abs(device[1] - computed[1]) <= 1 ? device : computed;
  }

  #change() {
    this.#isDirty = true;
    this.#isFine = false;
    if (this.#picture && this.#isSeen) drawing?.ask(this.#client);
  }

  /** @returns {import("../../../../web/viewer/renderer.js").Frame} */
  #frame() {
    const view = this.#view;
    const pixels = this.#pixels();
    const shrink = Math.min(1, (drawing?.largestSide() ?? 1) / Math.max(...pixels));
    const size = pixels.map((length) => Math.max(1, Math.floor(length * shrink)));
    view.ratio = size[0] / view.width;
    const isClear = this.getAttribute("background") === "none";
    // The area around the page is transparent and shows the background of the element.
    return { size, pixelFromArtboard: view.pixelFromArtboard(size), desk: [0, 0, 0, 0], mesh: this.mesh, lineScale: view.ratio, isClear };
  }

  /**
   * @param {OffscreenCanvas | HTMLCanvasElement} drawn
   * @param {boolean} isFine
   */
  #show(drawn, isFine) {
    this.#isDirty = false;
    this.#isFine = isFine;
    this.#copy(drawn);
    this.#canvas.hidden = false;
    this.#slot.hidden = true;
    this.#hasPixels = true;
    this.frames += 1;
    this.#load?.shown();
    if (isFine && !this.#motion.isMoving) this.dispatchEvent(new Event("settled"));
  }

  /** @param {OffscreenCanvas | HTMLCanvasElement} drawn */
  #copy(drawn) {
    const canvas = this.#canvas;
    if (canvas.width !== drawn.width) canvas.width = drawn.width;
    if (canvas.height !== drawn.height) canvas.height = drawn.height;
    const target = canvas.getContext("2d");
    if (!target) throw new Error("This browser has no memory for a canvas.");
    target.globalCompositeOperation = "copy";
    target.drawImage(drawn, 0, 0);
  }

  #dropPixels() {
    this.#hasPixels = false;
    this.#isDirty = true;
    this.#isFine = false;
    this.#canvas.width = 1;
    this.#canvas.height = 1;
    this.#canvas.hidden = true;
    this.#slot.hidden = false;
  }

  /** @param {unknown} cause */
  #fail(cause) {
    const message = cause instanceof Error ? cause.message : String(cause);
    const error = cause instanceof SfumatoError ? cause : new SfumatoError(Status.unavailable, message, {}, { cause });
    this.#load?.fail(error);
    this.#forget();
    this.dispatchEvent(new ErrorEvent("error", { message: error.message, error }));
  }

  /** @param {string} words */
  #say(words) {
    this.#hint.textContent = words;
    this.#hint.classList.add("shown");
    clearTimeout(this.#hintTimer);
    this.#hintTimer = setTimeout(() => this.#hint.classList.remove("shown"), HINT_TIME);
  }

  /** For paper.js: prints the whole page, whatever part the element shows. */
  print() {
    if (!this.#picture) return;
    const side = Math.min(PAPER_SIDE, PAPER_RATIO * Math.max(this.#view.width, this.#view.height));
    const drawn = drawing?.pageOf(this.#client, side);
    if (!drawn) return;
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [drawn.width, drawn.height];
    copy.getContext("2d")?.drawImage(drawn, 0, 0);
    // An image with a data: address is available at once.
    const paper = document.createElement("img");
    paper.id = "paper";
    paper.alt = "";
    paper.src = copy.toDataURL();
    this.printed();
    this.#canvas.before(paper);
    this.#change();
  }
}

const name = "sfumato-picture";

/** Returns the class of the element that this page has, which is another one if another script defined it before. */
function defined() {
  if (!isBrowser) return SfumatoPicture;
  const other = /** @type {typeof SfumatoPicture | undefined} */ (customElements.get(name));
  if (!other) {
    customElements.define(name, SfumatoPicture);
    return SfumatoPicture;
  }
  if ("workerUrl" in other && "words" in other) return other; // another copy of this package
  console.warn(`<${name}> was defined by another script; the element of the package sfumato is not used.`);
  return SfumatoPicture;
}

const Defined = defined();
export { Defined as SfumatoPicture };
