// The page: the first of all, then the workplace, and what floats over them.
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { useSignalEffect, type ReadonlySignal } from "@preact/signals";
import type { Editor } from "../app/types.js";
import { Tooltip } from "./controls/tooltip.js";
import { ShellContext, useShell, type Beginnings, type Services } from "./services.js";
import { Dialogs, usePartsComplaint } from "./shell/part.js";
import { watchRegions } from "./shell/regions.js";
import { ToastView } from "./shell/toast.js";
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

/** The parts that follow the first page: the workplace, everything that floats over it, and their services. */
export interface Later {
  readonly services: Services;
  readonly Workplace: ComponentType;
  readonly Menus: ComponentType;
}

interface AppProps extends Beginnings {
  readonly editor: Editor;
  /** null: it is on its way. */
  readonly later: ReadonlySignal<Later | null>;
  /** Whether a drawing is about to replace the first page. */
  readonly isReturning: ReadonlySignal<boolean>;
}

function Page({ later, isReturning, ...beginnings }: Omit<AppProps, "editor">) {
  const { editor } = useShell();
  useAppearance();
  usePartsComplaint();
  useEffect(watchRegions, []);
  const { Workplace = Nothing, Menus = Nothing } = later.value ?? {};
  return (
    <>
      {!editor.welcome.value ? <Workplace /> : !isReturning.value && <Welcome {...beginnings} />}
      <Dialogs />
      <ToastView />
      <Menus />
      <Tooltip />
      <Announcer />
    </>
  );
}

const Nothing = () => null;

/** The whole page. */
export function App({ editor, ...props }: AppProps) {
  const shell = {
    editor,
    get services() {
      return props.later.peek()!.services;
    },
  };
  return (
    <ShellContext.Provider value={shell}>
      <Page {...props} />
    </ShellContext.Provider>
  );
}
