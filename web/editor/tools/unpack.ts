// Stands in build/editor.html before everything else: has the module unpacked, unpacks the style and the
// script that the page holds, and runs them. The page's policy knows both by their hashes.
import { beginModule } from "../src/engine/module.file.js";
import { takePacked, unpacked } from "../src/engine/packed.js";

/** Some servers say that every page is UTF-8, which loses the packed bytes: they are read once more. */
async function readAgain() {
  const answer = await fetch(location.href);
  const text = new TextDecoder("windows-1252").decode(await answer.arrayBuffer());
  const page = new DOMParser().parseFromString(text, "text/html");
  for (const element of document.querySelectorAll("script[type='application/octet-stream']")) {
    element.textContent = page.getElementById(element.id)!.textContent;
  }
}

function insert(name: string, id: string, attributes: object = {}) {
  const textContent = new TextDecoder().decode(unpacked(takePacked(id)));
  document.head.append(Object.assign(document.createElement(name), attributes, { textContent }));
}

try {
  if (document.characterSet !== "windows-1252") await readAgain();
  beginModule();
  insert("style", "packed-style");
  insert("script", "packed-script", { type: "module" });
} catch {
  document.getElementById("too-old")!.hidden = false;
}
