// SPDX-License-Identifier: Apache-2.0
// Words and buttons on a board.
import { BOARD_FONT, type BoardButton, BOARD_COLOURS as C, roundRect } from "./board";

export interface Ink {
  readonly context: CanvasRenderingContext2D;
  readonly buttons: BoardButton[];
  readonly hover: string | null;
}

export function words(
  ink: Ink,
  text: string,
  x: number,
  y: number,
  size: number,
  colour: string,
  options: { bold?: boolean; align?: CanvasTextAlign; width?: number } = {},
): void {
  const { context } = ink;
  context.font = `${options.bold ? 600 : 400} ${size}px ${BOARD_FONT}`;
  context.textAlign = options.align ?? "left";
  context.textBaseline = "middle";
  context.fillStyle = colour;
  context.fillText(text, x, y, options.width);
}

export function button(
  ink: Ink,
  spec: Omit<BoardButton, "press"> & { text: string; on?: boolean; enabled?: boolean; press: () => void },
): void {
  const enabled = spec.enabled ?? true;
  const fill = spec.on ? C.accent : ink.hover === spec.id && enabled ? C.hover : C.panel;
  const inset = { x: spec.x + 3, y: spec.y + 3, width: spec.width - 6, height: spec.height - 6 };
  roundRect(
    ink.context,
    { x: inset.x - 2, y: inset.y - 2, width: inset.width + 4, height: inset.height + 4 },
    15,
    ink.hover === spec.id && enabled ? C.ink : C.line,
  );
  roundRect(ink.context, inset, 13, fill);
  const colour = spec.on ? C.accentInk : enabled ? C.ink : C.faint;
  words(ink, spec.text, spec.x + spec.width / 2, spec.y + spec.height / 2, 27, colour, {
    align: "center",
    bold: spec.on ?? false,
    width: spec.width - 14,
  });
  if (enabled)
    ink.buttons.push({
      id: spec.id,
      x: spec.x,
      y: spec.y,
      width: spec.width,
      height: spec.height,
      press: spec.press,
    });
}
