// The policy of the editor's pages: run only their own code, and contact only the server that they come from.
import { createHash } from "node:crypto";

/** A source of Content-Security-Policy that allows one inline text. */
export const hashOf = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

/** Texts of scripts that stand in a page itself, for its policy to allow. */
export const inlineScripts = (html) =>
  [...html.matchAll(/<script>([^]*?)<\/script>/g)].map(([, text]) => text);

/** @param scripts, styles sources of each */
export function policyTag(scripts, styles) {
  const policy = [
    "default-src 'self' blob: data:",
    `script-src ${scripts} 'wasm-unsafe-eval'`,
    `style-src ${styles}`,
    "worker-src 'self' blob:",
    "object-src 'none'",
    "base-uri 'none'",
    "form-action 'none'",
  ];
  return `<meta http-equiv="Content-Security-Policy" content="${policy.join("; ")}" />`;
}

/** Puts text behind <head>, before everything that it rules over. */
export const intoHead = (html, text) => html.replace("<head>", () => `<head>\n    ${text}`);
