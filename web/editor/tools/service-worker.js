// Keeps the editor's files in this browser, so that it works without a network. All files of one build
// belong together: they are fetched as a whole, and answer until every tab with them is closed.
const version = "{{version}}";
const files = ["{{files}}"];
// Several editors may lie below one origin, each in a folder of its own.
const ours = `sfumato:${registration.scope}:`;
const own = ours + version;

async function keep() {
  const cache = await caches.open(own);
  await cache.addAll(files.map((file) => new Request(file, { cache: "reload" })));
}

async function forgetOthers() {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(ours) && name !== own);
  await Promise.all(old.map((name) => caches.delete(name)));
}

async function answer(request) {
  const cache = await caches.open(own);
  const page = request.mode === "navigate" ? new URL("./", registration.scope) : request;
  return (await cache.match(page, { ignoreSearch: request.mode === "navigate" })) ?? fetch(request);
}

addEventListener("install", (event) => event.waitUntil(keep()));
addEventListener("activate", (event) => event.waitUntil(forgetOthers()));
addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method === "GET" && request.url.startsWith(registration.scope)) {
    event.respondWith(answer(request));
  }
});
