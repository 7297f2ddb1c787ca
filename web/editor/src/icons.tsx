// Icons of lucide (ISC; each file keeps its notice), imported one by one, and three of our own.
import alignCenterVertical from "lucide-static/icons/align-center-vertical.svg?raw";
import alignEndVertical from "lucide-static/icons/align-end-vertical.svg?raw";
import alignStartVertical from "lucide-static/icons/align-start-vertical.svg?raw";
import alignCenterHorizontal from "lucide-static/icons/align-center-horizontal.svg?raw";
import alignEndHorizontal from "lucide-static/icons/align-end-horizontal.svg?raw";
import alignStartHorizontal from "lucide-static/icons/align-start-horizontal.svg?raw";
import alignHorizontalDistributeCenter from "lucide-static/icons/align-horizontal-distribute-center.svg?raw";
import alignVerticalDistributeCenter from "lucide-static/icons/align-vertical-distribute-center.svg?raw";
import arrowUpDown from "lucide-static/icons/arrow-up-down.svg?raw";
import blend from "lucide-static/icons/blend.svg?raw";
import brush from "lucide-static/icons/brush.svg?raw";
import check from "lucide-static/icons/check.svg?raw";
import chevronDown from "lucide-static/icons/chevron-down.svg?raw";
import chevronRight from "lucide-static/icons/chevron-right.svg?raw";
import chevronUp from "lucide-static/icons/chevron-up.svg?raw";
import circle from "lucide-static/icons/circle.svg?raw";
import circleAlert from "lucide-static/icons/circle-alert.svg?raw";
import component from "lucide-static/icons/component.svg?raw";
import contrast from "lucide-static/icons/contrast.svg?raw";
import copy from "lucide-static/icons/copy.svg?raw";
import ellipsis from "lucide-static/icons/ellipsis.svg?raw";
import eye from "lucide-static/icons/eye.svg?raw";
import eyeOff from "lucide-static/icons/eye-off.svg?raw";
import filePlus2 from "lucide-static/icons/file-plus-2.svg?raw";
import flipHorizontal2 from "lucide-static/icons/flip-horizontal-2.svg?raw";
import flipVertical2 from "lucide-static/icons/flip-vertical-2.svg?raw";
import focus from "lucide-static/icons/focus.svg?raw";
import folder from "lucide-static/icons/folder.svg?raw";
import folderOpen from "lucide-static/icons/folder-open.svg?raw";
import folderPlus from "lucide-static/icons/folder-plus.svg?raw";
import frame from "lucide-static/icons/frame.svg?raw";
import gripVertical from "lucide-static/icons/grip-vertical.svg?raw";
import hand from "lucide-static/icons/hand.svg?raw";
import hexagon from "lucide-static/icons/hexagon.svg?raw";
import image from "lucide-static/icons/image.svg?raw";
import imagePlus from "lucide-static/icons/image-plus.svg?raw";
import info from "lucide-static/icons/info.svg?raw";
import keyboard from "lucide-static/icons/keyboard.svg?raw";
import layers from "lucide-static/icons/layers.svg?raw";
import link2 from "lucide-static/icons/link-2.svg?raw";
import loaderCircle from "lucide-static/icons/loader-circle.svg?raw";
import lock from "lucide-static/icons/lock.svg?raw";
import lockOpen from "lucide-static/icons/lock-open.svg?raw";
import menu from "lucide-static/icons/menu.svg?raw";
import mousePointer2 from "lucide-static/icons/mouse-pointer-2.svg?raw";
import palette from "lucide-static/icons/palette.svg?raw";
import penTool from "lucide-static/icons/pen-tool.svg?raw";
import pencil from "lucide-static/icons/pencil.svg?raw";
import pipette from "lucide-static/icons/pipette.svg?raw";
import play from "lucide-static/icons/play.svg?raw";
import plus from "lucide-static/icons/plus.svg?raw";
import redo2 from "lucide-static/icons/redo-2.svg?raw";
import scanLine from "lucide-static/icons/scan-line.svg?raw";
import search from "lucide-static/icons/search.svg?raw";
import spline from "lucide-static/icons/spline.svg?raw";
import square from "lucide-static/icons/square.svg?raw";
import trash2 from "lucide-static/icons/trash-2.svg?raw";
import triangleAlert from "lucide-static/icons/triangle-alert.svg?raw";
import undo2 from "lucide-static/icons/undo-2.svg?raw";
import unlink2 from "lucide-static/icons/unlink-2.svg?raw";
import x from "lucide-static/icons/x.svg?raw";

