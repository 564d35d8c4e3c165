// SPDX-License-Identifier: Apache-2.0
// Legend and probe card in the headset, painted from the same models as the page's.
import { type Reading, stageText } from "../app/opening";
import { type Palette, texelOf } from "../render";
import {
  axisTexts,
  boundText,
  type CardModel,
  type LegendModel,
  labelPositions,
  numberText,
  positionOf,
  unitText,
  valueAtPosition,
  withoutResults,
} from "../ui";
import { BOARD_FONT, BOARD_COLOURS as C, roundRect } from "./board";

/** A canvas of the page, or one beside it. */
type Drawing = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

export const LEGEND_SIZE = { width: 460, height: 860 } as const;
export const CARD_SIZE = { width: 760, height: 420 } as const;

function font(context: Drawing, size: number, weight = 400): void {
  context.font = `${weight} ${size}px ${BOARD_FONT}`;
  context.textBaseline = "middle";
  context.textAlign = "left";
}

function paintBar(
  context: Drawing,
  palette: Palette,
  x: number,
  y: number,
  width: number,
  height: number,
): void {
  for (let row = 0; row < height; ++row) {
    const at = 4 * texelOf(1 - (row + 0.5) / height, palette);
    const [r, g, b] = palette.texels.subarray(at, at + 3);
    context.fillStyle = `rgb(${r} ${g} ${b})`;
    context.fillRect(x, y + row, width, 1);
  }
}

/** In the place of the scale. */
function paintReading(context: Drawing, reading: Reading): void {
  const { width } = LEGEND_SIZE;
  context.fillStyle = reading.failed === null ? C.ink : C.alarm;
  font(context, 38, 600);
  context.fillText("Only the shape", 30, 50, width - 60);
  context.fillStyle = C.ink;
  font(context, 31);
  context.fillText(withoutResults(reading), 30, 100, width - 60);
  if (reading.failed !== null) return;
  context.fillStyle = C.soft;
  context.fillText(stageText(reading), 30, 146, width - 60);
  context.fillStyle = C.line;
  context.fillRect(30, 180, width - 60, 12);
  context.fillStyle = C.accent;
  context.fillRect(30, 180, ((width - 60) * reading.percent) / 100, 12);
}

export function paintVrLegend(
  context: Drawing,
  model: LegendModel | null,
  reading: Reading | null = null,
): void {
  const { width, height } = LEGEND_SIZE;
  roundRect(context, { x: 0, y: 0, width, height }, 28, C.panel);
  if (!model && reading) paintReading(context, reading);
  if (!model) return;
  const { shown } = model;
  context.fillStyle = C.ink;
  font(context, 38, 600);
  context.fillText(shown.label, 30, 50, width - 60);
  context.fillStyle = C.soft;
  font(context, 29);
  context.fillText(unitText(shown.unit) || "unit not given", 30, 94, width - 60);
  context.fillText(model.stepText, 30, 132, width - 60);
  const bar = { x: 40, y: 180, width: 90, height: 560 };
  paintBar(context, model.palette, bar.x, bar.y, bar.width, bar.height);
  const positions = labelPositions(model.effect.bands);
  const texts = axisTexts(positions.map((t) => valueAtPosition(t, shown.range)));
  font(context, 42);
  positions.forEach((t, i) => {
    const y = bar.y + bar.height * (1 - t);
    context.fillStyle = C.soft;
    context.fillRect(bar.x + bar.width + 4, y - 1, 12, 2);
    context.fillStyle = C.ink;
    context.fillText(texts[i] ?? "", bar.x + bar.width + 26, y, width - bar.width - 80);
  });
  const limit = positionOf(shown.limit, shown.range);
  if (limit !== null) {
    const y = bar.y + bar.height * (1 - limit);
    context.fillStyle = C.alarm;
    context.fillRect(bar.x - 8, y - 3, bar.width + 34, 6);
    context.fillText(
      shown.limitLabel || "limit",
      bar.x + bar.width + 130,
      y,
      width - bar.x - bar.width - 150,
    );
  }
  const probe = positionOf(model.probed, shown.range);
  if (probe !== null) {
    const y = bar.y + bar.height * (1 - probe);
    context.fillStyle = C.ink;
    context.fillRect(bar.x - 12, y - 3, bar.width + 24, 6);
  }
  context.fillStyle = C.soft;
  font(context, 27);
  context.fillText(model.deformText, 30, height - 64, width - 60);
  // The place of the values gives way to what may be wrong with them.
  context.fillText(model.levelText || (shown.result?.location ?? ""), 30, height - 28, width - 60);
}

export function paintVrCard(context: Drawing, model: CardModel): void {
  const { width } = CARD_SIZE;
  const rows = model.rows.slice(0, 5);
  const height = Math.min(CARD_SIZE.height, 92 + (model.reading ? 1 : rows.length) * 62);
  roundRect(context, { x: 0, y: CARD_SIZE.height - height, width, height }, 24, C.panel);
  let y = CARD_SIZE.height - height + 42;
  if (model.reading) {
    context.fillStyle = C.ink;
    font(context, 35);
    context.fillText(`No values. ${withoutResults(model.reading)}`, 26, y, width - 52);
  }
  for (const row of rows) {
    context.fillStyle = C.soft;
    font(context, 35);
    context.fillText(row.label, 26, y, 330);
    context.fillStyle = row.alarm ? C.alarm : C.ink;
    font(context, 44, 600);
    context.textAlign = "right";
    const about = row.state === "interpolated" ? "~" : "";
    context.fillText(row.value === null ? "no value" : `${about}${numberText(row.value)}`, 600, y, 230);
    font(context, 35);
    context.fillStyle = C.soft;
    context.fillText(row.value === null ? "" : unitText(row.unit), 616, y, 130);
    if (row.value !== null && row.bound) {
      font(context, 22);
      context.fillText(`± ${boundText(row.bound)}`, 616, y + 26, 130);
    }
    y += 62;
  }
  context.fillStyle = C.soft;
  font(context, 34);
  context.fillText(
    `${model.report.interior ? "inside · " : ""}node ${model.report.nodeId ?? "–"} · element ${model.report.elementId ?? "–"}`,
    26,
    CARD_SIZE.height - 32,
    width - 52,
  );
}
