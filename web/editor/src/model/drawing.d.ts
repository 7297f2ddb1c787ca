// contract
import type { Drawing } from "./types.js";

/** Reads a text. @throws SourceError where it is no XML, or no <svg> */
export function openDrawing(text: string): Drawing;

/** The text of a drawing without curves. @param background null: none */
export function blankText(width: number, height: number, background: string | null): string;
