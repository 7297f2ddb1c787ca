// Draws three pictures from an empty page with a person's means: pointer, pen, keys and panels. The text at the end
// is the text of an example. SFUMATO_WRITE_EXAMPLES=1 writes the examples.
import { readFileSync, writeFileSync } from "node:fs";
import { Artist } from "./artist.mjs";
import { changing, checkAlike } from "./draw.mjs";
import { EditorPage, pathOf } from "./harness.mjs";

/** Draws shapes and curves, each on the layer where an illustrator would draw it. */
class Illustrator extends Artist {
  /** Waits for the change that an action makes. */
  does(what, act) {
    return changing(this.editor, what, act);
  }

  newLayer() {
    return this.does("a new layer", async () => {
      await this.deselect();
      await this.page.getByRole("button", { name: "New layer" }).click();
    });
  }

  /** Draws a closed curve with the pen on a layer of its own: a filled shape. */
  async shape(nodes, colors, blur) {
    await this.newLayer();
    await this.curve(nodes, { closes: true });
    await this.paint({ Inside: colors });
    if (blur) await this.blur(blur);
  }

  /** Draws an ellipse or a polygon in a box [left, top, right, bottom]. */
  async drawn(tool, [left, top, right, bottom]) {
    await this.deselect();
    await this.tool(tool);
    await this.does(tool, () => this.editor.drag([[left, top], [right, bottom]]));
  }

  /**
   * Gives sides their colours: a colour for the whole side, and [place, colour] of further stops. At place 1, the
   * curve's end, the first stop is repeated.
   */
  async paint(sides) {
    for (const [side, [whole]] of Object.entries(sides)) {
      const noun = { Left: "left side", Right: "right side", Inside: "inside", Outside: "outside" }[side];
      await this.does(noun, () => this.field(`Colour of the whole ${noun}, hex`, whole));
    }
    for (const [side, [, ...stops]] of Object.entries(sides)) {
      for (const [place, hex] of stops) {
        await this.does(`a stop at ${place}`, () =>
          place === 1 ? this.copyStop(side, 0, 1) : this.addStop(side, place, hex));
      }
    }
  }

  /** Combines the curves of the topmost layers by a key. */
  async combine(count, keys) {
    for (let k = 0; k < count; k += 1) {
      await this.layers.nth(k).click({ modifiers: k > 0 ? ["Control"] : [] });
    }
    await this.press(keys);
  }

  /** Gives the sides of an open curve a blur each. */
  async blurs(left, right) {
    await this.blur(left);
    await this.page.getByRole("button", { name: "Same on both sides" }).click();
    await this.page.getByRole("button", { name: /^Right, radius/ }).click();
    await this.does("a blur", () => this.field("Blur, Right, radius of point 1", right));
  }

  /** Gives a side a linear gradient between two points, with a colour at each end. */
  async gradient(side, colors, from, to) {
    const { page, editor } = this;
    await page.getByRole("button", { name: `Type of the ${side.toLowerCase()}` }).click();
    await this.does("a gradient", () => page.getByRole("menuitem", { name: "Linear gradient" }).click());
    for (const [k, hex] of colors.entries()) await this.does(`colour ${k}`, () => this.color(side, k, hex));
    await this.tool("Nodes");
    for (const [end, at] of [["Start", from], ["End", to]]) {
      const grip = await this.handle(`${end} of the gradient, ${side.toLowerCase()}`);
      await this.does(`its ${end}`, async () => this.sweep(grip, await editor.at(...at)));
    }
  }

  get options() {
    return this.page.getByRole("group", { name: "Tool options" });
  }

  /** Names of the layers in the panel, the topmost first. */
  get layers() {
    return this.page.getByRole("treeitem").locator(".name").filter({ hasText: /^Layer/i });
  }

  chooseLayer() {
    return this.layers.first().click();
  }

  async layerBlend(mode) {
    await this.chooseLayer();
    await this.does("a blend mode", () => this.blend(mode));
  }

  /** Presses a key on the stage. */
  async press(key) {
    await this.page.locator(".canvas-stage").focus();
    await this.does(key, () => this.editor.key(key));
  }

  /** Types where the selection is, and how large. */
  async place(fields) {
    for (const [name, value] of Object.entries(fields)) await this.does(name, () => this.field(name, value));
  }

  /** Adds points to the profile of a curve's blur, [place, radius]. */
  async profile(points) {
    const profile = this.page.locator(".profile-box").first();
    for (const [place, radius] of points) {
      await this.does("a point", async () => {
        const { x, y, width, height } = await profile.boundingBox();
        await this.page.mouse.click(x + width * place, y + height / 2);
      });
      await this.does("its radius", () => this.type(this.page.getByLabel(/^Blur, radius of point/), radius));
    }
  }

