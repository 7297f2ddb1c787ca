// The bundle of the viewer in a copy of its folder: a new script needs its file and one import.
import { spawnSync } from "node:child_process";
import { appendFileSync, cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { check, checkEqual, pathOf } from "./harness.mjs";

/** Copies the files that the bundle is made of, and returns the folder of the viewer there. */
function copyOfViewer(root) {
  const viewer = join(root, "web/viewer");
  const modules = pathOf("web/viewer/node_modules");
  cpSync(pathOf("web/viewer"), viewer, { recursive: true, filter: (path) => path !== modules });
  symlinkSync(modules, join(viewer, "node_modules"));
  mkdirSync(join(root, "src/gather"), { recursive: true });
  cpSync(pathOf("src/gather/point_walk.glsl"), join(root, "src/gather/point_walk.glsl"));
  return viewer;
}

export async function testBundle(tap) {
  await tap.test("a new script of the viewer needs its file and one import", () => {
    const root = mkdtempSync(join(tmpdir(), "sfumato-viewer-"));
    try {
      const viewer = copyOfViewer(root);
      const build = (...options) =>
        spawnSync(process.execPath, [join(viewer, "build.mjs"), ...options], { encoding: "utf8" });
      checkEqual(build("--check").stderr, "", "complaints about the checked-in bundle");
      writeFileSync(join(viewer, "extra.js"), 'export const extra = "an extra script";\n');
      appendFileSync(join(viewer, "main.js"), 'import { extra } from "./extra.js";\ndocument.body.title = extra;\n');
      const old = build("--check");
      checkEqual(old.status, 1, "the exit code of a check of an old bundle");
      check(old.stderr.includes("page.html is out of date: run make viewer"), old.stderr);
      checkEqual(build().status, 0, "the exit code of the build");
      check(readFileSync(join(viewer, "dist/page.html"), "utf8").includes("an extra script"), "the page lacks the script");
      checkEqual(build("--check").status, 0, "the exit code of a check of the new bundle");
    } finally {
      rmSync(root, { recursive: true });
    }
  });
}
