// Firefox for the tests: on a virtual screen, driven by WebDriver BiDi.
import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { PATIENCE, check, EditorPage, packageOf } from "./harness.mjs";
import { installHooks } from "./hooks.mjs";

const puppeteer = packageOf("puppeteer-core");

const firefox = process.env.FIREFOX ?? "firefox-esr";
const isHere = (command) => spawnSync("which", [command]).status === 0;

/** Returns the commands that Firefox needs and that are missing, in words; "" if there are none. */
export const missing = () => [firefox, "Xvfb"].filter((command) => !isHere(command)).join(" and ");

/** Starts a virtual screen; without one Firefox has no WebGL. */
async function startScreen() {
  const options = ["-displayfd", "3", "-screen", "0", "1280x1000x24", "-nolisten", "tcp"];
  const child = spawn("Xvfb", options, { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  const [number] = await Promise.race([
    once(child.stdio[3], "data"),
    once(child, "exit").then(() => Promise.reject(new Error("Xvfb does not start"))),
  ]);
  const close = () => void child.kill();
  // Also if the tests end by an error.
  process.once("exit", close);
  return { display: `:${String(number).trim()}`, close };
}

/** @returns {browser, close} */
export async function launchFirefox() {
  const screen = await startScreen();
  try {
    const executablePath = String(spawnSync("which", [firefox]).stdout).trim();
    const env = { ...process.env, DISPLAY: screen.display };
    const args = ["--remote-allow-system-access"];
    const browser = await puppeteer.launch({ browser: "firefox", executablePath, headless: false, args, env, timeout: PATIENCE, protocolTimeout: PATIENCE });
    const close = () => browser.close().finally(screen.close);
    return { browser, close };
  } catch (error) {
    screen.close();
    throw error;
  }
}

/**
 * Sends pen events, type, x, y, pressure, to the window with the page. BiDi's own actions do not support pens
 * ("Unimplemented pointerMove for pointerType pen"), so the browser's window receives them like events of the
 * system.
 */
async function penMoments(moments) {
  const PEN = 2;
  const { left, top } = gBrowser.selectedBrowser.getBoundingClientRect();
  for (const [type, x, y, pressure] of moments) {
    const pen = { pointerId: 9, inputSource: PEN, button: 0, buttons: pressure > 0 ? 1 : 0, clickCount: 1, pressure };
    window.synthesizeMouseEvent(type, left + x, top + y, pen, {});
    // Moves in one frame would be merged.
    await new Promise((done) => requestAnimationFrame(done));
  }
}

/** The editor in Firefox. Overrides the functions of EditorPage that call Playwright. */
export class FirefoxPage extends EditorPage {
  static size = [1100, 760];

  /** Opens a page with its own storage. `downloads`: the folder for its saved files. */
  static async open(browser, address, { downloads } = {}) {
    const behavior = downloads ? { downloadBehavior: { policy: "allow", downloadPath: downloads } } : {};
    const context = await browser.createBrowserContext(behavior);
    const editor = new FirefoxPage(await context.newPage());
    editor.context = context;
    const [width, height] = FirefoxPage.size;
    await editor.page.setViewport({ width, height });
    await editor.page.evaluateOnNewDocument(installHooks);
    await editor.go(address);
    return editor;
  }

  /** Waits until a function of the page returns a value, and returns it. */
  async until(what, body, ...given) {
    try {
      return await (await this.page.waitForFunction(body, {}, ...given)).jsonValue();
    } catch (error) {
      throw new Error(`not so: ${what}`, { cause: error });
    }
  }

  /** Does something that changes the text. @returns the new text */
  async changing(what, act) {
    const before = await this.text;
    await act();
    await this.until(`${what} changes the text`, (text) => window.sfumatoEditor.text !== text, before);
    return this.text;
  }

  /** Waits until an element matches a selector. */
  matches(selector) {
    return this.until(selector, (wanted) => document.querySelector(wanted) !== null, selector);
  }

  /** Clicks the first element whose name or text matches, once nothing covers it. */
  async press(pattern, selector = "button") {
    const find = (wanted, source) => {
      for (const element of document.querySelectorAll(wanted)) {
        const name = element.getAttribute("aria-label") ?? element.textContent.trim();
        if (element.disabled || !new RegExp(source).test(name)) continue;
        element.scrollIntoView({ block: "nearest" });
        const { left, top, width, height } = element.getBoundingClientRect();
        const place = [left + width / 2, top + height / 2];
        if (element.contains(document.elementFromPoint(...place))) return place;
      }
      return null;
    };
    const place = await this.until(`${pattern} can be pressed`, find, selector, pattern.source);
    await this.page.mouse.click(...place);
  }

  /** Types into a field of the inspector, by its name. */
  async fill(name, value) {
    await this.press(new RegExp(`^${name}$`), ".inspector input");
    await this.key("Control+a");
    await this.page.keyboard.type(value);
    return this.changing(name, () => this.key("Enter"));
  }

  /** Presses keys such as "Control+Shift+z". */
  async key(...names) {
    const { keyboard } = this.page;
    for (const name of names) {
      const modifiers = name.split("+");
      const last = modifiers.pop();
      for (const modifier of modifiers) await keyboard.down(modifier);
      await keyboard.press(last);
      for (const modifier of modifiers.reverse()) await keyboard.up(modifier);
    }
  }

  /** Draws with a pen through places of the window: x, y, pressure. */
  async pen(places) {
    await this.page.bringToFront();
    const { session } = this.page.mainFrame().browsingContext.userContext.browser;
    const windows = await session.send("browsingContext.getTree", { "moz:scope": "chrome" });
    const { context } = windows.result.contexts.find(({ url }) => url.endsWith("browser.xhtml"));
    const [first, last] = [places[0], places.at(-1)];
    const moments = [["mousemove", ...first.slice(0, 2), 0], ["mousedown", ...first], ...places.map((place) => ["mousemove", ...place]), ["mouseup", ...last.slice(0, 2), 0]];
    const expression = `(${penMoments})(${JSON.stringify(moments)})`;
    const { result } = await session.send("script.evaluate", { expression, target: { context }, awaitPromise: true });
    check(result.type === "success", `the pen: ${result.exceptionDetails?.text}`);
  }

  async pictureOf(selector) {
    const element = await this.page.$(selector);
    check(element, `there is no ${selector}`);
    return element.screenshot();
  }
}
