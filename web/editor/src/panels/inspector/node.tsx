// The node that is chosen: where it is, of what kind.
import { mapped, inverted, type Point } from "../../geometry/affine.js";
import { nodeCount } from "../../geometry/cubic.js";
import { nodePath } from "../../geometry/natural.js";
import { moveNodes } from "../../model/commands/index.js";
import * as en from "../../strings/en.js";
import { NumberField } from "../controls/field.js";
import { edits } from "../controls/sink.js";
import { selectedNodes } from "../nodes.js";
import { useShell } from "../services.js";
import { NodeKinds } from "../shell/options.js";
import { Section } from "./sections.js";

const words = en.panels;

export function NodeSection() {
  const { editor } = useShell();
  const nodes = selectedNodes(editor);
  if (!nodes) return null;
  const { item, path, index } = nodes;
  const local = nodePath(item.paths[path]).points[3 * index];
  const at = mapped(item.artboardFromItem, local);
  const back = inverted(item.artboardFromItem);
  const coordinate = (axis: 0 | 1) =>
    edits(editor, words.moveNode, (value: number, before) => {
      if (!back) return null;
      const wanted: Point = axis === 0 ? [value, at[1]] : [at[0], value];
      const to = mapped(back, wanted);
      return moveNodes(
        before,
        item.handle,
        nodes.nodes,
        [to[0] - local[0], to[1] - local[1]],
        editor.step(item),
      );
    });
  const countOf = (subpath: number) => nodeCount(nodePath(item.paths[subpath]));
  const all = [...nodes.nodes.keys()].reduce((sum, subpath) => sum + countOf(subpath), 0);
  const title =
    nodes.count > 1
      ? words.nodesTitle(nodes.count, all)
      : words.nodeTitle(index + 1, countOf(path));
  return (
    <Section title={title}>
      <div class="two">
        <NumberField
          label="X"
          name={words.nodeX}
          value={at[0]}
          digits={2}
          disabled={!back}
          sink={coordinate(0)}
        />
        <NumberField
          label="Y"
          name={words.nodeY}
          value={at[1]}
          digits={2}
          disabled={!back}
          sink={coordinate(1)}
        />
      </div>
      <NodeKinds full />
    </Section>
  );
}