  /** Makes a curve soft. */
  blur(radius) {
    return this.does("a blur", () => this.field("Blur, radius of point 1", radius));
  }
}

/** Draws the sky: its clouds are lit from below, and between them both sides have the colour of the sky. */
async function sky(artist) {
  await artist.curve([[-150, -40], [1110, -40]]);
  await artist.paint({ Right: ["161b4a"] });
  await artist.curve([[-150, 400], [1110, 400]]);
  await artist.paint({ Left: ["d8718a", [1], [0.61, "ffd68a"]] });
  await artist.curve([[-150, 186, 0, 190], [330, 150, 480, 150], [760, 186, 880, 180], [1110, 150]]);
  await artist.paint({
    Left: ["4b3c86", [1], [0.58, "6a4a8f"]],
    Right: ["8f4f92", [1], [0.58, "c8688c"]],
  });
  await artist.blur(70);
  await artist.curve([[-150, 262, -60, 270], [150, 238, 240, 246], [460, 264, 540, 256], [760, 216, 840, 224],
    [1110, 236]]);
  await artist.paint({
    Left: ["a9568a", [1], [0.24, "6f4486"], [0.53, "b2608c"], [0.75, "54387e"]],
    Right: ["c46a86", [1], [0.24, "f8a184"], [0.53, "b2608c"], [0.75, "ee868a"]],
  });
  await artist.blurs(36, 7);
  await artist.curve([[-150, 330, 0, 322], [260, 326, 360, 316], [540, 302, 620, 310], [800, 330, 900, 322],
    [1110, 296]]);
  await artist.paint({
    Left: ["da8086", [1], [0.3, "dc8486"], [0.52, "c0657f"], [0.72, "dc8486"]],
    Right: ["e08c86", [1], [0.3, "e08c86"], [0.52, "ffd890"], [0.72, "e59488"]],
  });
  await artist.blurs(30, 5);
}

async function sun(artist) {
  await artist.deselect();
  await artist.stroke([[620, 372, 1], [626, 372, 1]], { radius: 260, color: "ffcf7a" });
  await artist.blend("Screen");
  await artist.drawn("Ellipse", [578, 324, 662, 408]);
  await artist.paint({ Inside: ["fff4d2"] });
  await artist.blur(3);
}

/** Draws hills: ridges whose colours run from shade to light and back, and mist at their feet. */
async function hills(artist) {
  await artist.shape([[-60, 372, 0, 360], [150, 338, 220, 342], [380, 392, 450, 392], [580, 372, 640, 380],
    [800, 330, 860, 336], [1020, 372], [1020, 470], [-60, 470]],
  ["9a5580", [0.14, "ad5d88"], [0.26, "f0967a"], [0.29, "fba97a"], [0.38, "b4648a"], [0.45, "9c5a88"],
    [0.51, "e39690"], [0.68, "ffc28e"], [0.82, "eda38e"], [0.95, "d18a92"]], 2.5);
  await artist.shape([[-60, 424, 40, 426], [250, 404, 340, 396], [500, 448, 600, 446], [760, 408, 830, 400],
    [1020, 440], [1020, 540], [-60, 540]],
  ["693f78", [0.15, "744480"], [0.26, "b45f7c"], [0.3, "b25c7c"], [0.4, "6a427d"], [0.45, "5f3d76"],
    [0.51, "b9748a"], [0.68, "e49a8e"], [0.82, "c9828e"], [0.95, "a4698a"]], 2);
  await artist.shape([[-60, 470, 60, 462], [330, 476, 430, 492], [640, 500, 740, 484], [900, 452, 950, 450],
    [1020, 456], [1020, 600], [-60, 600]],
  ["3b2a60", [0.14, "432f6a"], [0.26, "733e6e"], [0.3, "62386a"], [0.4, "3b2a60"], [0.44, "35265a"],
    [0.51, "6d4274"], [0.68, "9a5a7e"], [0.82, "7d4a78"], [0.95, "5d3a6c"]], 1.5);
}

