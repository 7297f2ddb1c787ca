// A worker gets every image, whenever it arrives.
import { expect, it } from "vitest";
import { Seat, type Host } from "../../../web/editor/src/engine/seat.js";
import type { GivenImage } from "../../../web/editor/src/engine/types.js";

const image = (href: string): GivenImage => ({
  href,
  bytes: new Uint8Array(4),
  pixels: { width: 1, height: 1, data: new Uint8ClampedArray(4) },
});

/** Returns a host whose workers answer each call when `answer` is called, and the images that they got. */
function slowHost() {
  const got: string[] = [];
  const waiting: (() => void)[] = [];
  const worker = {
    onmessage: null as ((event: MessageEvent) => void) | null,
    postMessage({ id, name, given }: { id: number; name: string; given: [readonly GivenImage[]] }) {
      if (name === "addImages") got.push(...given[0].map(({ href }) => href));
      waiting.push(() => this.onmessage?.({ data: { id } } as MessageEvent));
    },
  };
  const answer = async () => {
    for (const reply of waiting.splice(0)) reply();
    await new Promise((done) => setTimeout(done));
  };
  const host: Host = { module: () => Promise.resolve({}), worker: () => worker as unknown as Worker };
  return { host, got, answer };
}

it("is given an image that arrives while others are handed in", async () => {
  const { host, got, answer } = slowHost();
  const seat = new Seat(host, "w0");
  const images = [image("a.png")];
  const first = seat.give(images);
  images.push(image("b.png"), image("c.png"));
  await answer();
  await first;
  const second = seat.give(images);
  await answer();
  await second;
  expect(got).toEqual(["a.png", "b.png", "c.png"]);
});
