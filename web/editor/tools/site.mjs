// build/editor/: the static site.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "vite";
import { hashOf, inlineScripts, intoHead, policyTag } from "./policy.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

/** All files below a folder, sorted. */
function filesBelow(folder) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)))
    .sort();
}

/** The service worker for what the folder holds; its version follows from the files' content. */
function writeServiceWorker(folder) {
  const files = filesBelow(folder);
  const hash = createHash("sha256");
  for (const file of files) hash.update(`${file}\0`).update(readFileSync(join(folder, file)));
  const kept = ["./", ...files.filter((file) => file !== "index.html")];
  const text = readFileSync(here("service-worker.js"), "utf8")
    .replace("{{version}}", hash.digest("hex").slice(0, 16))
    .replace('["{{files}}"]', JSON.stringify(kept));
  writeFileSync(join(folder, "sw.js"), text);
}

const policyPlugin = {
  name: "policy",
  transformIndexHtml: {
    order: "post",
    handler: (html) => intoHead(html, policyTag(["'self'", ...inlineScripts(html).map(hashOf)].join(" "), "'self'")),
  },
};

const manifest = '<link rel="manifest" href="./manifest.webmanifest" />';
const icon = '<link rel="icon" href="./icon.svg" type="image/svg+xml" />';

const iconPlugin = {
  name: "icons",
  transformIndexHtml: (html) => html.replace("</head>", () => `  ${manifest}\n    ${icon}\n  </head>`),
};

/** @param folder where the site goes; what is there is removed */
export async function buildSite(folder) {
  await build({
    configFile: here("../vite.config.ts"),
    logLevel: "warn",
    plugins: [iconPlugin, policyPlugin],
    build: { outDir: folder },
  });
  writeServiceWorker(folder);
}
