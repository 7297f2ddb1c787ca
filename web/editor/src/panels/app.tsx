// The shell of the editor: bars, tools, stage, panels, and what floats over them.
import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { useSignalEffect } from "@preact/signals";
import type { Editor } from "../app/types.js";
import { en } from "../strings/en.js";
import { isPhone } from "./controls/media.js";
import { Menus, openMenu } from "./controls/menu.js";
import { Tooltip } from "./controls/tooltip.js";
import { contextMenu } from "./menus/main.js";
import { ShellContext, useShell, type Services } from "./services.js";
import { Dialogs, HintRing, HintsDock, Picker, Tour, usePartsComplaint } from "./shell/part.js";
import { watchRegions } from "./shell/regions.js";
import { Sheet } from "./shell/sheet.js";
import { Side } from "./shell/side.js";
import { StatusBar } from "./shell/statusbar.js";
import { ToastView } from "./shell/toast.js";
import { Tools } from "./shell/tools.js";
import { TopBar } from "./shell/topbar.js";
import { useTourStart } from "./tour/start.js";
import { Welcome } from "./welcome/welcome.js";

/** Theme and surround stand on `<html>`, where tokens.css looks for them. */
function useAppearance() {
  const { theme, surround } = useShell().editor.settings;
  useSignalEffect(() => {
    const { dataset } = document.documentElement;
    if (theme.value === "system") delete dataset.theme;
    else dataset.theme = theme.value;
    dataset.surround = surround.value;
  });
}

function Announcer() {
  const { announcement } = useShell().editor;
  return (
    <div class="visually-hidden" aria-live="polite" role="status">
      {announcement.value}
    </div>
  );
}

/** The width that was not chosen is left to the style sheet. */
const CHOSEN_BY_NOBODY = 288;

function Workplace({ children }: { readonly children: ComponentChildren }) {
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

function Page({ stage }: { readonly stage: ComponentChildren }) {
  const { editor } = useShell();
  useAppearance();
  useTourStart();
  usePartsComplaint();
  useEffect(watchRegions, []);
  return (
    <>
      {editor.welcome.value ? <Welcome /> : <Workplace>{stage}</Workplace>}
      <Dialogs />
      <ToastView />
      <Menus />
      <Tooltip />
      <Announcer />
    </>
  );
}

/** The whole page. `stage`: what fills the middle; it finds its size by itself. */
export function App(props: {
  readonly editor: Editor;
  readonly services: Services;
  readonly stage: ComponentChildren;
}) {
  return (
    <ShellContext.Provider value={{ editor: props.editor, services: props.services }}>
      <Page stage={props.stage} />
    </ShellContext.Provider>
  );
}
