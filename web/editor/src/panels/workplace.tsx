// Where one works: bars, tools, stage, panels.
import type { ComponentChildren } from "preact";
import * as en from "../strings/en.js";
import { isPhone } from "./controls/media.js";
import { openMenu } from "./controls/menu.js";
import { contextMenu } from "./menus/main.js";
import { useShell } from "./services.js";
import { HintRing, HintsDock, Picker, Tour } from "./shell/part.js";
import { Isolation } from "./shell/isolation.js";
import { Sheet } from "./shell/sheet.js";
import { Side } from "./shell/side.js";
import { StatusBar } from "./shell/statusbar.js";
import { Tools } from "./shell/tools.js";
import { TopBar } from "./shell/topbar.js";

/** The width that was not chosen is left to the style sheet. */
const CHOSEN_BY_NOBODY = 288;

/** `children`: the content of the middle; it determines its own size. */
export function Workplace({ children }: { readonly children: ComponentChildren }) {
  const { editor } = useShell();
  const width = editor.settings.panelWidth.value;
  const phone = isPhone().value;
  return (
    <div
      class="app"
      data-tour={editor.tour.value ?? undefined}
      style={width === CHOSEN_BY_NOBODY ? undefined : { "--panel": `${width}px` }}
    >
      <TopBar />
      <Tools />
      <div class="center">
        <main
          class="stage"
          aria-label={en.panels.canvas}
          data-region
          onContextMenu={(event) => {
            event.preventDefault();
            openMenu(en.panels.object, contextMenu(editor), { x: event.clientX, y: event.clientY });
          }}
        >
          {children}
          <HintRing />
          <Isolation />
        </main>
        {!phone && <HintsDock />}
      </div>
      {phone ? <Sheet /> : <Side />}
      {!phone && <StatusBar />}
      <Picker />
      <Tour />
    </div>
  );
}
