// Blur along both sides of a curve, and the radius of a local stroke.
import { useSignal } from "@preact/signals";
import { nameOfSide } from "../../app/side-names.js";
import { setBoth, setNumbers, setRadius } from "../../model/commands/index.js";
import { sidesInOrder } from "../../model/sides.js";
import type { CurveItem, Drawing, Outcome, Side, SideValue } from "../../model/types.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { edits } from "../controls/sink.js";
import { decimal } from "../format.js";
import { useShell } from "../services.js";
import { fractionOf, movedStop, offsetAt, withValue, type Stops } from "../stops.js";
import { chosenStop, type ChosenStop } from "./chosen.js";
import { Profile, radiiOf } from "./profile.js";
import { Section } from "./sections.js";

const words = en.panels;

const same = (a: SideValue<number>, b: SideValue<number>) =>
  JSON.stringify(radiiOf(a)) === JSON.stringify(radiiOf(b));

type Put = (before: Drawing, side: Side, value: SideValue<number>) => Outcome | null;

interface FieldsProps {
  readonly item: CurveItem;
  readonly list: Stops<number>;
  readonly chosen: ChosenStop;
  readonly label: string;
  readonly least: number;
  readonly put: Put;
}

/** Radius and place of the chosen point. */
function Fields({ item, list, chosen, label, least, put }: FieldsProps) {
  const { editor } = useShell();
  const { side, index } = chosen;
  const stop = list.stops[index];
  const fraction = fractionOf(item, list.space, stop.offset);
  return (
    <div class="two">
      <NumberField
        label={words.radius}
        name={words.radiusOfPoint(label, index + 1)}
        value={stop.value}
        digits={2}
        min={least}
        sink={edits(editor, words.moveRadius, (value: number, before) =>
          put(before, side, withValue(list, index, value)),
        )}
      />
      <NumberField
        label={words.at}
        name={words.placeOfPoint(label, index + 1)}
        value={fraction * 100}
        digits={1}
        unit="%"
        min={0}
        max={100}
        sink={edits(editor, words.moveRadius, (percent: number, before) =>
          put(
            before,
            side,
            movedStop(list, index, offsetAt(item, list.space, percent / 100)).value,
          ),
        )}
      />
    </div>
  );
}

const summary = (list: Stops<number>) =>
  list.stops.map(({ value }) => decimal(value, 2)).join(", ");

/** The point whose fields stand below: the chosen one where it still is, else the first. */
function current(
  chosen: ChosenStop | null,
  lists: Readonly<Record<Side, Stops<number>>>,
  first: Side,
): ChosenStop {
  return chosen && chosen.index < lists[chosen.side].stops.length
    ? chosen
    : { side: first, index: 0 };
}

export function BlurSection({ item }: { readonly item: CurveItem }) {
  const { editor } = useShell();
  const sides = sidesInOrder(item);
  const left = item.left.blur;
  const right = item.right.blur;
  /** Sides that differ cannot be linked; equal ones are, until somebody parts them. */
  const parted = useSignal<number | null>(null);
  const isLocal = item.kind === "stroke";
  const linked = isLocal || (same(left, right) && parted.value !== item.handle);
  const put: Put = (before, side, value) =>
    linked
      ? setBoth(before, item.handle, "blur", value)
      : setNumbers(before, item.handle, side, "blur", value);
  const lists = { left: radiiOf(left), right: radiiOf(right) };
  const chosen = chosenStop(editor, item, "blur");
  const link = () => {
    if (linked) {
      parted.value = item.handle;
      return;
    }
    parted.value = null;
    const side = chosen?.side ?? sides[0];
    editor.run(words.linkBlur, setBoth(editor.drawing, item.handle, "blur", item[side].blur));
  };
  const at = current(chosen, lists, linked ? "left" : sides[0]);
  const label = linked ? words.blur : `${words.blur}, ${nameOfSide(item, at.side)}`;
  return (
    <Section
      title={words.blur}
      actions={
        isLocal ? undefined : (
          <IconButton
            small
            icon={linked ? "link-2" : "unlink-2"}
            label={words.bothAlike}
            pressed={linked}
            onClick={link}
          />
        )
      }
    >
      <Profile
        item={item}
        attribute="blur"
        left={left}
        right={linked ? left : right}
        linked={linked}
        label={
          linked
            ? words.blurAlong(summary(lists.left))
            : words.blurOfSides(sides.map((side) => [nameOfSide(item, side), summary(lists[side])]))
        }
        chosen={chosen}
        put={put}
      />
      <Fields item={item} list={lists[at.side]} chosen={at} label={label} least={0} put={put} />
    </Section>
  );
}

export function RadiusSection({ item }: { readonly item: CurveItem }) {
  const { editor } = useShell();
  const list = radiiOf(item.radius);
  const put: Put = (before, _side, value) => setRadius(before, item.handle, value);
  const chosen = chosenStop(editor, item, "radius");
  return (
    <Section title={words.radius}>
      <Profile
        item={item}
        attribute="radius"
        left={item.radius}
        right={item.radius}
        linked
        label={words.radiusAlong(summary(list))}
        chosen={chosen}
        put={put}
      />
      <Fields
        item={item}
        list={list}
        chosen={current(chosen, { left: list, right: list }, "left")}
        label={words.radius}
        least={0}
        put={put}
      />
    </Section>
  );
}