const lucide = {
  "align-center-vertical": alignCenterVertical,
  "align-end-vertical": alignEndVertical,
  "align-start-vertical": alignStartVertical,
  "align-center-horizontal": alignCenterHorizontal,
  "align-end-horizontal": alignEndHorizontal,
  "align-start-horizontal": alignStartHorizontal,
  "align-horizontal-distribute-center": alignHorizontalDistributeCenter,
  "align-vertical-distribute-center": alignVerticalDistributeCenter,
  "arrow-up-down": arrowUpDown,
  blend,
  brush,
  check,
  "chevron-down": chevronDown,
  "chevron-right": chevronRight,
  "chevron-up": chevronUp,
  circle,
  "circle-alert": circleAlert,
  component,
  contrast,
  copy,
  ellipsis,
  eye,
  "eye-off": eyeOff,
  "file-plus-2": filePlus2,
  "flip-horizontal-2": flipHorizontal2,
  "flip-vertical-2": flipVertical2,
  focus,
  folder,
  "folder-open": folderOpen,
  "folder-plus": folderPlus,
  frame,
  "grip-vertical": gripVertical,
  hand,
  hexagon,
  image,
  "image-plus": imagePlus,
  info,
  keyboard,
  layers,
  "link-2": link2,
  "loader-circle": loaderCircle,
  lock,
  "lock-open": lockOpen,
  menu,
  "mouse-pointer-2": mousePointer2,
  palette,
  "pen-tool": penTool,
  pencil,
  pipette,
  play,
  plus,
  "redo-2": redo2,
  "scan-line": scanLine,
  search,
  spline,
  square,
  "trash-2": trash2,
  "triangle-alert": triangleAlert,
  "undo-2": undo2,
  "unlink-2": unlink2,
  x,
} as const;

/** The kinds of node: a corner, one tangent, one tangent with handles of one length. */
const own = {
  "node-corner": (
    <>
      <path d="M3 20 12 7l9 13" />
      <rect x="9.5" y="4.5" width="5" height="5" fill="var(--field)" />
    </>
  ),
  "node-smooth": (
    <>
      <path d="M3 20C4 11 7 8 12 8s8 3 9 12" />
      <path d="M2 8h5M17 8h5" />
      <rect x="9.5" y="5.5" width="5" height="5" fill="var(--field)" />
    </>
  ),
  "node-symmetric": (
    <>
      <path d="M3 20C4 11 7 8 12 8s8 3 9 12" />
      <circle cx="3.5" cy="8" r="1.5" />
      <circle cx="20.5" cy="8" r="1.5" />
      <path d="M5 8h14" />
    </>
  ),
} as const;

export type IconName = keyof typeof lucide | keyof typeof own;

/** Returns the text between `<svg …>` and `</svg>` of lucide's file. */
const inside = (svg: string) =>
  svg.slice(svg.indexOf(">", svg.indexOf("<svg")) + 1, svg.lastIndexOf("</svg>"));

/** Decoration: a name is given by what holds it. 16 px, small 14 px. */
export function Icon({ name, small }: { readonly name: IconName; readonly small?: boolean }) {
  const shape = {
    class: small ? "icon small" : "icon",
    viewBox: "0 0 24 24",
    "aria-hidden": true,
  } as const;
  if (name in own) return <svg {...shape}>{own[name as keyof typeof own]}</svg>;
  const markup = inside(lucide[name as keyof typeof lucide]);
  return <svg {...shape} dangerouslySetInnerHTML={{ __html: markup }} />;
}
