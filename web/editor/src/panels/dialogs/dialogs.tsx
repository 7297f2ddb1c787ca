// The dialog that is open.
import { useShell } from "../services.js";
import { AboutDialog } from "./about.js";
import { CommandsDialog } from "./commands.js";
import { DocumentDialog } from "./document.js";
import { ExportDialog } from "./export.js";
import { ForeignDialog } from "./foreign.js";
import { GuidesDialog } from "./guides.js";
import { KeysDialog } from "./keys.js";
import { NewDialog } from "./new.js";
import { ProblemDialog } from "./problem.js";
import { RecoverDialog } from "./recover.js";
import { TraceDialog } from "./trace.js";

const dialogs = {
  about: AboutDialog,
  commands: CommandsDialog,
  document: DocumentDialog,
  export: ExportDialog,
  foreign: ForeignDialog,
  guides: GuidesDialog,
  keys: KeysDialog,
  new: NewDialog,
  problem: ProblemDialog,
  recover: RecoverDialog,
  trace: TraceDialog,
} as const;

export function Dialogs() {
  const dialog = useShell().editor.dialog.value;
  if (!dialog) return null;
  const Shown = dialogs[dialog.kind];
  return <Shown key={dialog.kind} />;
}
