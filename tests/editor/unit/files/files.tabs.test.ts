import { afterEach, beforeEach, expect, test, vi } from "vitest";

/** Channels of one browser: a message reaches all channels except its sender, also in the same tab. */
class Channel {
  static all = new Set<Channel>();
  onmessage: ((event: { data: unknown }) => void) | null = null;
  constructor(readonly name: string) {
    Channel.all.add(this);
  }
  postMessage(data: unknown) {
    for (const other of Channel.all) {
      if (other !== this && other.name === this.name) queueMicrotask(() => other.onmessage?.({ data }));
    }
  }
  close() {
    Channel.all.delete(this);
  }
}

/** Returns a tab with its own modules. */
async function tab() {
  vi.resetModules();
  return import("../../../../web/editor/src/files/tabs.js");
}

const handle = (name: string) =>
  ({ name, isSameEntry: async (other: { name: string }) => other.name === name }) as unknown as FileSystemFileHandle;

beforeEach(() => void vi.stubGlobal("BroadcastChannel", Channel));
afterEach(() => {
  Channel.all.clear();
  vi.unstubAllGlobals();
});

test("a file that another tab has open is known to be", async () => {
  const [first, second] = [await tab(), await tab()];
  let current: FileSystemFileHandle | null = null;
  const end = first.answerOtherTabs(() => current);
  expect(await second.isOpenElsewhere(handle("a.svg"))).toBe(false);
  current = handle("a.svg");
  expect(await second.isOpenElsewhere(handle("a.svg"))).toBe(true);
  expect(await second.isOpenElsewhere(handle("b.svg"))).toBe(false);
  end();
  expect(await second.isOpenElsewhere(handle("a.svg"))).toBe(false);
  expect(Channel.all.size).toBe(0);
});

test("a tab that opens its own file again is no other tab", async () => {
  const only = await tab();
  only.answerOtherTabs(() => handle("a.svg"));
  expect(await only.isOpenElsewhere(handle("a.svg"))).toBe(false);
});

test("a browser without channels, or that clones no handles, knows of no other tab", async () => {
  const { isOpenElsewhere, answerOtherTabs } = await tab();
  vi.stubGlobal("BroadcastChannel", class extends Channel {
    override postMessage() {
      throw new DOMException("", "DataCloneError");
    }
  });
  expect(await isOpenElsewhere(handle("a.svg"))).toBe(false);
  vi.unstubAllGlobals();
  vi.stubGlobal("BroadcastChannel", undefined);
  Reflect.deleteProperty(globalThis, "BroadcastChannel");
  expect(await isOpenElsewhere(handle("a.svg"))).toBe(false);
  answerOtherTabs(() => null)();
});
