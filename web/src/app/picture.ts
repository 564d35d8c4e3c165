// SPDX-License-Identifier: Apache-2.0
// A picture to keep: the model as it is seen, its marks, and the legend that says what the colours mean.
import { LEGEND_SIZE, paintVrLegend } from "../xr/vr-legend";
import type { App } from "./app";

const FONT = 'system-ui, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif';

function label(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  ratio: number,
  below: boolean,
): void {
  const up = below ? -8 : 24;
  context.font = `600 ${12 * ratio}px ${FONT}`;
  const width = context.measureText(text).width + 12 * ratio;
  context.fillStyle = "#fafaf8";
  context.strokeStyle = "#182125";
  context.lineWidth = ratio;
  context.beginPath();
  context.roundRect(x + 8 * ratio, y - up * ratio, width, 18 * ratio, 4 * ratio);
  context.fill();
  context.stroke();
  context.beginPath();
  context.arc(x, y, 3.5 * ratio, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.fillStyle = "#182125";
  context.textBaseline = "middle";
  context.fillText(text, x + 14 * ratio, y - (up - 9) * ratio);
}

/** Painted from the frame that is drawn for it: what is on the screen is what is in the file. */
export function takePicture(app: App): Promise<Blob> {
  const { stage, models, overlay } = app;
  stage.draw();
  const source = stage.canvas;
  const ratio = source.width / Math.max(source.clientWidth, 1);
  const legend = models.legend();
  const height = Math.min(source.height * 0.8, LEGEND_SIZE.height * ratio * 0.6);
  const width = legend ? (height * LEGEND_SIZE.width) / LEGEND_SIZE.height : 0;
  const canvas = document.createElement("canvas");
  canvas.width = source.width + width;
  canvas.height = source.height;
  const context = canvas.getContext("2d");
  if (!context) return Promise.reject(new Error("this browser gives no 2D canvas"));
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--stage").trim();
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(source, 0, 0);
  for (const { text, detail, kind, x, y, hidden } of overlay.markers(null)) {
    const words = `${text} ${detail}`.trim();
    const below = kind === "min" || kind === "ruler";
    if (!hidden && words) label(context, words, x * ratio, y * ratio, ratio, below);
  }
  if (legend) {
    // Painted whole and then scaled: rows of colour that were scaled one by one would show their seams.
    const board = new OffscreenCanvas(LEGEND_SIZE.width, LEGEND_SIZE.height);
    const drawing = board.getContext("2d");
    if (drawing) paintVrLegend(drawing, legend);
    context.drawImage(board, source.width - 0.03 * width, (source.height - height) / 2, width, height);
  }
  return new Promise((resolve, reject) =>
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error("the picture is too large"))),
      "image/png",
    ),
  );
}
