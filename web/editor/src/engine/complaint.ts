// What the engine says, as people read it.
import { en } from "../strings/en.js";
import { EngineError } from "./rpc.js";

/** Why a call failed, with the line where it is known. */
export function complaintOf(error: unknown): string {
  if (error instanceof EngineError) {
    const { line, column, reason } = error;
    return line > 0 ? en.dialogs.reasonAt(line, column, reason) : reason;
  }
  return error instanceof Error ? error.message : String(error);
}
