#include "cli/servers/watch_page.hpp"

namespace sfumato::cli::watch_page {

const std::string_view kHtml = R"page(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>sfumato watch</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="watch.css">
</head>
<body>
<header>
  <strong id="name"></strong>
  <span id="status" role="status"></span>
  <span class="tools">
    <button id="smaller" title="Smaller (-)">−</button>
    <button id="fit" title="Fit the window (0)">Fit</button>
    <button id="real" title="One pixel of the picture is one of the screen (1)">1:1</button>
    <button id="larger" title="Larger (+)">+</button>
    <output id="zoom"></output>
  </span>
</header>
<main id="stage" tabindex="0"><img id="picture" alt="The drawing"></main>
<pre id="messages" role="log" aria-label="Messages" hidden></pre>
<script src="watch.js"></script>
</body>
</html>
)page";

const std::string_view kStyle =
    R"page(:root { color-scheme: light dark; --line: #8884; --bad: light-dark(#b3261e, #ff8a7a); }
* { box-sizing: border-box; }
body { margin: 0; height: 100vh; display: flex; flex-direction: column;
  font: 14px/1.4 system-ui, sans-serif; }
header { display: flex; flex-wrap: wrap; gap: .3em 1em; align-items: center; padding: .4em .8em;
  border-bottom: 1px solid var(--line); }
#name { overflow-wrap: anywhere; }
#status { flex: 1 1 auto; opacity: .75; }
.failed #status { color: var(--bad); opacity: 1; font-weight: 600; }
.tools { display: flex; gap: .3em; align-items: center; margin-left: auto; }
button { font: inherit; min-width: 2.2em; }
#zoom { min-width: 4em; text-align: right; font-variant-numeric: tabular-nums; }
#stage.fits { overflow: hidden; }
#stage { flex: 1; overflow: auto; display: flex; min-height: 0; outline-offset: -2px; }
#picture { margin: auto; flex: none; display: block;
  background: repeating-conic-gradient(#bbb 0 25%, #eee 0 50%) 0 0 / 16px 16px; }
#picture:not([src]) { visibility: hidden; }
#messages { margin: 0; padding: .5em .8em; max-height: 35vh; overflow: auto; white-space: pre-wrap;
  overflow-wrap: anywhere; border-top: 1px solid var(--line); font: 13px/1.45 monospace; }
.failed #messages { border-top: 3px solid var(--bad); }
)page";

const std::string_view kScript = R"page('use strict';
const element = (id) => document.getElementById(id);
const picture = element('picture');
const stage = element('stage');
let zoom = 0;  // CSS pixels per pixel of the picture; 0: fits the window

function shownZoom() {
  if (zoom > 0) return zoom;
  const width = picture.naturalWidth, height = picture.naturalHeight;
  if (!width) return 1;
  return Math.min(stage.clientWidth / width, stage.clientHeight / height);
}

function layOut() {
  const scale = shownZoom();
  stage.classList.toggle('fits', zoom === 0);
  picture.style.width = `${picture.naturalWidth * scale}px`;
  picture.style.height = `${picture.naturalHeight * scale}px`;
  picture.style.imageRendering = scale * devicePixelRatio > 3 ? 'pixelated' : 'auto';
  element('zoom').textContent = picture.naturalWidth ? `${Math.round(scale * 100)}%` : '';
}

// The point of the picture under (x, y) of the stage stays there.
function zoomTo(wanted, x = stage.clientWidth / 2, y = stage.clientHeight / 2) {
  const box = stage.getBoundingClientRect();
  const before = picture.getBoundingClientRect();
  const u = (box.left + x - before.left) / (before.width || 1);
  const v = (box.top + y - before.top) / (before.height || 1);
  zoom = wanted > 0 ? Math.min(Math.max(wanted, 1 / 64), 64) : 0;
  layOut();
  const after = picture.getBoundingClientRect();
  stage.scrollLeft += after.left + u * after.width - (box.left + x);
  stage.scrollTop += after.top + v * after.height - (box.top + y);
}

element('smaller').onclick = () => zoomTo(shownZoom() / 1.25);
element('larger').onclick = () => zoomTo(shownZoom() * 1.25);
element('fit').onclick = () => zoomTo(0);
element('real').onclick = () => zoomTo(1 / devicePixelRatio);
// The window, the text above and the messages below change the stage's size.
new ResizeObserver(layOut).observe(stage);
addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const id = { '+': 'larger', '=': 'larger', '-': 'smaller', '0': 'fit', '1': 'real' }[event.key];
  if (id) element(id).click();
});
stage.addEventListener('wheel', (event) => {
  if (!event.ctrlKey) return;
  event.preventDefault();
  const box = stage.getBoundingClientRect();
  zoomTo(shownZoom() * Math.exp(-event.deltaY / 300), event.clientX - box.left,
         event.clientY - box.top);
}, { passive: false });

async function showPicture(name) {
  const next = new Image();
  next.src = `picture.png?${name}`;
  await next.decode();
  const { scrollLeft, scrollTop } = stage;
  picture.src = next.src;
  await picture.decode();
  layOut();
  stage.scrollTo(scrollLeft, scrollTop);
}

function showState(state) {
  document.title = `${state.failed ? '✗ ' : ''}${state.name} · sfumato watch`;
  document.body.classList.toggle('failed', state.failed);
  element('name').textContent = state.name;
  element('status').textContent = state.failed
    ? (state.picture || picture.src ? 'not drawn: the last good picture is shown' : 'not drawn')
    : `drawn in ${state.seconds.toFixed(2)} s`;
  const messages = element('messages');
  messages.textContent = state.messages.join('\n');
  messages.hidden = state.messages.length === 0;
}

async function follow() {
  let version = 0, shown = '';
  for (;;) {
    try {
      const answer = await fetch(`state?after=${version}`, { cache: 'no-store' });
      if (!answer.ok) throw new Error(answer.statusText);
      const state = await answer.json();
      version = state.version;
      if (version === 0) continue;
      showState(state);
      // A restarted command counts its pictures from 1 again.
      const name = `${state.run}-${state.picture}`;
      if (state.picture && name !== shown) {
        await showPicture(name);
        shown = name;
      }
    } catch {
      element('status').textContent = 'sfumato watch does not answer';
      version = 0;
      await new Promise((resolve) => setTimeout(resolve, 1000));
    }
  }
}
follow();
)page";

}  // namespace sfumato::cli::watch_page
