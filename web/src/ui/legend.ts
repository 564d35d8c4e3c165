// SPDX-License-Identifier: Apache-2.0
// The legend: drawn from the palette of the mesh, with its range, bands and map to be typed.
import { html, type TemplateResult } from "lit";
import type { Shown } from "../app/model-view";
import type { Reading } from "../app/opening";
import type { RangeMode } from "../app/presentation-doc";
import { type ColourEffect, colourMaps, normalise, type Rgb } from "../present";
import { type Palette, texelOf } from "../render";
import type { Actions } from "./actions";
import { axisTexts, numberText, unitText } from "./format";
import { mapNote } from "./map-note";
import { withoutResults } from "./reading";
import { labelPositions, positionOf, valueAtPosition } from "./scale-axis";
import { originText } from "./variant-list";

export interface LegendModel {
  readonly shown: Shown;
  readonly effect: ColourEffect;
  readonly palette: Palette;
  readonly stepText: string;
  readonly deformText: string;
  /** What may be wrong with the picture while a reduced level of detail is drawn; empty: nothing is; null: there is none. */
  readonly levelText: string | null;
  /** Value under the pointer. */
  readonly probed: number | null;
  readonly shading: boolean;
  readonly isolines: boolean;
  readonly hatch: boolean;
}

/** Paints one line of pixels after the other, each in the texel the mesh would take there; a wide canvas lies. */
export function paintLegend(canvas: HTMLCanvasElement, palette: Palette): void {
  const height = Math.max(1, Math.round(canvas.clientHeight * window.devicePixelRatio));
  const width = Math.max(1, Math.round(canvas.clientWidth * window.devicePixelRatio));
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  if (!context) return;
  const pixels = context.createImageData(width, height);
  const lies = width > height;
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const from = 4 * texelOf(lies ? (x + 0.5) / width : 1 - (y + 0.5) / height, palette);
      pixels.data.set(palette.texels.subarray(from, from + 4), 4 * (y * width + x));
    }
  }
  context.putImageData(pixels, 0, 0);
}

const css = (rgb: Rgb) => `background-color: rgb(${rgb[0]} ${rgb[1]} ${rgb[2]})`;
/** Along the scale, whichever way it lies. */
const percent = (t: number) => `--at: ${(t * 100).toFixed(3)}%`;
/** Whether a label goes where there is room for four to six: even steps, and both ends stay. */
export function isSpare(index: number, count: number): boolean {
  const last = count - 1;
  const step = last <= 5 ? 1 : last % 3 === 0 ? last / 3 : Math.ceil(last / 4);
  return index !== last && (index % step !== 0 || last - index < step);
}
/** Small screens begin with the scale alone. */
const roomy = () => matchMedia("(min-width: 821px)").matches;

const MODES: readonly [RangeMode, string][] = [
  ["auto", "this step"],
  ["allSteps", "all steps"],
  ["manual", "typed"],
  ["percentile", "percentile"],
];

function typed(event: Event): number | null {
  const value = Number((event.target as HTMLInputElement).value.trim().replace(",", "."));
  return (event.target as HTMLInputElement).value.trim() !== "" && Number.isFinite(value) ? value : null;
}

function rangeField(model: LegendModel, end: "lo" | "hi", actions: Actions): TemplateResult {
  const { range, key } = model.shown;
  const change = (event: Event) => {
    const value = typed(event);
    if (value !== null) actions.setRange(key, { mode: "manual", lo: range.lo, hi: range.hi, [end]: value });
    else (event.target as HTMLInputElement).value = numberText(range[end]);
  };
  return html`<label class="legend-end"
    ><span>${end === "hi" ? "to" : "from"}</span
    ><input class="number" inputmode="decimal" aria-label=${end === "hi" ? "upper end of the range" : "lower end of the range"}
      .value=${numberText(range[end])} @change=${change}
  /></label>`;
}

function settings(model: LegendModel, actions: Actions): TemplateResult {
  const { shown, effect } = model;
  const bands = (event: Event) => {
    const value = typed(event);
    actions.setColour({ bands: Math.min(Math.max(Math.round(value ?? effect.bands), 0), 64) });
  };
  return html`<div class="legend-settings">
    ${rangeField(model, "hi", actions)} ${rangeField(model, "lo", actions)}
    <label><span>range</span
      ><select aria-label="where the range comes from"
        @change=${(e: Event) => actions.setRange(shown.key, { mode: (e.target as HTMLSelectElement).value as RangeMode, lo: shown.range.lo, hi: shown.range.hi })}
        >${MODES.filter(([mode]) => mode !== "percentile" || shown.rangeMode === "percentile").map(
          ([mode, text]) =>
            html`<option value=${mode} ?selected=${shown.rangeMode === mode}>${text}</option>`,
        )}</select></label>
    <label class="check"><input type="checkbox" aria-label="hold the range over steps" .checked=${shown.rangeMode === "manual"}
        @change=${() => actions.toggleLock()} />held over steps</label>
    <label><span>scale</span
      ><select aria-label="scale" @change=${(e: Event) => actions.setRange(shown.key, { mode: shown.rangeMode, scale: (e.target as HTMLSelectElement).value })}
        >${[
          ["linear", "lin"],
          ["log", "log"],
          ["signed", "signed"],
          ["symlog", "symlog"],
        ].map(
          ([scale, word]) =>
            html`<option value=${word ?? ""} ?selected=${shown.scale === scale}>${scale}</option>`,
        )}</select></label>
    <label><span>bands</span
      ><input class="number" type="number" min="0" max="64" step="1" title="0: smooth" aria-label="number of bands, 0 for smooth"
        .value=${String(effect.bands)} @change=${bands} /></label>
    <label><span>map</span
      ><select aria-label="colour map" @change=${(e: Event) => actions.setColour({ map: (e.target as HTMLSelectElement).value })}
        >${colourMaps().map((map) => html`<option value=${map} ?selected=${effect.map === map}>${map.replace("_", " ")}</option>`)}</select></label>
    <label class="check"><input type="checkbox" .checked=${effect.invert}
        @change=${(e: Event) => actions.setColour({ invert: (e.target as HTMLInputElement).checked })} />reversed</label>
    <label class="check"><input type="checkbox" .checked=${model.isolines}
        @change=${(e: Event) => actions.setColour({ isolines: (e.target as HTMLInputElement).checked })} />lines between bands</label>
    ${outside(model, actions)}
  </div>`;
}

