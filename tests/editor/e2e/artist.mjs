// User actions in the editor: pointer, a tablet's pen, keys and panels.

/** Returns points in between, as a hand would make them (Catmull and Rom); [x, y, pressure]. */
function dense(points, count = 5) {
  const mix = (a, b, c, d, t) =>
    b + (t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))) / 2;
  const between = points.slice(1).flatMap((to, k) => {
    const row = [points[k - 1] ?? points[k], points[k], to, points[k + 2] ?? to];
    return Array.from({ length: count }, (_, i) =>
      [0, 1, 2].map((axis) => mix(...row.map((point) => point[axis]), (i + 1) / count)),
    );
  });
  const pressed = ([x, y, force]) => [x, y, Math.min(Math.max(force, 0.02), 1)];
  return [points[0], ...between].map(pressed);
}

/** Returns points in between on straight lines. */
function straight(points, count = 3) {
  const between = (a, b) =>
    Array.from({ length: count }, (_, i) =>
      a.map((from, axis) => from + ((b[axis] - from) * (i + 1)) / count),
    );
  return [points[0], ...points.slice(1).flatMap((to, k) => between(points[k], to))];
}

/** Uses the editor as a person does, so its undo steps are a person's. */
export class Artist {
  constructor(editor) {
    this.editor = editor;
    this.page = editor.page;
    /** The tablet's pen, after its first use. */
    this.pen = null;
  }

  tool(name) {
    return this.page.getByRole("radio", { name, exact: true }).click();
  }

  /** Deselects, so that the next action concerns no existing object. */
  async deselect() {
    await this.tool("Select");
    await this.editor.key("Control+Shift+A");
  }

  /** Begins a drawing. background: a colour; null: transparent. */
  async blank(width, height, background) {
    const { page } = this;
    await this.editor.key("Control+Alt+N");
    const dialog = page.getByRole("dialog");
    await this.type(dialog.getByLabel("Width", { exact: true }), width);
    await this.type(dialog.getByLabel("Height", { exact: true }), height);
    if (background === null) await dialog.getByRole("checkbox").uncheck();
    else await this.type(dialog.getByLabel("Background, hex"), background);
    await dialog.getByRole("button", { name: "Create" }).click();
    await this.makeRoom();
  }

  /** Makes room around the artboard, for curves that run beyond it. */
  async makeRoom() {
    await this.editor.key("-");
    await this.editor.settled();
  }

  async menu(...names) {
    await this.page.getByRole("button", { name: "Menu", exact: true }).click();
    for (const name of names) {
      const label = this.page.getByText(name, { exact: true });
      await this.page.locator(".menu-item").filter({ has: label }).last().click();
    }
  }

  /** Clicks on the object at a place. */
  async select(x, y) {
    await this.tool("Select");
    await this.editor.click(x, y);
  }

  async blend(mode) {
    await this.page.getByLabel("Blend mode").click();
    await this.page.locator(".menu-item").filter({ hasText: mode }).click();
  }

  /** Returns a row of the layers. */
  row(name) {
    const label = this.page.getByText(name, { exact: true });
    return this.page.getByRole("treeitem").filter({ has: label });
  }

  choose(name, options) {
    return this.row(name).locator(".name").click(options);
  }

  async type(field, value) {
    await field.fill(String(value));
    await field.press("Enter");
  }

  /** Draws nodes with the pen: [x, y], or [x, y, hx, hy] with the handle ahead pulled to hx, hy. */
  async curve(nodes, { closes = false } = {}) {
    const { editor, page } = this;
    const before = await editor.text;
    await this.tool("Pen");
    for (const [x, y, hx, hy] of closes ? [...nodes, nodes[0]] : nodes) {
      const [at, to] = [await editor.at(x, y), hx === undefined ? null : await editor.at(hx, hy)];
      await page.mouse.move(...at);
      await page.mouse.down();
      if (to) await page.mouse.move(...to, { steps: 3 });
      await page.mouse.up();
    }
    if (!closes) await editor.key("Enter");
    await this.changed(before);
  }

  /** Resolves when the text has changed and its picture is drawn. */
  async changed(before) {
    await this.page.waitForFunction((text) => window.sfumatoEditor.text !== text, before);
    await this.editor.settled();
  }

