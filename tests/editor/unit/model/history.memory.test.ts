// An undo step uses memory for its patch, not for the text that the patch changes.
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { expect, it } from "vitest";
import { History } from "../../../../web/editor/src/app/history.js";

setFlagsFromString("--expose-gc");
const collect = runInNewContext("gc") as () => void;

function heap(): number {
  collect();
  return process.memoryUsage().heapUsed;
}

it("steps of undo do not keep the texts that they changed", () => {
  const history = new History();
  const before = heap();
  for (let i = 0; i < 60; i += 1) {
    const text = [String(i).padStart(8), "x".repeat(1e6)].join(" ");
    const removed = text.slice(2, 40);
    history.push({ label: "Move", patch: [{ at: 2, removed, inserted: "y" }], before: [], after: [] });
  }
  expect(heap() - before).toBeLessThan(10e6);
  expect(history.undo()[0].patch[0].inserted.length).toBe(38);
});
