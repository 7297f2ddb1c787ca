// Names and roles for people who cannot see the picture. Attributes of the page always count before them.

/** The attributes to set in browsers whose ElementInternals has no roles. */
const attributeOf = /** @type {const} */ ({ role: "role", ariaLabel: "aria-label" });

export class Access {
  #host;
  /** @type {ElementInternals | null} */
  #internals;
  /** The attributes that were set here. @type {Map<string, string>} */
  #set = new Map();

  /** @param {HTMLElement} host */
  constructor(host) {
    this.#host = host;
    const internals = host.attachInternals?.();
    // jsdom has a part of the interface, which has no effect, and no `states`.
    this.#internals = internals && "states" in internals ? internals : null;
  }

  /** The picture's description: alt, or the alt of the image inside. */
  get label() {
    return this.#host.getAttribute("alt") ?? this.#host.querySelector("img")?.alt ?? "";
  }

  /**
   * Describes the element. A framework that compares attributes with its own finds no additional ones.
   * @param {HTMLElement | null} control the part that keys and pointers move, if there is one
   */
  update(control) {
    const { label } = this;
    if (control) {
      control.tabIndex = 0;
      control.setAttribute("role", "application");
      control.setAttribute("aria-label", this.#host.getAttribute("aria-label") ?? label);
    }
    const role = label || !this.#host.hasAttribute("alt") ? "img" : "presentation";
    this.#describe("role", control ? "" : role);
    this.#describe("ariaLabel", control ? "" : label);
  }

  /**
   * @param {"role" | "ariaLabel"} what
   * @param {string} words "": nothing
   */
  #describe(what, words) {
    if (this.#internals) {
      this.#internals[what] = words || null;
      return;
    }
    const name = attributeOf[what];
    const present = this.#host.getAttribute(name);
    if (present !== null && present !== this.#set.get(name)) return; // the page's own
    this.#set.set(name, words);
    if (words) this.#host.setAttribute(name, words);
    else this.#host.removeAttribute(name);
  }
}
