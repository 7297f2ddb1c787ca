'use strict';
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
