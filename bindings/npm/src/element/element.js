// <sfumato-picture src="a.svg" alt="…" interactive><img src="a.png" alt="…"></sfumato-picture>
// docs/npm.md describes the behaviour. Outside a browser the module can be imported and does nothing.
import { View } from "../../../../web/viewer/view.js";
import { Motion } from "../../../../web/viewer/motion.js";
import { Gestures } from "./gestures.js";
import { dress } from "./styles.js";

/** @import { Picture } from "../../../../web/viewer/payload.js" */
/** @import { SharedPicture } from "./pictures.js" */

/** @type {import("./solver.js").Addresses} */
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

const sight = isBrowser && typeof IntersectionObserver !== "undefined"
  ? new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        /** @type {SfumatoPicture} */ (target).see(isIntersecting);
      }
    }, { rootMargin: "50%" })
  : null;

const isApple = () => /Mac|iP(hone|ad|od)/.test(navigator.platform);

export class SfumatoPicture extends Base {
  static observedAttributes = ["src", "max-error", "alt", "interactive", "mesh", "background"];

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

  #root = this.attachShadow({ mode: "open" });
  #canvas = document.createElement("canvas");
  #slot = document.createElement("slot");
  #hint = document.createElement("p");
  /** @type {SharedPicture | null} */
  #shared = null;
  /** @type {Picture | null} */
  #picture = null;
  #view = new View([0, 0, 1, 1], () => false);
  #motion = new Motion(this.#view);
  /** @type {Gestures | null} */
  #gestures = null;
  #isFitted = true;
  #isSeen = false;
  #isDirty = true;
  #isFine = false;
  #hasPixels = false;
  #failure = false;
  #isLoading = false;
  /** Number of the current attempt to load; older attempts are ignored. */
  #attempt = 0;
  #named = { role: "", label: "", tab: false };
  #hintTimer = 0;
  #sizes = new ResizeObserver(() => this.#resize());
  #print = () => this.#layOnPaper();
  #printed = () => this.#root.getElementById("paper")?.remove();
  /** @type {() => void} */
  #resolve = () => {};
  /** @type {(error: unknown) => void} */
  #reject = () => {};
  #ready = this.#promise();
  #client = this.#asClient();

