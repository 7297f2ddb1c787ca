// User actions that several benchmarks of the page share.

/** Returns points of the artboard where paths of a text begin, if no transform moves them. */
async function startsOf(editor) {
  const text = await editor.text;
  const starts = [...text.matchAll(/\sd="\s*M\s*([-\d.e]+)[\s,]+([-\d.e]+)/gi)];
  const step = Math.max(1, Math.floor(starts.length / 40));
  return starts.filter((_, i) => i % step === 0).map(([, x, y]) => [Number(x), Number(y)]);
}

/** Selects a node that can be dragged. Returns its place on the page. */
export async function takeNode(editor) {
  await editor.page.locator(".canvas-stage").focus();
  await editor.key("a");
  for (const [x, y] of await startsOf(editor)) {
    const place = await editor.at(x, y);
    const isSeen = await editor.page.evaluate(([a, b]) => document.elementFromPoint(a, b)?.closest(".canvas-stage") !== null, place);
    if (!isSeen) continue;
    for (let i = 0; i < 2; i += 1) await editor.page.mouse.click(...place);
    const selection = await editor.page.evaluate(() => window.sfumatoEditor.selection);
    if (selection.length === 1 && selection[0].part.kind === "node") return place;
  }
  throw new Error("no node of the drawing can be taken hold of");
}

/** Returns places on a circle through a place; the first is that place. */
export function circleFrom([x, y], radius, count) {
  const place = (i) => [x + radius * (Math.cos(i / 5) - 1), y + radius * Math.sin(i / 5)];
  return Array.from({ length: count }, (_, i) => place(i));
}
