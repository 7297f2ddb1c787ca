// Export: what, how large, which part. The format decides which rows there are.
import { useSignal } from "@preact/signals";
import { complaintAboutSize, mostSide, type ExportWish } from "../../files/export.js";
import { Icon } from "../../icons.js";
import * as en from "../../strings/en.js";
import { IconButton } from "../controls/button.js";
import { NumberField } from "../controls/field.js";
import { Segments } from "../controls/segments.js";
import type { Sink } from "../controls/sink.js";
import { bytes, decimal } from "../format.js";
import { useShell } from "../services.js";
import { Check } from "./check.js";
import { sizeAt, viewportOf, type Area, type Size } from "./area.js";
import { Preview, useEstimate, useWork } from "./exporting.js";
import { Frame } from "./frame.js";

const words = en.dialogs;

interface Choice {
  readonly format: ExportWish["format"];
  readonly area: Area;
  readonly size: Size;
  readonly linked: boolean;
  readonly transparent: boolean;
  readonly keepReference: boolean;
  readonly isSelectionOnly: boolean;
  readonly depth: 8 | 16;
  /** Scales of more PNG files. */
  readonly also: readonly number[];
  readonly plain: "vectors" | "pixels";
}

/** The last choice for each file, kept until the page closes. */
const remembered = new Map<string, Choice>();

const once = (set: (value: number) => void, now: number): Sink<number> => ({
  set,
  begin: () => ({ show: set, keep: () => undefined, drop: () => set(now) }),
});

type Change = (to: Partial<Choice>) => void;

function Formats({ choice, change }: { readonly choice: Choice; readonly change: Change }) {
  return (
    <div class="formats" role="radiogroup" aria-label={words.format}>
      {(["svg", "png", "html", "pdf", "plain"] as const).map((format) => (
        <label key={format} class="format">
          <input
            type="radio"
            name="format"
            checked={choice.format === format}
            onChange={() => change({ format })}
          />
          <b>{words.formatNames[format]}</b>
          <span>{words.formats[format]}</span>
        </label>
      ))}
    </div>
  );
}

function SizeRow({
  choice,
  change,
  natural,
}: {
  readonly choice: Choice;
  readonly change: Change;
  readonly natural: Size;
}) {
  const { size, linked } = choice;
  const set = (axis: keyof Size) => (value: number) => {
    const pixels = Math.max(1, Math.round(value));
    const other = axis === "width" ? "height" : "width";
    const kept = linked
      ? Math.max(1, Math.round((pixels * natural[other]) / natural[axis]))
      : size[other];
    change({
      size: axis === "width" ? { width: pixels, height: kept } : { width: kept, height: pixels },
    });
  };
  const scale = [1, 2, 4].find(
    (s) => size.width === natural.width * s && size.height === natural.height * s,
  );
  return (
    <div>
      <div class="form-label">
        <span>{words.size}</span>
        <span class="muted">{words.megapixels(decimal((size.width * size.height) / 1e6, 1))}</span>
      </div>
      <div class="size-row">
        <NumberField
          label="W"
          name={en.panels.width}
          value={size.width}
          digits={0}
          min={1}
          max={mostSide}
          unit="px"
          sink={once(set("width"), size.width)}
        />
        <IconButton
          icon={linked ? "link-2" : "unlink-2"}
          label={words.keepProportions}
          pressed={linked}
          onClick={() => change({ linked: !linked })}
        />
        <NumberField
          label="H"
          name={en.panels.height}
          value={size.height}
          digits={0}
          min={1}
          max={mostSide}
          unit="px"
          sink={once(set("height"), size.height)}
        />
        <Segments
          label={words.scale}
          value={scale === undefined ? null : String(scale)}
          choices={["1", "2", "4"].map((value) => ({ value, label: `${value}×` }))}
          onChange={(value) =>
            change({
              size: {
                width: natural.width * Number(value),
                height: natural.height * Number(value),
              },
              linked: true,
            })
          }
        />
      </div>
    </div>
  );
}

const MORE_SCALES = [1, 2, 3] as const;

/** Sizes of a picture, each as a file; the size that is chosen above is among them anyway. */
function MoreSizes({
  choice,
  change,
  natural,
}: {
  readonly choice: Choice;
  readonly change: Change;
  readonly natural: Size;
}) {
  const { also, size } = choice;
  return (
    <div role="group" aria-label={words.alsoSizes}>
      <div class="form-label">
        <span>{words.alsoSizes}</span>
      </div>
      <div class="more-sizes">
        {MORE_SCALES.map((scale) => {
          const isChosen = isSameSize(size, scaled(natural, scale));
          return (
            <Check
              key={scale}
              checked={isChosen || also.includes(scale)}
              disabled={isChosen}
              label={words.sizeSuffix(scale)}
              onChange={(isOn) =>
                change({ also: isOn ? [...also, scale] : also.filter((one) => one !== scale) })
              }
            />
          );
        })}
      </div>
    </div>
  );
}

function PlainContent({ choice, change }: { readonly choice: Choice; readonly change: Change }) {
  return (
    <div>
      <div class="form-label">
        <span>{words.content}</span>
      </div>
      <Segments
        full
        label={words.content}
        value={choice.plain}
        choices={(["vectors", "pixels"] as const).map((value) => ({
          value,
          label: words.contents[value],
        }))}
        onChange={(plain) => change({ plain })}
      />
      <p class="read muted">{words.contentNotes[choice.plain]}</p>
    </div>
  );
}

const scaled = ({ width, height }: Size, scale: number): Size => ({
  width: width * scale,
  height: height * scale,
});
const isSameSize = (a: Size, b: Size) => a.width === b.width && a.height === b.height;