  /** Draws a stroke with a tablet's pen through points [x, y, pressure], smooth between them. */
  async stroke(points, { radius, smoothing = 1, isStraight = false, color = null }) {
    const { editor, page } = this;
    await this.tool("Stroke");
    const options = page.getByRole("group", { name: "Tool options" });
    await this.type(options.getByLabel("Radius"), radius);
    await this.type(options.getByLabel("Smoothing"), smoothing);
    if (color !== null) await this.type(options.getByLabel("Colour of new strokes, hex"), color);
    this.pen ??= await editor.context.newCDPSession(page);
    // Corners depend on the pen's speed, which a busy machine must not change.
    let timestamp = Date.now() / 1000;
    const send = (type, [x, y, force]) => {
      timestamp += 0.008;
      return this.pen.send("Input.dispatchMouseEvent", {
        ...{ type, x, y, force, pointerType: "pen", button: force > 0 ? "left" : "none" },
        ...{ buttons: force > 0 ? 1 : 0, clickCount: 1, timestamp },
      });
    };
    const way = isStraight ? straight(points) : dense(points);
    const places = (await editor.all(way)).map((place, k) => [...place, way[k][2]]);
    const before = await editor.text;
    // A pen is detected before it touches.
    await send("mouseMoved", [places[0][0], places[0][1], 0]);
    await send("mousePressed", places[0]);
    for (const place of places.slice(1)) await send("mouseMoved", place);
    await send("mouseReleased", places.at(-1));
    await this.changed(before);
  }

  /** Returns the colours of a side in the panel: Left or Right, of a closed curve Inside or Outside. */
  ribbon(side) {
    const name = /^(Left|Right)$/.test(side) ? `${side} side` : side;
    return this.page.getByRole("group", { name }).first();
  }

  stop(side, index) {
    return this.ribbon(side).locator(".stops .stop").nth(index);
  }

  /** Types the colour of a stop into the panel. */
  async color(side, index, hex) {
    await this.stop(side, index).click();
    await this.type(this.page.getByLabel("Colour, hex"), hex);
  }

  /** Picks the colour of a stop with the picker; new strokes have its last chosen colour. */
  async pick(side, index, hex) {
    await this.stop(side, index).dblclick();
    const picker = this.page.getByRole("dialog");
    await this.type(picker.getByRole("textbox").first(), hex);
    await this.editor.key("Escape");
    await picker.waitFor({ state: "detached" });
  }

  async placeOn(side, fraction) {
    const box = await this.ribbon(side).locator(".band").boundingBox();
    return [box.x + box.width * fraction, box.y + box.height / 2];
  }

  async addStop(side, fraction, hex) {
    await this.page.mouse.click(...(await this.placeOn(side, fraction)));
    if (hex) await this.type(this.page.getByLabel("Colour, hex"), hex);
  }

  async copyStop(side, index, fraction) {
    const box = await this.stop(side, index).boundingBox();
    const to = await this.placeOn(side, fraction);
    await this.page.keyboard.down("Alt");
    await this.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await this.page.mouse.down();
    await this.page.mouse.move(to[0], box.y + box.height / 2, { steps: 4 });
    await this.page.mouse.up();
    await this.page.keyboard.up("Alt");
  }

  field(name, value) {
    return this.type(this.page.getByLabel(name, { exact: true }), value);
  }

  async handle(name) {
    const button = this.page.getByRole("button", { name, exact: true });
    const { x, y, width, height } = await button.boundingBox();
    return [x + width / 2, y + height / 2];
  }

  /** Drags a corner of the box, in proportion. */
  async scale(corner, factor) {
    const opposite = { "bottom right": "top left" }[corner];
    const from = await this.handle(`Scale, ${corner}`);
    const fixed = await this.handle(`Scale, ${opposite}`);
    const to = from.map((value, axis) => fixed[axis] + (value - fixed[axis]) * factor);
    await this.sweep(from, to, "Shift");
  }

  /** Drags the selection from a point of the artboard to another. */
  async move(from, to) {
    await this.sweep(await this.editor.at(...from), await this.editor.at(...to));
  }

  /** Moves the pressed mouse between two points of the window while a key is held. */
  async sweep(from, to, key) {
    const { mouse, keyboard } = this.page;
    if (key) await keyboard.down(key);
    await mouse.move(...from);
    await mouse.down();
    await mouse.move(...to, { steps: 5 });
    await mouse.up();
    if (key) await keyboard.up(key);
    await this.editor.settled();
  }
}
