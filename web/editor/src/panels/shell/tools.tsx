// The tools: a radio group, upright at the left, in a row on phones.
import { Fragment } from "preact";
import type { ToolName } from "../../app/types.js";
import { Icon, type IconName } from "../../icons.js";
import * as en from "../../strings/en.js";
import { useTip } from "../controls/button.js";
import { ariaChord } from "../controls/chords.js";
import { radioKeys } from "../controls/radio.js";
import { useShell } from "../services.js";

const words = en.panels;

const groups: readonly (readonly [ToolName, IconName][])[] = [
  [
    ["select", "mouse-pointer-2"],
    ["nodes", "spline"],
  ],
  [
    ["pen", "pen-tool"],
    ["pencil", "pencil"],
    ["stroke", "brush"],
  ],
  [
    ["rectangle", "square"],
    ["ellipse", "circle"],
    ["polygon", "hexagon"],
  ],
  [
    ["sample", "pipette"],
    ["blur", "focus"],
  ],
  [["hand", "hand"]],
];

function Tool({ name, icon }: { readonly name: ToolName; readonly icon: IconName }) {
  const { editor } = useShell();
  const isOn = editor.tool.value === name;
  return (
    <button
      type="button"
      class="tool"
      role="radio"
      data-tool={name}
      aria-checked={isOn}
      tabIndex={isOn ? 0 : -1}
      {...useTip(words.tool[name], `tool-${name}`)}
      aria-label={words.tool[name]}
      aria-keyshortcuts={ariaChord(`tool-${name}`)}
      onClick={() => {
        editor.tool.value = name;
      }}
    >
      <Icon name={icon} />
      <span class="tool-name">{words.tool[name]}</span>
    </button>
  );
}

export function Tools() {
  return (
    <nav class="toolbar" aria-label={words.tools} data-region>
      <div class="tools" role="radiogroup" aria-label={words.tools} onKeyDown={radioKeys()}>
        {groups.map((group, index) => (
          <Fragment key={index}>
            {index > 0 && <span class="tool-gap" role="presentation" />}
            {group.map(([name, icon]) => (
              <Tool key={name} name={name} icon={icon} />
            ))}
          </Fragment>
        ))}
      </div>
    </nav>
  );
}
