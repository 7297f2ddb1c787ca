// Files as the browser's dialogs return them, without dialogs: handles of the page's own file system.

/**
 * Runs before the page's scripts. The tests control it through `window.disk`: `chosen` is the name that the next
 * dialog returns, and "" cancels the dialog; `permission` and `failure` apply to writing; `writes` counts complete
 * writes.
 */
function install() {
  const folder = () => navigator.storage.getDirectory();
  const handle = async (name, create) => (await folder()).getFileHandle(name, { create });
  const disk = { chosen: "", permission: "granted", failure: "", writes: 0, asked: null };
  const proto = FileSystemFileHandle.prototype;
  const { createWritable } = proto;
  const leave = () => {
    throw new DOMException("left", "AbortError");
  };
  disk.write = async (name, bytes) => {
    const stream = await createWritable.call(await handle(name, true));
    await stream.write(Uint8Array.from(bytes));
    await stream.close();
  };
  disk.read = async (name) => [...new Uint8Array(await (await (await handle(name)).getFile()).arrayBuffer())];
  disk.remove = async (name) => (await folder()).removeEntry(name);
  disk.has = async (name) => (await Array.fromAsync((await folder()).keys())).includes(name);
  window.disk = disk;
  window.showOpenFilePicker = async () => (disk.chosen ? [await handle(disk.chosen)] : leave());
  window.showSaveFilePicker = async (asked) => {
    disk.asked = asked;
    return disk.chosen ? handle(disk.chosen, true) : leave();
  };
  window.showDirectoryPicker = async () => folder();
  proto.requestPermission = async () => disk.permission;
  proto.createWritable = async function (...given) {
    if (disk.failure) throw new DOMException("refused", disk.failure);
    const stream = await createWritable.apply(this, given);
    const ends = {
      write: (chunk) => stream.write(chunk),
      close: () => stream.close().then(() => void (disk.writes += 1)),
      abort: (reason) => stream.abort(reason),
    };
    // For callers that write directly, and for callers that pipe.
    return Object.assign(new WritableStream(ends), { write: ends.write, close: ends.close });
  };
}

/** Gives a context such a disk. */
export const giveDisk = (context) => context.addInitScript(install);

/** The test's access to a page's disk. */
export class Disk {
  constructor(page) {
    this.page = page;
  }

  set(values) {
    return this.page.evaluate((given) => void Object.assign(window.disk, given), values);
  }
  get(name) {
    return this.page.evaluate((key) => window.disk[key], name);
  }
  write(name, bytes) {
    return this.page.evaluate(([n, b]) => window.disk.write(n, b), [name, [...Buffer.from(bytes)]]);
  }
  async read(name) {
    return Buffer.from(await this.page.evaluate((n) => window.disk.read(n), name));
  }
  remove(name) {
    return this.page.evaluate((n) => window.disk.remove(n), name);
  }
  has(name) {
    return this.page.evaluate((n) => window.disk.has(n), name);
  }
}

/** Drops files as a script can: {name, bytes, type, size}; `size` instead of bytes makes zeros. */
export function drop(page, files, target = "#app") {
  const given = files.map(({ bytes, ...file }) => ({ ...file, bytes: bytes && [...Buffer.from(bytes)] }));
  return page.evaluate(
    ([list, selector]) => {
      const data = new DataTransfer();
      for (const { name, bytes, type = "", size } of list) {
        const mega = new Uint8Array(2 ** 20);
        const parts = bytes ? [Uint8Array.from(bytes)] : Array(Math.ceil(size / mega.length)).fill(mega);
        data.items.add(new File(parts, name, { type }));
      }
      const event = (type) => new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true });
      const element = document.querySelector(selector);
      const isTaken = !element.dispatchEvent(event("dragover"));
      if (isTaken) element.dispatchEvent(event("drop"));
      return isTaken;
    },
    [given, target],
  );
}

/** Pastes at the focus, as the browser does: {text, files}. */
export function paste(page, { text = "", files = [] }) {
  const given = files.map(({ name, bytes }) => ({ name, bytes: [...Buffer.from(bytes)] }));
  return page.evaluate(
    ([words, list]) => {
      const clipboardData = new DataTransfer();
      if (words) clipboardData.setData("text/plain", words);
      for (const { name, bytes } of list) clipboardData.items.add(new File([Uint8Array.from(bytes)], name));
      const event = new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true });
      (document.activeElement ?? document.body).dispatchEvent(event);
      // Afterwards the browser lets nobody read it.
      clipboardData.clearData();
    },
    [text, given],
  );
}

/** Returns the text that a "copy" or "cut" puts on the clipboard. */
export function copied(page, type) {
  return page.evaluate((name) => {
    const clipboardData = new DataTransfer();
    const event = new ClipboardEvent(name, { clipboardData, bubbles: true, cancelable: true });
    (document.activeElement ?? document.body).dispatchEvent(event);
    return clipboardData.getData("text/plain");
  }, type);
}

/** Drops files and folders of the real disk, as the system does. */
export async function dropPaths(editor, paths, [x, y] = [700, 400]) {
  const session = await editor.context.newCDPSession(editor.page);
  const data = { items: [], files: paths, dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"]) {
    await session.send("Input.dispatchDragEvent", { type, x, y, data });
  }
  await session.detach();
}

/** Returns the bytes of a download that an action starts. */
export async function downloaded(page, act) {
  const [download] = await Promise.all([page.waitForEvent("download"), act()]);
  const parts = [];
  for await (const part of await download.createReadStream()) parts.push(part);
  return { name: download.suggestedFilename(), bytes: Buffer.concat(parts) };
}
