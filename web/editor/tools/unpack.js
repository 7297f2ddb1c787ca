// Stands in build/editor.html before everything else: unpacks the style and the script that the page
// holds as base64 of gzip, and runs them. The page's policy knows both by their hashes.
async function unpacked(id) {
  const element = document.getElementById(id);
  const { body } = await fetch(`data:application/gzip;base64,${element.textContent}`);
  element.remove();
  return new Response(body.pipeThrough(new DecompressionStream("gzip"))).text();
}

function insert(name, text, attributes = {}) {
  const element = Object.assign(document.createElement(name), attributes, { textContent: text });
  document.head.append(element);
}

try {
  insert("style", await unpacked("packed-style"));
  insert("script", await unpacked("packed-script"), { type: "module" });
} catch {
  document.getElementById("too-old").hidden = false;
}
