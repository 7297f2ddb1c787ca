// PDF in PDFium, and in the viewer of Chromium around it, compared with the rasterizer.
import { PDFiumLibrary } from "@hyzyla/pdfium";
import { readFileSync, writeFileSync } from "node:fs";
import { PNG } from "pngjs";
import { PATIENCE, Skip, check, difference, rangeOf, shortName } from "./harness.mjs";

/**
 * Limits slightly above the measured values, code values: mean and 99th percentile of the page, and the error of
 * the mean colour of the worst square. Rough edges cancel out in a square; a small missing object does not.
 */
const SHOWN = [
  { document: "../shared/scenes/lady_bug.xml", mean: 0.7, percentile: 6, square: 7 },
  { document: "examples/apple.svg", mean: 2, percentile: 16, square: 9 },
  {
    document: "examples/fish.svg",
    // PDFium places images at whole pixels, which is a visible error for a small fish.
    options: ["--pdf-flatten", "never"],
    mean: 2.6,
    percentile: 35,
    square: 11,
  },
  { document: "examples/blur.svg", mean: 1.4, percentile: 14, square: 7 },
  { document: "examples/textures.svg", mean: 7, percentile: 80, square: 10 },
];

const SQUARE = 16;

/** A pixel is far from white if a channel is below this. */
const FAR_FROM_WHITE = 224;

const POINTS_TO_PIXELS = 96 / 72;

/** Returns the first page on white, as the bytes of a PNG. */
async function shownByPdfium(library, path) {
  const document = await library.loadDocument(readFileSync(path));
  try {
    const { width, height, data } = await document.getPage(0).render({ scale: POINTS_TO_PIXELS });
    const image = new PNG({ width, height });
    image.data.set(data);
    return PNG.sync.write(image);
  } finally {
    document.destroy();
  }
}

/** Returns the mean of the signed differences of a square's pixels, the largest of the channels. */
function squareMiss(shown, expected, left, top) {
  const sums = [0, 0, 0];
  for (let y = top; y < top + SQUARE; ++y) {
    const start = 4 * (y * expected.width + left);
    for (let at = start; at < start + 4 * SQUARE; ++at) {
      if (at % 4 < 3) sums[at % 4] += shown.data[at] - expected.data[at];
    }
  }
  return Math.max(...sums.map(Math.abs)) / SQUARE ** 2;
}

/** Returns the largest value of the squares of a grid of half squares. */
function worstSquare(shown, expected) {
  let worst = 0;
  for (let top = 0; top + SQUARE <= expected.height; top += SQUARE / 2) {
    for (let left = 0; left + SQUARE <= expected.width; left += SQUARE / 2) {
      worst = Math.max(worst, squareMiss(shown, expected, left, top));
    }
  }
  return worst;
}

/** Returns the number of pixels where paper shines through. */
function countPinholes(shown, expected) {
  const darkest = (image, at) => Math.min(...image.data.subarray(at, at + 3));
  let count = 0;
  for (let at = 0; at < shown.data.length; at += 4) {
    if (darkest(shown, at) === 255 && darkest(expected, at) < FAR_FROM_WHITE) count += 1;
  }
  return count;
}

function compare(files, { document, mean, percentile, square }, program) {
  const found = difference(PNG, ...files);
  const [shown, expected] = files.map((bytes) => PNG.sync.read(bytes));
  const worst = worstSquare(shown, expected);
  const pinholes = countPinholes(shown, expected);
  const text =
    `mean ${found.mean.toFixed(2)}, 99th percentile ${found.percentile}, ` +
    `worst square ${worst.toFixed(1)}, ${pinholes} pinholes`;
  console.log(`# ${shortName(document)} as PDF in ${program}: ${text}`);
  check(found.mean <= mean && found.percentile <= percentile && worst <= square, text);
  check(pinholes === 0, text);
}

/** Needs no browser. */
export async function testPdf(tap, { command }) {
  const library = await PDFiumLibrary.init();
  for (const tested of SHOWN) {
    const { document, options = [] } = tested;
    const name = shortName(document);
    await tap.test(`PDFium shows the PDF of ${name} as the rasterizer does`, async () => {
      const shown = await shownByPdfium(library, command.made(document, "pdf", ...options));
      writeFileSync(command.file(`${name}.pdf.png`), shown);
      compare([shown, readFileSync(command.made(document, "png", "--no-dither"))], tested, "PDFium");
    });
  }
  library.destroy();
}

/** The margins of Chromium's viewer around the page: pixels above it, and on each side. */
const ABOVE = 3;
const BESIDE = 32;

/** Returns the viewer's pixels in the place of the page, once it shows something there and is done. */
async function pageInViewer(page, [width, height]) {
  let before = Buffer.alloc(0);
  const clip = { x: BESIDE, y: ABOVE, width, height };
  for (const end = performance.now() + PATIENCE; performance.now() < end; ) {
    const shown = await page.screenshot({ clip });
    if (rangeOf(PNG, shown) > 0 && shown.equals(before)) return shown;
    before = shown;
    await page.waitForTimeout(100);
  }
  throw new Error("the viewer stays empty");
}

export async function testPdfInChromium(tap, { command, pages }) {
  const tested = SHOWN.find(({ document }) => document === "examples/apple.svg");
  await tap.test("Chromium shows the PDF of apple.svg as the rasterizer does", async () => {
    const pdf = command.made(tested.document, "pdf");
    const expected = readFileSync(command.made(tested.document, "png", "--no-dither"));
    const { width, height } = PNG.sync.read(expected);
    const viewport = { width: width + 2 * BESIDE, height: height + 4 * ABOVE };
    const context = await pages.browser.newContext({ viewport });
    try {
      const page = await context.newPage();
      page.setDefaultTimeout(PATIENCE);
      // A Chromium without the viewer starts a download here, which is an error.
      const address = `file://${pdf}#zoom=100&toolbar=0&navpanes=0`;
      const hasViewer = await page.goto(address).then(() => true, () => false);
      if (!hasViewer) throw new Skip("Chromium has no viewer of PDF here");
      compare([await pageInViewer(page, [width, height]), expected], tested, "Chromium");
    } finally {
      await context.close();
    }
  });
}