/** Draws a tree: the crown is united from ellipses. */
async function tree(artist) {
  await artist.shape([[196, 520], [222, 462, 228, 432], [222, 364, 216, 340], [190, 296], [206, 292],
    [230, 336, 236, 346], [242, 330, 248, 316], [262, 284], [276, 288], [252, 350, 250, 366],
    [244, 436, 246, 460], [268, 520]],
  ["241a44", [0.45, "1c1538"], [0.65, "6a3a58"], [0.85, "4a2a50"]], 0.6);
  for (const [x, y, rx, ry] of [[236, 288, 90, 14], [150, 286, 58, 17], [206, 262, 74, 30], [282, 258, 70, 28],
    [330, 280, 52, 16], [240, 236, 66, 26]]) {
    await artist.drawn("Ellipse", [x - rx, y - ry, x + rx, y + ry]);
  }
  await artist.combine(6, "Alt+Shift+U");
  await artist.press("Shift+L");
  await artist.paint({ Inside: ["1a1338"] });
  await artist.blur(0.8);
}

/** Draws a fir of three triangles, and three linked copies of it. */
async function firs(artist) {
  await artist.tool("Polygon");
  await artist.type(artist.options.getByLabel("Sides"), 3);
  for (const [half, top, bottom] of [[23, 460, 504], [33, 482, 532], [42, 510, 566]]) {
    await artist.drawn("Polygon", [760 - half, top, 760 + half, bottom]);
  }
  await artist.combine(3, "Alt+Shift+U");
  await artist.paint({ Inside: ["130f2c"] });
  await artist.blur(0.6);
  await artist.chooseLayer();
  const copies = [["Control+Alt+D", 812, 478, 80], ["Control+D", 690, 500, 66], ["Control+D", 868, 502, 52]];
  for (const [key, left, top, height] of copies) {
    await artist.press(key);
    await artist.place({ "Left edge": left, "Top edge": top, Width: (84 * height) / 106, Height: height });
  }
}

async function birds(artist) {
  const bird = async (x, y, size) => {
    const wings = [[-34, 5, 0.1], [-20, -5, 0.6], [-8, -4, 0.8], [0, 4, 1], [8, -5, 0.8], [20, -8, 0.6], [34, 2, 0.1]];
    await artist.deselect();
    await artist.stroke(wings.map(([dx, dy, force]) => [x + size * dx, y + size * dy, force]),
      { radius: 3.4 * size, smoothing: 0.5, color: "2a1c4c" });
  };
  await bird(440, 152, 1);
  await bird(520, 118, 0.75);
  await bird(556, 166, 0.6);
}

async function dusk(artist) {
  await artist.blank(960, 600, "161b4a");
  await artist.menu("View", "Snap");
  await sky(artist);
  await sun(artist);
  await hills(artist);
  await tree(artist);
  await artist.shape([[-60, 540, 60, 516], [240, 500, 330, 510], [560, 556, 680, 562], [860, 540, 1020, 516],
    [1020, 640], [-60, 640]],
  ["171232", [0.14, "1e1640"], [0.26, "4a2849"], [0.45, "1a1438"], [0.51, "0c0a20"], [0.95, "0c0a20"]], 1);
  await firs(artist);
  await birds(artist);
}

async function room(artist) {
  await artist.curve([[-150, -40], [950, -40]]);
  await artist.paint({ Right: ["c9b8a4", [1], [0.4, "f8eedd"]] });
  await artist.curve([[-150, 640], [950, 640]]);
  await artist.paint({ Left: ["5e3a24", [1], [0.4, "b07a4a"]] });
  await artist.curve([[-150, 372], [950, 372]]);
  await artist.paint({
    Left: ["a9957f", [1], [0.4, "efe0ca"]],
    Right: ["7d5336", [1], [0.4, "d9a873"]],
  });
  await artist.blur(3);
}

/** Draws the shadow on the table, and a darker one where the apple stands. */
async function shadows(artist) {
  await artist.drawn("Ellipse", [270, 462, 670, 530]);
  await artist.paint({ Inside: ["4a2514"] });
  await artist.blur(34);
  await artist.does("its opacity", () => artist.field("Opacity, inside", 80));
  await artist.layerBlend("Multiply");
  await artist.drawn("Ellipse", [307, 496, 517, 520]);
  await artist.paint({ Inside: ["2a0f08"] });
  await artist.blur(12);
  await artist.layerBlend("Multiply");
}