const hex = (rgb: Rgb) => `#${rgb.map((c) => c.toString(16).padStart(2, "0")).join("")}`;

/** Colours beside the map: above and below the range, and no value. */
function outside(model: LegendModel, actions: Actions): TemplateResult {
  const { effect } = model;
  const ways = [
    ["above", "above", effect.above],
    ["below", "below", effect.below],
    ["nan", "no value", effect.missing],
  ] as const;
  return html`<details class="legend-outside"><summary>outside colours</summary>
    ${ways.map(
      ([
        key,
        word,
        colour,
      ]) => html`<label><span>${word}</span><input type="color" aria-label="colour of ${word}" .value=${hex(colour)}
        @change=${(e: Event) => actions.setColour({ [key]: (e.target as HTMLInputElement).value })} /></label>`,
    )}
    <label class="check"><input type="checkbox" .checked=${model.hatch}
        @change=${(e: Event) => actions.setColour({ nanHatch: (e.target as HTMLInputElement).checked })} />no value hatched</label>
  </details>`;
}

/** The limit's name, unless that is but its number again. */
export function limitWord(shown: Pick<Shown, "limit" | "limitLabel">): string {
  const { limit, limitLabel } = shown;
  return limitLabel && !limitLabel.startsWith(numberText(limit)) ? limitLabel : "limit";
}

const LEVEL_HINT =
  "Fewer triangles are drawn than the model has. What is read, heard and felt comes from all of them.";

export function legendTemplate(
  model: LegendModel | null,
  reading: Reading | null,
  actions: Actions,
): TemplateResult {
  if (!model && reading)
    return html`<aside class="legend empty" aria-label="Legend"><p>No colours. ${withoutResults(reading)}</p></aside>`;
  if (!model)
    return html`<aside class="legend empty" aria-label="Legend"><p>No result is seen. Choose one under <b>Colour</b>.</p></aside>`;
  const { shown, effect } = model;
  const positions = labelPositions(effect.bands);
  const texts = axisTexts(positions.map((t) => valueAtPosition(t, shown.range)));
  const probe = positionOf(model.probed, shown.range);
  const unit = unitText(shown.unit);
  const note = mapNote(effect);
  const limit = shown.limit === null ? null : normalise(shown.limit, shown.range);
  // A limit outside the range has its word below, not a place on the scale.
  const limitAt = limit && !limit.missing && !limit.above && !limit.below ? limit.position : null;
  return html`<aside class="legend" aria-label="Legend">
    <h2>${shown.label}<span class="unit">${unit || "unit not given"}</span></h2>
    <p class="legend-step">${model.stepText}</p>
    ${model.levelText === null ? null : html`<p class="legend-level" title=${LEVEL_HINT}>${model.levelText ? `drawn with ${model.levelText}` : "all triangles are drawn"}</p>`}
    <div class="legend-scale">
      <div class="legend-bar">
        <canvas class="legend-canvas" role="img" aria-label="colours of ${shown.label}"></canvas>
        ${limitAt === null ? null : html`<i class="legend-limit" .style=${percent(limitAt)} title="limit"></i>`}
        ${probe === null ? null : html`<i class="legend-mark" .style=${percent(probe)}></i>`}
      </div>
      <ol class="legend-labels" aria-label="values">
        ${limitAt === null ? null : html`<li class="limit" .style=${percent(limitAt)}>${numberText(shown.limit)} ${limitWord(shown)}</li>`}
        ${positions.map((t, i) => (limitAt !== null && Math.abs(t - limitAt) <= 0.03 ? null : html`<li class=${isSpare(i, positions.length) ? "spare" : ""} .style=${percent(t)}>${texts[i]}</li>`))}
      </ol>
    </div>
    <ul class="legend-special">
      <li><i .style=${css(effect.above)}></i>above</li>
      <li><i .style=${css(effect.below)}></i>below</li>
      <li><i class=${model.hatch ? "hatch" : ""} .style=${css(effect.missing)}></i>no value</li>
    </ul>
    ${limit && limitAt === null ? html`<p class="legend-note">limit ${numberText(shown.limit)}: ${limit.above ? "above" : "below"} this range</p>` : null}
    ${note === null ? null : html`<p class="legend-note legend-warning">${note}</p>`}
    <details class="legend-more" ?open=${roomy()}><summary>range and colours</summary>
      ${settings(model, actions)}
      <p class="legend-note">${originText(shown.result)}</p>
      <p class="legend-note">${model.deformText}</p>
    </details>
    ${model.shading ? html`<p class="legend-note">shaded: colours on the model are darker than here</p>` : null}
  </aside>`;
}
