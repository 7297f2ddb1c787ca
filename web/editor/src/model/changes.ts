// The effect of a change of some attributes.
import { SFUMATO } from "../source/attributes.js";
import type { Attribute } from "../source/nodes.js";

/** Attributes without a namespace on which more hangs than their element. */
const STRUCTURAL: ReadonlySet<string> = new Set(["id", "class", "style", "href"]);
/** Sfumato's attributes that decide which kind of item an element is. */
const DECIDING: ReadonlySet<string> = new Set(["diffuse", "radius", "reference"]);

/** Returns the changes between two sets of attributes of one element. */
export function changedAttributes(
  before: readonly Attribute[],
  now: readonly Attribute[],
): Attribute[] {
  const isLacking = (among: readonly Attribute[]) => (one: Attribute) =>
    !among.some(
      (a) => a.name === one.name && a.namespace === one.namespace && a.value === one.value,
    );
  return [...before.filter(isLacking(now)), ...now.filter(isLacking(before))];
}

/** Whether more hangs on an attribute that changed than its element. */
export function isStructural(
  { namespace, local }: Attribute,
  before: readonly Attribute[],
  now: readonly Attribute[],
): boolean {
  if (namespace === SFUMATO) {
    const isThere = (a: Attribute) => a.namespace === SFUMATO && a.local === local;
    // A radius that stays a radius decides nothing.
    const isKept = local === "radius" && before.some(isThere) && now.some(isThere);
    return DECIDING.has(local) && !isKept;
  }
  return STRUCTURAL.has(local);
}
