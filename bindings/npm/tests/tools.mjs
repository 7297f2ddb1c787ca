// Shared by the package's tests: an empty project with the package installed, a server, pages.
import { execFileSync } from "node:child_process";
import { cpSync, createReadStream, existsSync, mkdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join, normalize } from "node:path";
import { pathToFileURL } from "node:url";
import { pathOf } from "../../../tests/viewer/harness.mjs";

export { PATIENCE, Skip, Tap, check, checkEqual, checkNear } from "../../../tests/tap.mjs";
export { pathOf } from "../../../tests/viewer/harness.mjs";

/** Finds packages that only the tests need. */
export const packageOf = createRequire(import.meta.url);

/** Runs a program; an error contains the program's output. */
export function run(folder, program, ...words) {
  try {
    return execFileSync(program, words, { cwd: folder, stdio: ["ignore", "pipe", "pipe"], encoding: "utf8" });
  } catch (error) {
    throw new Error(`${words.join(" ")}: ${error.stdout}\n${error.stderr}`);
  }
}

const npm = process.platform === "win32" ? "npm.cmd" : "npm";

/** Makes a project of a user, with only the tarball installed. */
export function emptyProject(folder, tarball) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, "package.json"), JSON.stringify({ name: "a-site", private: true, type: "module" }));
  run(folder, npm, "install", "--offline", "--no-audit", "--no-fund", "--ignore-scripts", tarball);
  cpSync(pathOf("bindings/npm/tests/site"), folder, { recursive: true });
}

/** Imports a name in the project, in Node. */
export function importOf(project, name) {
  const entry = createRequire(join(project, "package.json")).resolve(name);
  return import(pathToFileURL(entry));
}

const types = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
  ".xml": "text/xml",
  ".png": "image/png",
};

/** The content policy that the README asks for; it must suffice. */
const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self'",
  "img-src 'self' data:",
  "style-src 'self'",
].join("; ");

/** Serves a folder on this machine only. A missing file is 404; in /spa/ it is a page, as on some sites. */
export async function serve(folder, headers = {}) {
  const server = createServer((request, response) => {
    const name = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname));
    let path = join(folder, name);
    if (existsSync(path) && statSync(path).isDirectory()) path = join(path, "index.html");
    if (name === "/favicon.ico") return response.writeHead(204).end();
    if (name.startsWith("/spa/")) {
      response.writeHead(200, { "Content-Type": "text/html" });
      return response.end("<!doctype html><title>A site</title>");
    }
    if (!path.startsWith(folder) || !existsSync(path)) return response.writeHead(404).end();
    response.writeHead(200, {
      "Content-Type": types[extname(path)] ?? "application/octet-stream",
      "Content-Security-Policy": policy,
      ...headers,
    });
    createReadStream(path).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}
