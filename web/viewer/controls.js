// Buttons, words and what else of the page is not the picture.

/**
 * An element of the page, of a class.
 * @template {Element} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
function element(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`The page has no ${id}.`);
  return found;
}

/** Beyond, the zoom is a factor. */
const MOST_PERCENT = 10000;

class Controls {
  constructor() {
    this.canvas = element("canvas", HTMLCanvasElement);
    this.tools = element("tools", HTMLDivElement);
    this.message = element("message", HTMLParagraphElement);
    this.percent = element("percent", HTMLOutputElement);
    this.mesh = element("mesh", HTMLButtonElement);
    this.full = element("full", HTMLButtonElement);
    this.dialog = element("keys-dialog", HTMLDialogElement);
    this.fallback = document.getElementById("fallback");
    this.full.hidden = !document.fullscreenEnabled;
    this.message.hidden = false;
    this.message.textContent = "Unpacking the picture …";
  }

  /** @param {Commands} commands */
  connect(commands) {
    const on = (/** @type {string} */ id, /** @type {() => void} */ act) =>
      element(id, HTMLButtonElement).addEventListener("click", act);
    on("zoom-in", () => commands.zoomMiddle(KEY_ZOOM));
    on("zoom-out", () => commands.zoomMiddle(1 / KEY_ZOOM));
    on("zoom", () => commands.fullSize());
    on("fit", () => commands.fit());
    on("mesh", () => commands.toggleMesh());
    on("full", () => commands.toggleFull());
    on("help", () => commands.showHelp());
    document.addEventListener("fullscreenchange", () => {
      this.full.setAttribute("aria-pressed", String(document.fullscreenElement !== null));
    });
  }

  /** The picture is drawn: the canvas takes the place of what stood there. */
  showCanvas() {
    this.canvas.hidden = false;
    this.tools.hidden = false;
    this.message.hidden = true;
    if (this.fallback) this.fallback.hidden = true;
  }

  /**
   * Says something instead of drawing; the still picture is shown if there is one.
   * @param {string} text
   */
  say(text) {
    this.canvas.hidden = true;
    this.tools.hidden = true;
    this.message.hidden = false;
    this.message.textContent = text;
    this.message.classList.toggle("alone", this.fallback === null);
    if (this.fallback) this.fallback.hidden = false;
  }

  /** @param {number} zoom */
  showZoom(zoom) {
    const percent = 100 * zoom;
    const digits = percent >= 10 ? 0 : 1;
    this.percent.textContent =
      zoom < MOST_PERCENT / 100 ? `${percent.toFixed(digits)} %` : `${zoom.toFixed(0)} ×`;
  }

  /** @param {boolean} isShown */
  showMesh(isShown) {
    this.mesh.setAttribute("aria-pressed", String(isShown));
  }

  toggleFull() {
    // Refused where the page is in a frame that may not; nothing is lost then.
    const ignore = () => {};
    if (document.fullscreenElement) document.exitFullscreen().catch(ignore);
    else document.documentElement.requestFullscreen().catch(ignore);
  }

  /** Red, green and blue of what lies around the page, from 0 to 1. */
  deskColor() {
    const text = getComputedStyle(document.body).backgroundColor;
    return (text.match(/[\d.]+/g) ?? []).slice(0, 3).map((value) => Number(value) / 255);
  }
}
