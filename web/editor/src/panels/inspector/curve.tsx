// The fields of a single curve or local stroke: colours, blur or radius, opacity, node, weight.
import { sidesInOrder } from "../../model/sides.js";
import type { CurveItem } from "../../model/types.js";
import { setNumber } from "../../model/commands/index.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { openMenu } from "../controls/menu.js";
import { edits } from "../controls/sink.js";
import { object } from "../menus/main.js";
import { useShell } from "../services.js";
import { AngleField, BoxFields } from "./box.js";
import { numberOf } from "./numbers.js";
import { BlurSection, RadiusSection } from "./blur.js";
import { Compositing } from "./container.js";
import { NodeSection } from "./node.js";
import { OpacitySection } from "./opacity.js";
import { Section } from "./sections.js";
import { ColorSide } from "./side.js";
import { StopRow } from "./stoprow.js";

const words = en.panels;

function Head({ item }: { readonly item: CurveItem }) {
  const { editor } = useShell();
  return (
    <>
      <IconButton small icon="arrow-up-down" label={words.swapSides} command="swap-sides" />
      <IconButton
        small
        icon="ellipsis"
        label={words.more}
        popup="menu"
        onClick={(event) => openMenu(words.moreOf(item.name), object(editor), event.currentTarget)}
      />
    </>
  );
}

function Weight({ item }: { readonly item: CurveItem }) {
  const { editor } = useShell();
  const name = item.kind === "stroke" ? "alpha" : "weight";
  const value = numberOf(item, name);
  const scale = name === "alpha" ? 100 : 1;
  return (
    <Section title={words[name]}>
      <div class="two">
        <NumberField
          name={words[name]}
          tip={name === "weight" ? words.weightTip : undefined}
          value={value * scale}
          digits={name === "alpha" ? 0 : 2}
          unit={name === "alpha" ? "%" : undefined}
          min={name === "alpha" ? 0 : 0.01}
          max={1000}
          step={name === "alpha" ? 1 : 0.1}
          sink={edits(editor, name === "weight" ? words.setWeight : words.setStrength, (to: number, before) =>
            setNumber(before, [item.handle], name, to === scale ? null : to / scale),
          )}
        />
      </div>
    </Section>
  );
}

/** Else it is called after what it is. */
const hasOwnName = ({ element }: CurveItem) =>
  element.attributes.some(({ name, local }) => name === "id" || local === "label");

export function CurveSections({ item }: { readonly item: CurveItem }) {
  const titled = item.kind === "stroke" ? words.strokeTitle : words.curveTitle;
  return (
    <>
      <Section
        title={hasOwnName(item) ? titled(item.name) : item.name}
        badge={item.copies > 1 ? words.changesCopies(item.copies) : undefined}
        actions={<Head item={item} />}
      >
        {sidesInOrder(item).map((side) => (
          <ColorSide key={side} item={item} side={side} />
        ))}
        <StopRow item={item} />
      </Section>
      {item.kind === "stroke" ? <RadiusSection item={item} /> : <BlurSection item={item} />}
      {item.kind === "stroke" ? <BlurSection item={item} /> : <OpacitySection item={item} />}
      <NodeSection />
      <Weight item={item} />
      <Section title={words.placeAndSize}>
        <BoxFields items={[item]} />
        <AngleField item={item} />
      </Section>
      {item.kind === "stroke" && (
        <Section title={words.onPicture}>
          <Compositing item={item} />
        </Section>
      )}
    </>
  );
}
