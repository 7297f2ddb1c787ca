// The viewer's modules, and the single script that the page makes of them.
import { readFileSync, readdirSync } from "node:fs";
import { Script } from "node:vm";
import { check, pathOf } from "./harness.mjs";

const folder = pathOf("web/viewer");
const read = (file) => readFileSync(`${folder}/${file}`, "utf8");
const files = readdirSync(folder).filter((file) => file.endsWith(".js"));

const DECLARATION = /^(?:export )?(?:async )?(?:function\*?|class|const|let|var) (\w+|[{[])/gm;
const IMPORT = /^import \{\s*(\w+,\s+)*\w+,?\s+\} from "\.\/(\w+\.js)";$/gm;
/** Module syntax that the single script may contain instead. */
const LINKAGE =
  /^(?:import \{[\w\s,]+\} from "\.\/\w+\.js";$|export (?:async )?(?:function|class|const) )/;

const matches = (pattern, text, group) => [...text.matchAll(pattern)].map((m) => m[group]);

function checkNames() {
  const owner = new Map();
  for (const file of files) {
    for (const name of matches(DECLARATION, read(file), 1)) {
      check(/^\w+$/.test(name), `${file} takes names at its top level out of a value`);
      check(!owner.has(name), `${name} stands at the top level of ${file} and ${owner.get(name)}`);
      owner.set(name, file);
    }
  }
  check(owner.size > 100, `only ${owner.size} names were found`);
}

function checkLinkage() {
  for (const file of files) {
    const text = read(file);
    for (const { index } of text.matchAll(/^\s*(?:import|export)\b(?!\s*[(.:,=])/gm)) {
      const line = text.slice(index).trimStart();
      const form = LINKAGE.test(line.slice(0, line.indexOf(";") + 1)) || LINKAGE.test(line);
      check(form, `${file}: ${line.slice(0, 40)}`);
    }
  }
}

/** Returns the script of a page, which is its last one. */
const scriptOf = (page) =>
  page.slice(page.lastIndexOf("<script>") + "<script>".length, page.lastIndexOf("</script>"));

/** Returns `main.js` and all its imports; the folder also holds modules that only the editor imports. */
function filesOfPage() {
  const found = new Set(["main.js"]);
  for (const file of found) {
    for (const other of matches(IMPORT, read(file), 2)) found.add(other);
  }
  return [...found];
}

function checkScript(page) {
  const script = scriptOf(page);
  check(!/^\s*(import|export)\b/m.test(script), "its script holds an import or an export");
  new Script(script);
  const held = filesOfPage();
  check(held.length > 10, `only ${held.length} modules are imported`);
  const begins = new Map(
    held.map((file) => {
      const [first] = matches(DECLARATION, read(file), 0);
      const at = script.indexOf(`\n${first.replace(/^export /, "")}`);
      check(at >= 0, `its script lacks ${file}`);
      return [file, at];
    }),
  );
  for (const file of held) {
    for (const other of matches(IMPORT, read(file), 2)) {
      const isBehind = begins.get(other) < begins.get(file);
      check(isBehind, `${file} stands before ${other}, which it imports`);
    }
  }
}

export async function testModules(tap, { command }) {
  await tap.test("the viewer's modules could be one script: no name stands twice", checkNames);
  await tap.test("they import and export in forms that a script can do without", checkLinkage);
  await tap.test("the page holds one script, each module after those that it imports", () =>
    checkScript(readFileSync(command.html("tests/viewer/small.svg"), "utf8")),
  );
}
