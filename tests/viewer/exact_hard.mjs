// Exact pixels of drawings that are hard for the walk: it ends, its shares stay small until they are known to be
// quick, and its pixels equal the library's.
import { readFileSync, writeFileSync } from "node:fs";
import { compare, gathered, payloadOf, svg } from "./exact.mjs";
import { check, randomNumbers } from "./harness.mjs";

/** Pixels of the first share in software; one may take 10 ms. */
const FIRST_SHARE = 16;
/** Limit in code values. */
const MOST_MISS = 1;

const MIDDLE = [24.0371, 20.0193];

const layer = (shapes) => svg(`<g sf:diffuse="true">${shapes}</g>`);

/** Returns 400 teeth, 28 long and a hundredth from the next at the foot. */
function comb() {
  const teeth = Array.from({ length: 400 }, (_, i) => {
    const x = 4.0137 + 0.1 * i;
    return `L${x} 34.013 L${x + 0.03} 6.0171 L${x + 0.09} 34.013`;
  });
  const path = `M1 38.013 ${teeth.join(" ")} L47 38.013`;
  return layer(`<path d="${path}" sf:left="#136, #fe8, #264" sf:right="#fff, #f00, #08f"/>`);
}

/** Returns curves of a few hundredths of a unit. */
function dust(count) {
  const random = randomNumbers(5);
  const next = () => random.next().value / (1 << 24);
  const color = () => `#${Math.floor(4096 * next()).toString(16).padStart(3, "0")}`;
  const specks = Array.from({ length: count }, () => {
    const [x, y] = [1 + 46 * next(), 1 + 38 * next()].map((v) => v.toFixed(4));
    const [a, b, c, d] = Array.from({ length: 4 }, () => (0.06 * next() - 0.03).toFixed(4));
    return `<path d="M${x} ${y}q${a} ${b} ${c} ${d}" sf:left="${color()}" sf:right="${color()}"/>`;
  });
  return layer(specks.join("\n"));
}

/**
 * The visible part of a drawing: size in pixels, zoom, and the point in the middle. tolerance: of chords, user
 * units. limit: of steps, if it differs from the page's. least: the number of pixels that must be gathered.
 */
const HARD = [
  { name: "a comb", of: comb, tolerance: 0.0005, size: [24, 20], zoom: 0.5, least: 100 },
  { name: "its teeth", of: comb, tolerance: 0.0005, size: [24, 20], zoom: 90, least: 200 },
  { name: "dust", of: () => dust(2000), tolerance: 0.02, size: [18, 15], zoom: 2, limit: 1 << 17, least: 120 },
  { name: "dust from near", of: () => dust(400), tolerance: 0.02, size: [24, 20], zoom: 7, least: 400 },
];

/** Returns the library's pixels, 16 bits. */
function expectedOf({ command, PNG }, path, { tolerance, size, zoom }) {
  const png = command.file("exact_expected.png");
  const [width, height] = size.map((length) => length / zoom);
  const part = [MIDDLE[0] - width / 2, MIDDLE[1] - height / 2, width, height];
  command.run("render", path, "-o", png, "--method", "pixels", "--depth", 16, "--no-antialias", "--quiet",
    "--tolerance", tolerance, "--viewport", part.join(","), "--width", size[0], "--height", size[1]);
  return PNG.sync.read(readFileSync(png), { skipRescale: true }).data;
}

/** Returns the payload of a page, whose patches are not compared. */
function payloadFor({ command }, path, { tolerance }) {
  const page = command.file("exact_hard.html");
  command.run("render", path, "-o", page, "--quiet", "--tolerance", tolerance,
    "--max-error", "off", "--order", "linear", "--min-angle", 0);
  return payloadOf(page);
}

/** Expects that no share is much larger than an earlier quick one, so that no walk blocks the machine. */
function checkShares(shares) {
  const longest = Math.max(...shares.map(({ milliseconds }) => milliseconds));
  console.log(`# ${shares.length} shares; one took at most ${longest.toFixed(0)} ms`);
  let most = FIRST_SHARE;
  for (const { pixels, aimed } of shares) {
    const words = `a share of ${pixels} pixels of ${aimed}, where ${most} may be asked for`;
    check(pixels <= aimed && aimed <= most, words);
    most = 2 * aimed;
  }
}

async function testHard(tools, hard) {
  const { of, size, zoom, limit, least } = hard;
  const path = tools.command.file("exact_hard.svg");
  writeFileSync(path, of());
  const view = [zoom, 0, 0, zoom, ...size.map((length, i) => length / 2 - zoom * MIDDLE[i])];
  const wish = { size, views: [view], isPaced: true, limit };
  const { pixels, shares, error } = await gathered(tools, payloadFor(tools, path, hard), wish);
  check(error === 0, `GL says ${error}`);
  checkShares(shares);
  const { miss, found } = compare(expectedOf(tools, path, hard), pixels);
  console.log(`# ${found} of ${pixels.length / 4} pixels, at most ${miss.toFixed(4)} off`);
  check(found >= least, `only ${found} pixels were gathered`);
  check(miss <= MOST_MISS, `${miss} code values off`);
}

export async function testExactHard(tap, tools) {
  for (const hard of HARD)
    await tap.test(`exact pixels of a hard drawing: ${hard.name}`, () => testHard(tools, hard));
}
