// The upper panel: what is selected, else the document.
import type { Item } from "../../model/types.js";
import { useShell } from "../services.js";
import { ContainerSection, UseSection } from "./container.js";
import { CurveSections } from "./curve.js";
import { DocumentSections } from "./document.js";
import { ReferenceSections } from "./reference.js";
import { SeveralSections } from "./several.js";

function One({ item }: { readonly item: Item }) {
  switch (item.kind) {
    case "curve":
    case "stroke":
      return <CurveSections item={item} />;
    case "layer":
    case "group":
      return <ContainerSection item={item} />;
    case "use":
      return <UseSection item={item} />;
    case "reference":
      return <ReferenceSections item={item} />;
  }
}

export function Inspector() {
  const { editor } = useShell();
  const { drawing } = editor;
  const handles = new Set(editor.selection.value.map(({ handle }) => handle));
  const items = [...handles].flatMap((handle) => drawing.item(handle) ?? []);
  if (items.length === 0) return <DocumentSections />;
  // Fields of one item must not take over text typed for another.
  if (items.length === 1) return <One key={items[0].handle} item={items[0]} />;
  return <SeveralSections items={items} />;
}
