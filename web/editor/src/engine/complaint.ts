// The engine's errors as readable text.
import * as en from "../strings/en.js";
import { EngineError } from "./rpc.js";

/** A warning of the library, with its line in words. */
export function warningText(warning: string): string {
  const [, line, column, reason] = /^[^:]*:(\d+):(\d+): ([^]*)$/.exec(warning) ?? [];
  return reason === undefined ? warning : en.engine.reasonAt(Number(line), Number(column), reason);
}

/** Why a call failed, with the line where it is known. */
export function complaintOf(error: unknown): string {
  if (error instanceof EngineError) {
    const { line, column, reason } = error;
    return line > 0 ? en.engine.reasonAt(line, column, reason) : reason;
  }
  return error instanceof Error ? error.message : String(error);
}