/** Returns a wish for each size of a picture, the smallest size first. */
function sizesOf(wish: ExportWish, natural: Size, also: readonly number[]): readonly ExportWish[] {
  const others = also
    .map((scale) => scaled(natural, scale))
    .filter((size) => !isSameSize(size, wish));
  return [wish, ...others.map((size) => ({ ...wish, ...size }))].sort((a, b) => a.width - b.width);
}

function firstComplaint(wishes: readonly ExportWish[]): string | null {
  return wishes.map(complaintAboutSize).find((complaint) => complaint !== null) ?? null;
}

const exportLabel = (format: ExportWish["format"], count: number) =>
  count > 1 ? words.exportFiles(count) : words.exportAs(words.formatNames[format]);

export function ExportDialog() {
  const { editor, services } = useShell();
  const name = editor.file.value.name;
  const artboard = editor.drawing.artboard;
  const choice = useSignal<Choice>(
    remembered.get(name) ?? {
      format: "png",
      area: "artboard",
      size: sizeAt(artboard, 2),
      linked: true,
      transparent: false,
      keepReference: false,
      isSelectionOnly: false,
      depth: 8,
      also: [],
      plain: "vectors",
    },
  );
  const { stage, reason, run } = useWork();
  const now = choice.value;
  const isPng = now.format === "png";
  // The parts of the drawing's text and of the page that zooms are not chosen.
  const hasArea = isPng || now.format === "pdf" || now.format === "plain";
  const viewport = (hasArea ? viewportOf(editor, now.area) : null) ?? artboard;
  const natural = sizeAt(viewport, 1);
  const canBeAlone = now.format !== "svg" && editor.selection.value.length > 0;
  const hasBackground = editor.drawing.background !== null;
  const change: Change = (to) => {
    choice.value = { ...choice.value, ...to };
    remembered.set(name, choice.value);
  };
  const setArea = (area: Area) => {
    const box = viewportOf(editor, area) ?? artboard;
    const factor = now.size.width / natural.width;
    change({
      area,
      size: sizeAt(box, Math.min(factor, mostSide / Math.max(box[2] - box[0], box[3] - box[1]))),
    });
  };
  const wish: ExportWish = {
    format: now.format,
    ...now.size,
    viewport,
    transparent: (hasArea && now.transparent) || !hasBackground,
    keepReference: now.keepReference,
    isSelectionOnly: canBeAlone && now.isSelectionOnly,
    depth: now.depth,
    plain: now.plain,
  };
  const wishes = isPng ? sizesOf(wish, natural, now.also) : [wish];
  const complaint = isPng ? firstComplaint(wishes) : null;
  const estimate = useEstimate(wish);
  const areas: readonly Area[] = viewportOf(editor, "selection")
    ? ["artboard", "selection", "view"]
    : ["artboard", "view"];
  const foot = (
    <>
      <span class="muted foot-note">
        {estimate === null ? words.sizeUnknown : words.about(bytes(estimate))}
      </span>
      <span class="spacer" />
      {isPng && (
        <button
          type="button"
          class="button large"
          disabled={stage.value !== null || complaint !== null}
          onClick={() => void run((watch) => services.copyPicture(wish, watch), words.copied)}
        >
          <Icon name="copy" />
          {en.panels.copy}
        </button>
      )}
      <button
        type="button"
        class="button primary large"
        disabled={stage.value !== null || complaint !== null}
        onClick={() => void run((watch) => services.exportTo(wishes, natural, watch), null)}
      >
        {stage.value ? words.exporting[stage.value] : exportLabel(now.format, wishes.length)}
      </button>
    </>
  );
  return (
    <Frame title={words.export} class="export" foot={foot}>
      <div class="export-grid">
        <Preview wish={wish} />
        <div class="form export-form">
          <Formats choice={now} change={change} />
          {isPng && <SizeRow choice={now} change={change} natural={natural} />}
          {isPng && <MoreSizes choice={now} change={change} natural={natural} />}
          {hasArea && (
            <div>
              <div class="form-label">
                <span>{words.area}</span>
              </div>
              <Segments
                full
                label={words.area}
                value={now.area}
                choices={areas.map((value) => ({ value, label: words.areas[value] }))}
                onChange={setArea}
              />
            </div>
          )}
          {now.format === "plain" && <PlainContent choice={now} change={change} />}
          <div class="checks">
            {hasArea && (
              <Check
                checked={wish.transparent}
                label={words.transparent}
                note={hasBackground ? undefined : words.noBackground}
                disabled={!hasBackground}
                onChange={(transparent) => change({ transparent })}
              />
            )}
            {canBeAlone && (
              <Check
                checked={now.isSelectionOnly}
                label={words.selectionOnly}
                note={words.selectionOnlyNote}
                onChange={(isSelectionOnly) => change({ isSelectionOnly })}
              />
            )}
            {isPng && (
              <Check
                checked={now.depth === 16}
                label={words.sixteenBits}
                note={words.sixteenBitsNote}
                onChange={(isDeep) => change({ depth: isDeep ? 16 : 8 })}
              />
            )}
            {now.format === "svg" && (
              <Check
                checked={!now.keepReference}
                label={words.leaveOut}
                onChange={(leaveOut) => change({ keepReference: !leaveOut })}
              />
            )}
            {now.format === "html" && <p class="read muted">{words.htmlNote}</p>}
            {now.format === "pdf" && <p class="read muted">{words.pdfNote}</p>}
          </div>
          {(reason.value ?? complaint) && (
            <p class="read failure" role="alert">
              {reason.value ?? complaint}
            </p>
          )}
        </div>
      </div>
    </Frame>
  );
}
