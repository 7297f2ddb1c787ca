// Options of the tool that is held, over the middle of the stage.
import { setNodeKind, type NodeKind } from "../../model/commands/index.js";
import * as en from "../../strings/en.js";
import type { IconName } from "../../icons.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { Segments } from "../controls/segments.js";
import { setting } from "../controls/sink.js";
import { nameOfCommand } from "../menus/names.js";
import { kindOfNodes, selectedNodes } from "../nodes.js";
import { useShell } from "../services.js";
import { CurveColor, Fill, PolygonOptions, StrokeColor } from "./fill.js";

const words = en.panels;

export function NodeKinds({ full }: { readonly full?: boolean }) {
  const { editor } = useShell();
  const nodes = selectedNodes(editor);
  if (nodes === null) return null;
  const choose = (kind: NodeKind) =>
    editor.run(
      words.nodeKind,
      setNodeKind(
        editor.drawing,
        nodes.item.handle,
        nodes.nodes,
        kind,
        editor.step(nodes.item),
      ),
    );
  return (
    <Segments
      label={words.nodeKind}
      full={full}
      value={kindOfNodes(nodes)}
      onChange={choose}
      choices={[
        {
          value: "corner",
          label: words.corner,
          icon: "node-corner",
          shows: "icon",
          command: "corner",
        },
        {
          value: "smooth",
          label: words.smooth,
          icon: "node-smooth",
          shows: "icon",
          command: "smooth",
        },
        {
          value: "symmetric",
          label: words.symmetric,
          icon: "node-symmetric",
          shows: "icon",
          command: "symmetric",
        },
      ]}
    />
  );
}

function Attributes() {
  const { editor } = useShell();
  return (
    <Segments
      label={words.showOnCurve}
      value={editor.attribute.value}
      onChange={(value) => {
        editor.attribute.value = value;
      }}
      choices={[
        {
          value: "color",
          label: words.attribute.color,
          icon: "palette",
          shows: "narrow",
          command: "show-color",
        },
        {
          value: "opacity",
          label: words.attribute.opacity,
          icon: "blend",
          shows: "narrow",
          command: "show-opacity",
        },
        {
          value: "blur",
          label: words.attribute.blur,
          icon: "focus",
          shows: "narrow",
          command: "show-blur",
        },
      ]}
    />
  );
}

/** Buttons that align, distribute and flip: a command, its icon, and how many objects it needs. */
const arrangers = [
  ["align-left", "align-start-vertical", 1],
  ["align-center", "align-center-vertical", 1],
  ["align-right", "align-end-vertical", 1],
  ["align-top", "align-start-horizontal", 1],
  ["align-middle", "align-center-horizontal", 1],
  ["align-bottom", "align-end-horizontal", 1],
  ["distribute-horizontally", "align-horizontal-distribute-center", 3],
  ["distribute-vertically", "align-vertical-distribute-center", 3],
  ["flip-horizontal", "flip-vertical-2", 1],
  ["flip-vertical", "flip-horizontal-2", 1],
] as const satisfies readonly (readonly [string, IconName, number])[];

function Align() {
  const { editor } = useShell();
  const chosen = new Set(editor.selection.value.map(({ handle }) => handle)).size;
  return (
    <div class="row align">
      {arrangers.map(([command, icon, least]) => (
        <IconButton
          key={command}
          icon={icon}
          label={nameOfCommand(command)}
          command={command}
          disabled={chosen < least}
        />
      ))}
      <IconButton
        icon="frame"
        label={words.alignToArtboard}
        command="align-to-artboard"
        pressed={editor.settings.alignToArtboard.value}
      />
    </div>
  );
}

function Smoothing() {
  const { smoothing } = useShell().editor.settings;
  return (
    <NumberField
      class="option"
      label={words.smoothing}
      value={smoothing.value}
      min={0.5}
      max={8}
      step={0.5}
      digits={1}
      unit="px"
      sink={setting(smoothing)}
    />
  );
}

function StrokeOptions() {
  const { strokeRadius } = useShell().editor.settings;
  return (
    <>
      <NumberField
        class="option"
        label={words.strokeRadius}
        value={strokeRadius.value}
        min={0.1}
        max={10000}
        step={1}
        digits={1}
        sink={setting(strokeRadius)}
      />
      <Smoothing />
      <StrokeColor />
    </>
  );
}

function SampleOptions() {
  const { editor } = useShell();
  const { sampleDistance, sampleTolerance } = editor.settings;
  return (
    <>
      <NumberField
        class="option"
        label={words.sampleDistance}
        value={sampleDistance.value}
        min={1}
        max={12}
        step={1}
        digits={0}
        unit="px"
        sink={setting(sampleDistance)}
      />
      <NumberField
        class="option"
        label={words.sampleTolerance}
        value={sampleTolerance.value}
        min={0.002}
        max={0.2}
        step={0.005}
        digits={3}
        sink={setting(sampleTolerance)}
      />
      <SampleBlur class="option" />
    </>
  );
}

const options = {
  select: Align,
  nodes: () => (
    <>
      <NodeKinds />
      <Attributes />
    </>
  ),
  pen: () => (
    <>
      <Attributes />
      <CurveColor />
    </>
  ),
  pencil: () => (
    <>
      <Smoothing />
      <CurveColor />
    </>
  ),
  stroke: StrokeOptions,
  rectangle: Fill,
  ellipse: Fill,
  polygon: PolygonOptions,
  sample: SampleOptions,
  blur: () => null,
  hand: () => null,
} as const;

export function ToolOptions() {
  const { editor } = useShell();
  const Options = options[editor.tool.value];
  return (
    <div class="options" role="group" aria-label={words.toolOptions}>
      <Options />
      <span class="bar-line" />
      <IconButton
        icon="scan-line"
        label={words.outlines}
        command="outlines"
        pressed={editor.showOutlines.value}
      />
      <IconButton
        icon="image"
        label={words.reference}
        command="reference"
        pressed={editor.showReference.value}
      />
    </div>
  );
}

/** Whether the width of the photo's transition is taken, too. */
export function SampleBlur(props: { readonly class?: string }) {
  const { sampleBlur } = useShell().editor.settings;
  return (
    <label class={props.class ? `check ${props.class}` : "check"}>
      <input
        type="checkbox"
        checked={sampleBlur.value}
        onChange={() => {
          sampleBlur.value = !sampleBlur.value;
        }}
      />
      <span>{words.sampleBlur}</span>
    </label>
  );
}
