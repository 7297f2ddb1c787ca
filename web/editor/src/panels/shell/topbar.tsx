// The bar above: menu, file, history, the tool's options, what concerns the whole.
import type { FileState } from "../../app/types.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { isPhone } from "../controls/media.js";
import { openMenu } from "../controls/menu.js";
import { mainMenu } from "../menus/main.js";
import { useShell } from "../services.js";
import { ToolOptions } from "./options.js";

const words = en.panels;

/** Where the drawing is safe, or why it is not. */
function wordsOf({ isChanged, kept, lost = "refused", isWaiting }: FileState): string {
  if (kept === "nowhere") return isChanged ? words.kept[lost] : "";
  if (isWaiting) return words.saving;
  return kept === "file" && isChanged ? words.unsaved : words.kept[kept];
}

function FileName() {
  const { editor } = useShell();
  const { name, isChanged, kept } = editor.file.value;
  const isLost = isChanged && kept === "nowhere";
  return (
    <h1 class="file">
      <button
        type="button"
        class="file-name"
        data-tip={words.document}
        onClick={() => editor.command("document")}
      >
        {name}
      </button>
      <span class={isLost ? "saved warn" : "muted saved"}>{wordsOf(editor.file.value)}</span>
    </h1>
  );
}

function History() {
  const { editor } = useShell();
  const undo = editor.undoLabel.value;
  const redo = editor.redoLabel.value;
  return (
    <div class="history">
      <IconButton
        icon="undo-2"
        label={undo === null ? words.undo : words.undoOf(undo)}
        command="undo"
        disabled={undo === null}
      />
      <IconButton
        icon="redo-2"
        label={redo === null ? words.redo : words.redoOf(redo)}
        command="redo"
        disabled={redo === null}
      />
    </div>
  );
}

/** The other of light and dark than what is seen now. */
function toggleTheme(theme: { value: "system" | "light" | "dark" }) {
  const isDark =
    theme.value === "system"
      ? matchMedia("(prefers-color-scheme: dark)").matches
      : theme.value === "dark";
  theme.value = isDark ? "light" : "dark";
}

export function TopBar() {
  const { editor } = useShell();
  return (
    <header class="topbar" data-region>
      <IconButton
        icon="menu"
        label={words.menu}
        popup="menu"
        onClick={(event) =>
          openMenu(words.menu, mainMenu(editor, isPhone().value), event.currentTarget)
        }
      />
      <FileName />
      <History />
      <ToolOptions />
      <div class="bar-end">
        <IconButton
          class="theme"
          icon="contrast"
          label={words.theme}
          onClick={() => toggleTheme(editor.settings.theme)}
        />
        <IconButton class="keys-link" icon="keyboard" label={words.keys} command="keys" />
        <button type="button" class="button primary" onClick={() => editor.command("export")}>
          {words.export}
        </button>
      </div>
    </header>
  );
}
