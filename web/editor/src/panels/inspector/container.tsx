// Layers, groups and instances: how they lie on what is below, and where.
import { setBlend, setOpacity } from "../../model/commands/index.js";
import type { ContainerItem, Item, UseItem } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { blendModes, blendName } from "../blend.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { openMenu } from "../controls/menu.js";
import { Select } from "../controls/select.js";
import { edits, mapped } from "../controls/sink.js";
import { Slider } from "../controls/slider.js";
import { decimal } from "../format.js";
import { settledOf } from "../layers/settled.js";
import { object } from "../menus/main.js";
import { useShell } from "../services.js";
import { AngleField, BoxFields } from "./box.js";
import { Section } from "./sections.js";

const words = en.panels;

/** Opacity and blend mode of anything that is laid on what is below it. */
export function Compositing({ item }: { readonly item: Item }) {
  const { editor } = useShell();
  const percent = item.opacity * 100;
  const sink = mapped(
    edits(editor, words.setOpacity, (value: number, before) =>
      setOpacity(before, item.handle, value),
    ),
    (value: number) => value / 100,
  );
  return (
    <>
      <div class="row">
        <span class="side-name wide-name" aria-hidden="true">
          {words.blend}
        </span>
        <Select
          grow
          label={words.blendMode}
          value={item.blend}
          mixed={blendName(item.blend)}
          choices={blendModes.map((mode) => ({ value: mode as string, label: blendName(mode) }))}
          onChange={(mode) =>
            void editor.run(words.setBlend, setBlend(editor.drawing, item.handle, mode))
          }
        />
      </div>
      <div class="row">
        <span class="side-name wide-name" aria-hidden="true">
          {words.opacity}
        </span>
        <Slider
          class="grow"
          label={words.opacity}
          value={percent}
          min={0}
          max={100}
          step={1}
          reset={100}
          text={words.percent(decimal(percent, 0))}
          sink={sink}
        />
        <NumberField
          class="narrow"
          name={words.opacityPercent}
          value={percent}
          digits={1}
          unit="%"
          min={0}
          max={100}
          sink={sink}
        />
      </div>
    </>
  );
}

function More({ item }: { readonly item: Item }) {
  const { editor } = useShell();
  return (
    <IconButton
      small
      icon="ellipsis"
      label={words.more}
      popup="menu"
      onClick={(event) => openMenu(words.moreOf(item.name), object(editor), event.currentTarget)}
    />
  );
}

export function ContainerSection({ item }: { readonly item: ContainerItem }) {
  const { editor } = useShell();
  const copies = settledOf(editor).uses.value.get(item.handle) ?? 0;
  const title = item.kind === "layer" ? words.layerTitle(item.name) : words.groupTitle(item.name);
  return (
    <Section
      title={title}
      badge={copies > 0 ? words.changesCopies(copies + 1) : undefined}
      actions={<More item={item} />}
    >
      <Compositing item={item} />
      <BoxFields items={[item]} />
    </Section>
  );
}

export function UseSection({ item }: { readonly item: UseItem }) {
  const { editor } = useShell();
  const { target } = item;
  return (
    <Section title={words.copyTitle(item.name)} actions={<More item={item} />}>
      <div class="row">
        <span class="grow">{target ? words.copyOf(target.name) : words.copyOfNothing}</span>
        {target && (
          <button
            type="button"
            class="button quiet"
            onClick={() => {
              editor.selection.value = [{ handle: target.handle, part: { kind: "whole" } }];
            }}
          >
            {words.goToOriginal}
          </button>
        )}
      </div>
      <Compositing item={item} />
      <BoxFields items={[item]} />
      <AngleField item={item} />
      {target && (
        <button type="button" class="button" onClick={() => editor.command("make-unique")}>
          {words.makeUnique}
        </button>
      )}
    </Section>
  );
}
