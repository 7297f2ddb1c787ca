// Parts of the page whose code comes in a file of its own: nothing until it is there.
import { signal, useSignalEffect } from "@preact/signals";
import { h, type Attributes, type ComponentProps, type FunctionComponent } from "preact";
import * as en from "../../strings/en.js";
import { useShell } from "../services.js";

type Parts = typeof import("../parts.js");

const parts = signal<Parts | null>(null);
const isMissing = signal(false);

/**
 * Fetches the parts once, after the page has started; usePartsComplaint() reports a failure. @param before
 * what they need first
 */
export async function fetchParts(before: Promise<unknown>): Promise<void> {
  try {
    const [fetched] = await Promise.all([import("../parts.js"), before]);
    parts.value = fetched;
  } catch {
    isMissing.value = true;
  }
}

function part<Name extends keyof Parts>(name: Name) {
  type Props = ComponentProps<Parts[Name]> & Attributes;
  return function Part(props: Props) {
    const found = parts.value?.[name] as FunctionComponent<Props> | undefined;
    return found ? h(found, props) : null;
  };
}

export const Dialogs = part("Dialogs");
export const HintList = part("HintList");
export const HintRing = part("HintRing");
export const HintsDock = part("HintsDock");
export const Inspector = part("Inspector");
export const LayersPanel = part("LayersPanel");
export const Picker = part("Picker");
export const Tour = part("Tour");

/** Reports that parts are missing: once, and again where one is requested, which is then given up. */
export function usePartsComplaint() {
  const { editor } = useShell();
  useSignalEffect(() => {
    if (!isMissing.value) return;
    for (const asked of [editor.dialog, editor.picker, editor.tour]) {
      if (asked.value !== null) asked.value = null;
    }
    editor.say(en.page.partsMissing);
  });
}
