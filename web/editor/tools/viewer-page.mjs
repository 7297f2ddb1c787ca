// The viewer's page as `sfumato render -o page.html` writes it, with the marks {{title}}, {{fallback}} and
// {{payload}} left for the editor. src/export/html/html.cpp defines its parts and their order.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";

const file = (path) => fileURLToPath(new URL(`../../../${path}`, import.meta.url));
const read = (path) => readFileSync(file(path), "utf8");
const assembly = "src/export/html/html.cpp";

/** The names in a list of html.cpp. */
function listed(source, name) {
  const body = new RegExp(`string_view ${name}\\[\\] = \\{([^}]*)\\}`).exec(source)?.[1];
  const names = [...(body ?? "").matchAll(/"([^"]+)"/g)].map(([, found]) => found);
  if (names.length === 0) throw new Error(`${assembly} has no list ${name}`);
  return names;
}

/** As condensed() of src/export/html/html_text.hpp. */
export function condensed(source) {
  let inComment = false;
  const codeOf = (whole) => {
    let line = whole.replace(/^[ \t\r]+/, "");
    while (inComment || line.startsWith("/*")) {
      const end = line.indexOf("*/", inComment ? 0 : 2);
      inComment = end < 0;
      if (inComment) return "";
      line = line.slice(end + 2).replace(/^[ \t\r]+/, "");
    }
    return line.startsWith("//") ? "" : line;
  };
  const lines = source.split("\n").map(codeOf);
  return lines.filter((line) => line !== "").map((line) => `${line}\n`).join("");
}

/** As script_of_module() there: imports and lists of exports fall away, `export` before a declaration. */
export function scriptOfModule(text) {
  const linkage = /^(?:import(?=[\s{*"'])(?!\s*\()|export\s*(?=[{*]))[^;]*;[ \t\r]*\n?/;
  let result = "";
  for (let rest = text; rest !== ""; ) {
    const statement = linkage.exec(rest);
    if (statement) {
      rest = rest.slice(statement[0].length);
      continue;
    }
    if (rest.startsWith("export ")) rest = rest.slice("export ".length);
    const end = rest.indexOf("\n") + 1 || rest.length;
    result += rest.slice(0, end);
    rest = rest.slice(end);
  }
  return result;
}

/** As squeezed() there. */
export function squeezed(text) {
  const isWord = (c) => /[\w$]|[^\0-\x7f]/.test(c);
  const joins = (a, b) => (isWord(a) && isWord(b)) || (/[+-]/.test(a) && a === b);
  const squeezedLine = (line) => {
    if (/[/`]/.test(line)) return line;
    let result = "",
      quote = "";
    for (let i = 0; i < line.length; ++i) {
      const c = line[i];
      const ends = i + 1 === line.length || result === "";
      if (quote === "" && c === " " && (ends || !joins(result.at(-1), line[i + 1]))) continue;
      result += c;
      if (quote === "" && /["']/.test(c)) quote = c;
      else if (quote !== "" && c === "\\" && i + 1 < line.length) result += line[++i];
      else if (c === quote) quote = "";
    }
    return result;
  };
  return text.split("\n").map(squeezedLine).join("\n");
}

const viewer = (name) => condensed(read(`web/viewer/${name}`));

/** A shader's text; one stands elsewhere, since the library reads it, too. */
const shader = (name) =>
  name === "point_walk.glsl" ? condensed(read(`src/gather/${name}`)) : viewer(`shaders/${name}`);

/** The template's text. */
export function viewerPage() {
  const source = read(assembly);
  const shaders = listed(source, "kShaders").map((name) => `${name}\0${shader(name)}\0`).join("");
  const parts = {
    style: viewer("viewer.css"),
    shaders: deflateSync(shaders, { level: 9 }).toString("base64"),
    script: listed(source, "kScripts").map((name) => squeezed(scriptOfModule(viewer(name)))).join(""),
  };
  return read("web/viewer/page.html").replace(/\{\{(\w+)\}\}/g, (mark, name) => parts[name] ?? mark);
}

/** Gives the page to `import template from "virtual:viewer-page"`. */
export function viewerPagePlugin() {
  const name = "virtual:viewer-page";
  return {
    name: "viewer-page",
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load: (id) => (id === `\0${name}` ? `export default ${JSON.stringify(viewerPage())};` : null),
  };
}
