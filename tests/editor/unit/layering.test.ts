// The check of the editor's imports (web/editor/layering.mjs), on small folders of files.
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const script = fileURLToPath(new URL("../../../web/editor/layering.mjs", import.meta.url));

/** Returns the exit status of the check and its complaints, for files by their names; none: the editor's own. */
function check(files: Readonly<Record<string, string>> | null) {
  const folder = mkdtempSync(join(tmpdir(), "sfumato-layering-"));
  for (const [name, text] of Object.entries(files ?? {})) {
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
  const { status, stderr } = spawnSync(process.execPath, files ? [script, folder] : [script], { encoding: "utf8" });
  rmSync(folder, { recursive: true });
  return { status, complaints: stderr.trim() };
}

test("the editor's files import each other in one direction", () => {
  expect(check(null)).toEqual({ status: 0, complaints: "" });
});

test("files that import each other in a circle are named, in their order", () => {
  const { status, complaints } = check({
    "model/a.ts": 'import { b } from "./b.js";\nexport const a = b;\n',
    "model/b.ts": 'import {\n  c,\n} from "./c.js";\nexport const b = c;\n',
    "model/c.ts": 'export { a as c } from "./a.js";\n',
    "model/d.ts": 'import { a } from "./a.js";\nexport const d = a;\n',
  });
  expect(status).toBe(1);
  expect(complaints).toBe("files import each other in a circle: model/a.ts → model/b.ts → model/c.ts → model/a.ts");
});

test("a circle of types counts too, and one of import() does not", () => {
  const types = {
    "model/a.ts": 'import type { B } from "./b.js";\nexport type A = B;\n',
    "model/b.tsx": 'import type { A } from "./a.js";\nexport type B = A;\n',
  };
  expect(check(types).complaints).toContain("model/a.ts → model/b.tsx → model/a.ts");
  const later = { ...types, "model/b.tsx": 'export type B = 1;\nexport const a = () => import("./a.js");\n' };
  expect(check(later)).toEqual({ status: 0, complaints: "" });
});

test("a folder imports no folder above it, and of some the types alone", () => {
  const files = { "panels/x.ts": "export type X = 1;\n", "canvas/y.ts": "export type Y = 1;\n" };
  const up = check({ ...files, "geometry/z.ts": 'import { x } from "../panels/x.js";\n' });
  expect(up).toEqual({ status: 1, complaints: "geometry/z.ts imports ../panels/x.js: geometry stands below panels" });
  expect(check({ ...files, "app/z.ts": 'import type { Y } from "../canvas/y.js";\n' }).status).toBe(0);
  expect(check({ ...files, "app/z.ts": 'import { y } from "../canvas/y.js";\n' }).status).toBe(1);
});
