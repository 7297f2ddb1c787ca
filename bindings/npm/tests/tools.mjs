// What the tests of the package share: an empty project with the package installed, a server, pages.
import { execFileSync } from "node:child_process";
import { cpSync, createReadStream, existsSync, mkdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join, normalize } from "node:path";
import { pathToFileURL } from "node:url";
import { pathOf } from "../../../tests/viewer/harness.mjs";

export { PATIENCE, Skip, Tap, check, checkEqual, checkNear } from "../../../tests/tap.mjs";
export { pathOf } from "../../../tests/viewer/harness.mjs";

/** Packages that only the tests need. */
export const packageOf = createRequire(import.meta.url);

/** Runs a program, and has what it says in the error where it fails. */
export function run(folder, program, ...words) {
  try {
    return execFileSync(program, words, { cwd: folder, stdio: ["ignore", "pipe", "pipe"], encoding: "utf8" });
  } catch (error) {
    throw new Error(`${words.join(" ")}: ${error.stdout}\n${error.stderr}`);
  }
}

const npm = process.platform === "win32" ? "npm.cmd" : "npm";

/** A project of somebody else, with the tarball installed and nothing else. */
export function emptyProject(folder, tarball) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, "package.json"), JSON.stringify({ name: "a-site", private: true, type: "module" }));
  run(folder, npm, "install", "--offline", "--no-audit", "--no-fund", "--ignore-scripts", tarball);
  cpSync(pathOf("bindings/npm/tests/site"), folder, { recursive: true });
}

/** What the project's import of a name gives, in node. */
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

/** What the README says a page has to allow; nothing else may be needed. */
const policy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self'",
  "img-src 'self' data:",
  "style-src 'self'",
].join("; ");

/** Serves a folder on this machine alone. What is not there is 404, and in /spa/ a page, as some sites do. */
export async function serve(folder) {
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
    });
    createReadStream(path).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}