/** Draws the apple: its outline with light from around it, the turn of its body, and the dimple. */
async function body(artist) {
  await artist.shape([[404, 214, 430, 214], [486, 178, 528, 176], [580, 318, 580, 398], [480, 508, 452, 512],
    [402, 500, 390, 500], [326, 508, 296, 502], [228, 318, 228, 238], [322, 178, 364, 176]],
  ["8a0f1a", [0.08, "e04a36"], [0.24, "b01f2a"], [0.33, "c23a3c"], [0.42, "8c1622"], [0.51, "c8502e"],
    [0.58, "9c1822"], [0.7, "c0222a"], [0.84, "f0603c"], [0.92, "f47a4c"]], 0.8);
  await artist.curve([[346, 272, 372, 260], [436, 274, 474, 286], [530, 344, 522, 392], [470, 466, 440, 482],
    [330, 440, 300, 410], [276, 316, 284, 284]], { closes: true });
  await artist.paint({
    Inside: ["f4643e", [0.18, "d02a2a"], [0.36, "7c0a1a"], [0.52, "6c0716"], [0.68, "a81420"], [0.86, "f4552f"]],
    Outside: ["f0583a", [0.18, "c82a2c"], [0.36, "8c1020"], [0.52, "7c0c1c"], [0.68, "a81822"], [0.86, "e84a30"]],
  });
  await artist.blur(16);
  await artist.curve([[346, 200, 356, 224], [404, 246, 432, 246], [462, 200, 470, 186]]);
  await artist.paint({
    Left: ["ea6442", [1], [0.48, "6a0a12"]],
    Right: ["ea6442", [1], [0.48, "e0503a"]],
  });
  await artist.blur(8);
}

async function apple(artist) {
  await artist.blank(800, 600, "efe4d2");
  await artist.menu("View", "Snap");
  await room(artist);
  await shadows(artist);
  await body(artist);
  await artist.shape([[286, 330, 276, 300], [306, 252, 318, 240], [334, 250, 330, 262], [312, 300, 306, 326]],
    ["fff7ee", [0.3, "ffffff"], [0.6, "ffe0cc"]], 3);
  await artist.shape([[398, 238, 400, 220], [412, 160, 420, 142], [438, 146, 436, 152], [414, 220, 412, 240]],
    ["3a2312", [0.3, "6b4522"], [0.42, "a47a45"], [0.55, "8a5f33"], [0.8, "2c180c"]], 0.8);
  await artist.shape([[416, 196, 430, 150], [520, 110, 560, 108], [600, 116], [560, 166, 540, 190],
    [456, 210, 436, 208]],
    ["4c8a2e", [0.2, "8cc63f"], [0.4, "b8dc5a"], [0.55, "6aa53a"], [0.8, "2f6b25"]], 0.6);
  await artist.curve([[416, 196, 450, 184], [520, 146, 552, 133], [600, 116]]);
  await artist.paint({ Left: ["a8d656"], Right: ["2d6a22"] });
  await artist.blur(2);
}

/** Draws a crescent from two circles, its inner edge like smoke, and a flame where two other circles meet. */
async function logo(artist) {
  await artist.blank(640, 640, null);
  await artist.menu("View", "Snap");
  await artist.drawn("Ellipse", [70, 100, 570, 600]);
  await artist.drawn("Ellipse", [158, 72, 586, 500]);
  await artist.combine(2, "Alt+Shift+S");
  await artist.gradient("Inside", ["3a1c9c", "ff6a4a"], [110, 480], [520, 240]);
  await artist.does("a stop", () => artist.addStop("Inside", 0.45, "a02a9c"));
  await artist.profile([[0.79, 46], [0.58, 0], [0.99, 0]]);
  await artist.drawn("Ellipse", [60, 100, 440, 480]);
  await artist.drawn("Ellipse", [320, 100, 700, 480]);
  await artist.combine(2, "Alt+Shift+I");
  await artist.paint({ Inside: ["ff8f3a", [0.25, "ff2f74"], [0.5, "ff6a48"], [0.75, "ffe27a"]] });
  await artist.drawn("Ellipse", [356, 292, 404, 396]);
  await artist.paint({ Inside: ["fff3c4"] });
  await artist.blur(22);
}

const pictures = [
  { name: "dusk.svg", draw: dusk, text: "examples/dusk.svg" },
  { name: "red_apple.svg", draw: apple, text: "examples/red_apple.svg" },
  { name: "logo.svg", draw: logo, text: "examples/logo.svg" },
];

async function testPicture({ browser, address }, { draw, text }) {
  const editor = await EditorPage.open(browser, address);
  try {
    await draw(new Illustrator(editor));
    await editor.settled();
    const drawn = await editor.text;
    if (process.env.SFUMATO_WRITE_EXAMPLES) writeFileSync(pathOf(text), drawn);
    checkAlike(drawn, readFileSync(pathOf(text), "utf8"), "what was drawn");
    editor.checkQuiet();
  } finally {
    await editor.close();
  }
}

export async function testPictures(tap, given) {
  for (const picture of pictures) {
    await tap.test(`a picture is drawn: ${picture.name}`, () => testPicture(given, picture));
  }
}
