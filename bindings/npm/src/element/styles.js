// The styles of the element's shadow root. Content policies forbid inline styles, but not a constructed sheet.
const text = `
:host { display: inline-block; position: relative; overflow: hidden; width: 300px; aspect-ratio: 3 / 2; }
:host([hidden]) { display: none; }
:host(:focus-visible) { outline: 2px solid Highlight; outline-offset: 2px; }
canvas, #input, #box, slot { position: absolute; inset: 0; width: 100%; height: 100%; }
slot { display: block; }
#box { visibility: hidden; pointer-events: none; }
#input { outline: none; }
[hidden] { display: none !important; }
::slotted(img) { display: block; width: 100%; height: 100%; object-fit: contain; }
#input { cursor: grab; touch-action: pan-x pan-y; -webkit-user-select: none; user-select: none; }
#input:active { cursor: grabbing; }
#hint {
  position: absolute; inset: auto 0 0; margin: 0; padding: .4em .8em; pointer-events: none; text-align: center;
  font: 14px/1.4 system-ui, sans-serif; color: #fff; background: #000b; opacity: 0; transition: opacity .15s;
}
#hint.shown { opacity: 1; }
#paper { display: none; }
img[loading] { position: absolute; width: 0; height: 0; }
@media (prefers-reduced-motion: reduce) { #hint { transition: none; } }
@media print {
  #hint, #input { display: none; }
  #paper { display: block; position: absolute; inset: 0; width: 100%; height: 100%; object-fit: contain; }
  #paper ~ canvas, #paper ~ slot { display: none; }
}`;

/** @type {CSSStyleSheet | null} */
let sheet = null;

/** @param {ShadowRoot} root */
export function dress(root) {
  // jsdom has no constructed sheets, and lays nothing out.
  if (!("replaceSync" in CSSStyleSheet.prototype)) return;
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
  }
  root.adoptedStyleSheets = [sheet];
}
