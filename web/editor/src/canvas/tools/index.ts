// All tools by their names.
import type { ToolName } from "../../app/types.js";
import type { Canvas } from "../canvas.js";
import { BlurTool } from "./blur.js";
import { HandTool } from "./hand.js";
import { NodesTool } from "./nodes.js";
import { PenTool } from "./pen.js";
import { PencilTool } from "./pencil.js";
import { SampleTool } from "./sample.js";
import { SelectTool } from "./select.js";
import { ShapeTool } from "./shape.js";
import { StrokeTool } from "./stroke.js";
import type { Tool } from "./tool.js";

export function makeTools(canvas: Canvas): Readonly<Record<ToolName, Tool>> {
  return {
    select: new SelectTool(canvas),
    nodes: new NodesTool(canvas),
    pen: new PenTool(canvas),
    pencil: new PencilTool(canvas),
    stroke: new StrokeTool(canvas),
    rectangle: new ShapeTool(canvas, "rectangle"),
    ellipse: new ShapeTool(canvas, "ellipse"),
    polygon: new ShapeTool(canvas, "polygon"),
    sample: new SampleTool(canvas),
    blur: new BlurTool(canvas),
    hand: new HandTool(canvas),
  };
}