  constructor() {
    super();
    dress(this.#root);
    this.#canvas.setAttribute("part", "canvas");
    this.#canvas.hidden = true;
    this.#hint.id = "hint";
    this.#hint.setAttribute("part", "hint");
    this.#hint.setAttribute("aria-hidden", "true");
    this.#root.append(this.#canvas, this.#slot, this.#hint);
    this.#slot.addEventListener("slotchange", () => this.#name());
    this.addEventListener("keydown", (event) => {
      if (event.target === this) this.#gestures?.key(event);
    });
  }

  /** Resolves when the first frame is shown; rejects if none can be shown. @returns {Promise<void>} */
  get ready() {
    return this.#ready;
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
    return this.hasAttribute("interactive");
  }
  set interactive(is) {
    this.toggleAttribute("interactive", Boolean(is));
  }

  get mesh() {
    return this.hasAttribute("mesh");
  }
  set mesh(is) {
    this.toggleAttribute("mesh", Boolean(is));
  }

  /** The artboard point in the middle, and CSS pixels per user unit; null before the first frame. */
  get view() {
    return this.#picture && { ...this.#view.state };
  }
  set view(state) {
    if (!this.#picture || !state) return;
    this.#isFitted = false;
    this.#motion.go({ ...this.#view.state, ...state }, false);
    this.#change();
  }

  /** Shows the whole page. */
  fit() {
    this.#fit(false);
  }

  connectedCallback() {
    this.#name();
    this.#sizes.observe(this);
    window.addEventListener("beforeprint", this.#print);
    window.addEventListener("afterprint", this.#printed);
    sight?.observe(this);
    if (!sight || this.getAttribute("loading") === "eager") this.see(true);
  }

  disconnectedCallback() {
    sight?.unobserve(this);
    this.#sizes.disconnect();
    window.removeEventListener("beforeprint", this.#print);
    window.removeEventListener("afterprint", this.#printed);
    clearTimeout(this.#hintTimer);
    this.#isSeen = false;
    this.#forget();
  }

  /**
   * @param {string} name
   * @param {string | null} before
   * @param {string | null} now
   */
  attributeChangedCallback(name, before, now) {
    if (before === now) return;
    if (name === "src" || name === "max-error") this.#reload();
    else if (name === "mesh" || name === "background") this.#change();
    else this.#name();
    if (name === "interactive") this.#listen();
  }

  /** For this module: records whether the element is on the screen or near it. @param {boolean} is */
  see(is) {
    this.#isSeen = is;
    if (is) {
      hidden.delete(this);
      this.#load();
      if (this.#picture && (this.#isDirty || !this.#isFine)) drawing?.ask(this.#client);
      return;
    }
    drawing?.unask(this.#client);
    if (!this.#hasPixels) return;
    hidden.add(this);
    for (const oldest of hidden) {
      if (hidden.size <= MOST_HIDDEN) break;
      hidden.delete(oldest);
      oldest.#dropPixels();
    }
  }

  /** @returns {Promise<void>} */
  #promise() {
    const ready = new Promise((/** @type {(value: void) => void} */ resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    // Callers may ignore the promise, because errors are also reported by the event.
    ready.catch(() => {});
    return ready;
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

  #reload() {
    this.#forget();
    this.#failure = false;
    this.#isFitted = true;
    this.#ready = this.#promise();
    if (this.#isSeen) this.#load();
  }

  #forget() {
    this.#attempt += 1;
    this.#isLoading = false;
    drawing?.leave(this.#client);
    hidden.delete(this);
    this.#shared?.release();
    this.#shared = null;
    this.#picture = null;
    this.#dropPixels();
    this.#listen();
  }

  async #load() {
    if (this.#isLoading || this.#failure || !this.src || !this.isConnected) return;
    this.#isLoading = true;
    const attempt = ++this.#attempt;
    try {
      const address = new URL(this.src, document.baseURI).href;
      const { prepare, SharedPicture } = await loadDrawing();
      if (attempt !== this.#attempt) return;
      this.#shared = new SharedPicture(address, this.getAttribute("max-error"), addresses);
      const picture = await this.#shared.picture;
      if (attempt !== this.#attempt) return;
      await prepare(picture);
      if (attempt === this.#attempt) this.#open(picture);
    } catch (error) {
      if (attempt === this.#attempt) this.#fail(error);
    }
  }

  /** @param {Picture} picture */
  #open(picture) {
    this.#picture = picture;
    this.#view = new View(picture.viewport, () => false);
    this.#motion = new Motion(this.#view);
    drawing?.clients.add(this.#client);
    this.#resize();
    this.#listen();
  }

  #listen() {
    this.#gestures?.free();
    this.#gestures = null;
    if (!this.interactive || !this.#picture) return;
    this.#gestures = new Gestures(this, this.#motion, {
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

  /** @param {boolean} smooth */
  #fit(smooth) {
    this.#motion.go(this.#view.fitted(), smooth);
    this.#isFitted = true;
    this.#change();
  }

  #resize() {
    const view = this.#view;
    view.width = Math.max(1, this.clientWidth);
    view.height = Math.max(1, this.clientHeight);
    view.ratio = window.devicePixelRatio || 1;
    if (this.#isFitted) this.#motion.go(view.fitted(), false);
    this.#change();
  }

  #change() {
    this.#isDirty = true;
    this.#isFine = false;
    if (this.#picture && this.#isSeen) drawing?.ask(this.#client);
  }

  /** @returns {import("../../../../web/viewer/renderer.js").Frame} */
  #frame() {
    const view = this.#view;
    const most = drawing?.largestSide() ?? 1;
    const shrink = Math.min(1, most / (view.ratio * Math.max(view.width, view.height)));
    view.ratio *= shrink;
    const size = [view.width, view.height].map((length) => Math.max(1, Math.round(length * view.ratio)));
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
    this.#resolve();
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

  /** @param {unknown} error */
  #fail(error) {
    this.#failure = true;
    this.#forget();
    this.#reject(error);
    const message = error instanceof Error ? error.message : String(error);
    this.dispatchEvent(new ErrorEvent("error", { message, error }));
  }

  /** Sets a name and a role where the page gives none. An author's value replaces one that was set here. */
  #name() {
    if (!this.isConnected) return;
    const image = this.querySelector("img");
    const label = this.getAttribute("alt") ?? image?.alt ?? "";
    const role = this.interactive ? "application" : label || !this.hasAttribute("alt") ? "img" : "presentation";
    const set = (/** @type {string} */ name, /** @type {string} */ before, /** @type {string} */ now) => {
      const given = this.getAttribute(name);
      if (given !== null && given !== before) return;
      if (now) this.setAttribute(name, now);
      else this.removeAttribute(name);
    };
    set("role", this.#named.role, role);
    set("aria-label", this.#named.label, label);
    const hasTab = this.hasAttribute("tabindex");
    if (this.interactive && !hasTab) this.tabIndex = 0;
    if (!this.interactive && hasTab && this.#named.tab) this.removeAttribute("tabindex");
    this.#named = { role, label, tab: this.interactive && (!hasTab || this.#named.tab) };
  }

  /** @param {string} words */
  #say(words) {
    this.#hint.textContent = words;
    this.#hint.classList.add("shown");
    clearTimeout(this.#hintTimer);
    this.#hintTimer = setTimeout(() => this.#hint.classList.remove("shown"), HINT_TIME);
  }

  /** Prints the whole page, whatever part the element shows. */
  #layOnPaper() {
    if (!this.#hasPixels || !this.#picture) return;
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
    this.#printed();
    this.#canvas.before(paper);
    this.#change();
  }
}

if (isBrowser && !customElements.get("sfumato-picture")) customElements.define("sfumato-picture", SfumatoPicture);
