// What a person does in the editor, in words of the page: pointer, a tablet's pen, keys and panels.

/** Points between points, as a hand would make them (Catmull and Rom); [x, y, pressure]. */
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

/** Points between points on the straight way. */
function straight(points, count = 3) {
  const between = (a, b) =>
    Array.from({ length: count }, (_, i) =>
      a.map((from, axis) => from + ((b[axis] - from) * (i + 1)) / count),
    );
  return [points[0], ...points.slice(1).flatMap((to, k) => between(points[k], to))];
}

/** Uses the editor as a person does: steps of undo are those of the hand. */
export class Artist {
  constructor(editor) {
    this.editor = editor;
    this.page = editor.page;
    /** The tablet's pen, once it was used. */
    this.pen = null;
  }

  tool(name) {
    return this.page.getByRole("radio", { name, exact: true }).click();
  }

  /** What comes next belongs to nothing that is there. */
  async deselect() {
    await this.tool("Select");
    await this.editor.key("Control+Shift+A");
  }

  async blank(width, height, background) {
    const { page } = this;
    await this.editor.key("Control+Alt+N");
    const dialog = page.getByRole("dialog");
    await this.type(dialog.getByLabel("Width", { exact: true }), width);
    await this.type(dialog.getByLabel("Height", { exact: true }), height);
    await this.type(dialog.getByLabel("Background, hex"), background);
    await dialog.getByRole("button", { name: "Make it" }).click();
    await this.makeRoom();
  }

  /** Room around the artboard, for curves that run beyond it. */
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

  /** A click on what lies there. */
  async select(x, y) {
    await this.tool("Select");
    await this.editor.click(x, y);
  }

  async blend(mode) {
    await this.page.getByLabel("Blend mode").click();
    await this.page.locator(".menu-item").filter({ hasText: mode }).click();
  }

  /** A row of the layers. */
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

  /** Nodes with the pen: [x, y], or [x, y, hx, hy] with the handle ahead pulled to hx, hy. */
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

  /** When the text is another one, and its picture is drawn. */
  async changed(before) {
    await this.page.waitForFunction((text) => window.sfumatoEditor.text !== text, before);
    await this.editor.settled();
  }

  /** A stroke of the pen of a tablet through points [x, y, pressure], smooth between them. */
  async stroke(points, { radius, smoothing = 1, isStraight = false }) {
    const { editor, page } = this;
    await this.tool("Stroke");
    const options = page.getByRole("group", { name: "Options of the tool" });
    await this.type(options.getByLabel("Radius"), radius);
    await this.type(options.getByLabel("Smoothing"), smoothing);
    this.pen ??= await editor.context.newCDPSession(page);
    const send = (type, [x, y, force]) =>
      this.pen.send("Input.dispatchMouseEvent", {
        ...{ type, x, y, force, pointerType: "pen", button: force > 0 ? "left" : "none" },
        ...{ buttons: force > 0 ? 1 : 0, clickCount: 1 },
      });
    const way = isStraight ? straight(points) : dense(points);
    const places = (await editor.all(way)).map((place, k) => [...place, way[k][2]]);
    const before = await editor.text;
    // A pen is seen before it touches.
    await send("mouseMoved", [places[0][0], places[0][1], 0]);
    await send("mousePressed", places[0]);
    for (const place of places.slice(1)) await send("mouseMoved", place);
    await send("mouseReleased", places.at(-1));
    await this.changed(before);
  }

  /** The colours of a side in the panel. */
  ribbon(side) {
    return this.page.getByRole("group", { name: `${side} side` }).first();
  }

  /** A colour for a side that is open: the first curve of a layer has none. */
  async giveColor(side) {
    const row = this.page.locator(".side-row", { has: this.page.getByText(side, { exact: true }) });
    await row.getByRole("button", { name: "Give it a colour" }).click();
    await this.ribbon(side).waitFor();
  }

  stop(side, index) {
    return this.ribbon(side).locator(".stops .stop").nth(index);
  }

  /** The colour of a stop, typed in the panel. */
  async color(side, index, hex) {
    await this.stop(side, index).click();
    await this.type(this.page.getByLabel("Colour, hex"), hex);
  }

  /** The colour of a stop, by the picker: new strokes have the last colour that it chose. */
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
    const opposite = { "south-east": "north-west" }[corner];
    const from = await this.handle(`Scale, ${corner}`);
    const fixed = await this.handle(`Scale, ${opposite}`);
    const to = from.map((value, axis) => fixed[axis] + (value - fixed[axis]) * factor);
    await this.sweep(from, to, "Shift");
  }

  /** Drags what is selected from a point of the artboard to another. */
  async move(from, to) {
    await this.sweep(await this.editor.at(...from), await this.editor.at(...to));
  }

  /** The mouse, pressed between two points of the window while a key is held. */
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
