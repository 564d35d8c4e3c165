// SPDX-License-Identifier: Apache-2.0
// A node's values over all steps as a line, with the step that is shown; a press goes to a step.
import { html, svg, type TemplateResult } from "lit";
import { axisTexts, numberText, unitText } from "./format";

export interface HistoryLine {
  readonly label: string;
  readonly unit: string | null;
  readonly points: readonly { readonly step: number; readonly at: number; readonly value: number | null }[];
  readonly limit: number | null;
}

export interface HistoryModel {
  readonly node: number | null;
  readonly lines: readonly HistoryLine[];
  readonly step: number;
  readonly axis: string;
  readonly reading: boolean;
  readonly stepName: (step: number) => string;
  readonly go: (step: number) => void;
}

const WIDTH = 340;
const HEIGHT = 120;
const LEFT = 54;
const TOP = 8;
const BOTTOM = 18;

function plot(line: HistoryLine, model: HistoryModel): TemplateResult {
  const known = line.points.filter((p) => p.value !== null);
  const values = known.map((p) => p.value as number);
  const ats = line.points.map((p) => p.at);
  const [lo, hi] = [Math.min(...values), Math.max(...values)];
  const [from, to] = [Math.min(...ats), Math.max(...ats)];
  const x = (at: number) => LEFT + ((at - from) / (to - from || 1)) * (WIDTH - LEFT - 8);
  const y = (value: number) => TOP + (1 - (value - lo) / (hi - lo || 1)) * (HEIGHT - TOP - BOTTOM);
  const path = line.points
    .map((p, i) => {
      if (p.value === null) return "";
      const joined = i > 0 && line.points[i - 1]?.value !== null;
      return `${joined ? "L" : "M"}${x(p.at).toFixed(1)} ${y(p.value).toFixed(1)}`;
    })
    .join("");
  const here = line.points.find((p) => p.step === model.step);
  const texts = axisTexts(hi > lo ? [lo, hi] : [lo]);
  const press = (event: MouseEvent) => {
    const box = (event.currentTarget as SVGElement).getBoundingClientRect();
    const at = ((event.clientX - box.left) / box.width) * WIDTH;
    const nearest = [...line.points].sort((a, b) => Math.abs(x(a.at) - at) - Math.abs(x(b.at) - at))[0];
    if (nearest) model.go(nearest.step);
  };
  const now = here && here.value !== null ? `${numberText(here.value)} ${unitText(line.unit)}` : "no value";
  return html`<figure class="history">
    <figcaption>${line.label}<b>${here ? now : ""}</b></figcaption>
    ${
      known.length === 0
        ? html`<p class="hint">${model.reading ? "reading …" : "no values at this node"}</p>`
        : svg`<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${line.label} over ${line.points.length} steps, from ${numberText(lo)} to ${numberText(hi)}" @click=${press}>
        <line class="axis-line" x1=${LEFT} x2=${WIDTH - 8} y1=${HEIGHT - BOTTOM} y2=${HEIGHT - BOTTOM}></line>
        ${here ? svg`<line class="now" x1=${x(here.at)} x2=${x(here.at)} y1=${TOP} y2=${HEIGHT - BOTTOM}></line>` : null}
        ${
          line.limit !== null && line.limit >= lo && line.limit <= hi
            ? svg`<line class="limit-line" x1=${LEFT} x2=${WIDTH - 8} y1=${y(line.limit)} y2=${y(line.limit)}></line>`
            : null
        }
        <path d=${path}></path>
        ${known.length <= 60 ? known.map((p) => svg`<circle cx=${x(p.at)} cy=${y(p.value as number)} r="2"></circle>`) : null}
        ${here && here.value !== null ? svg`<circle class="here" cx=${x(here.at)} cy=${y(here.value)} r="4"></circle>` : null}
        <text x=${LEFT - 6} y=${y(hi) + 4} text-anchor="end">${texts.at(-1)}</text>
        ${hi > lo ? svg`<text x=${LEFT - 6} y=${y(lo) + 3} text-anchor="end">${texts[0]}</text>` : null}
        <text x=${LEFT} y=${HEIGHT - 4}>${numberText(from, 4)}</text>
        <text x=${WIDTH - 8} y=${HEIGHT - 4} text-anchor="end">${numberText(to, 4)} ${model.axis}</text>
      </svg>`
    }
  </figure>`;
}

export function historyTemplate(model: HistoryModel): TemplateResult {
  if (model.node === null)
    return html`<p class="hint">Press on a node of the model, or go to one, to see its values over all steps.</p>`;
  return html`<p class="history-node">node <b>${model.node}</b></p>${model.lines.map((line) => plot(line, model))}`;
}
