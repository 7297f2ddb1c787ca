// Words of the first page.
import { curvesOf, shared } from "./shared.js";

export const welcome = {
  lede: "Paint with curves",
  ledeText: "Give a curve a colour on each side. The picture fills itself in, smooth at any size.",
  blank: "Start blank",
  blankText: "An empty page",
  photo: "Trace a photo",
  photoText: "Draw over a picture and take its colours",
  open: "Open a file",
  openText: "SVG or Orzan’s XML; or drop it here",
  begin: "Start from an example",
  curves: curvesOf,
  exampleFailed: (name: string) => `“${name}” could not be read. Nothing was opened.`,
  recent: "Recent",
  edited: (when: string) => `edited ${when}`,
  allStored: (count: number) => `All ${count} drawings`,
  theme: shared.theme,
  how: "How it works",
  tryIt: "Try the five steps",
  steps: [
    { title: shared.drawCurve, text: "Draw anywhere, with the pencil or the pen." },
    { title: shared.colorBothSides, text: "Each colour spreads until it meets another." },
    { title: "Vary the colours", text: "Add a stop wherever the colour changes." },
    { title: shared.softenWithBlur, text: "Pull the bracket: sharp here, soft there." },
    { title: "Stack layers", text: "Curves meet only within their layer." },
  ],
  private: "Everything stays on this device. Nothing is uploaded.",
} as const;
