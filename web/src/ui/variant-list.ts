// SPDX-License-Identifier: Apache-2.0
// Which component, averaging and layer of its quantity a result shows, among those that the scene holds.
import { html, type TemplateResult } from "lit";
import type { SceneResult } from "../scene";

export interface VariantRow {
  readonly key: string;
  readonly label: string;
  readonly component: string;
  readonly averaging: string;
  readonly layer: string;
  readonly components: readonly string[];
  readonly averagings: readonly string[];
  readonly layers: readonly string[];
}

export interface VariantActions {
  choose(key: string, change: { component?: string; averaging?: string; layer?: string }): void;
}

const AVERAGINGS: Readonly<Record<string, string>> = {
  part: "averaged in parts",
  all: "averaged across parts",
  none: "not averaged",
  solver: "averaged by the solver",
};

export function averagingText(averaging: string): string {
  return AVERAGINGS[averaging] ?? averaging;
}

const LOCATIONS: Readonly<Record<string, string>> = {
  node: "at nodes",
  element: "of elements",
  "element-node": "at elements' nodes",
};

/** Where a result's values come from: "at nodes · averaged in parts · top · about 0,0,0 along 0,0,1". */
export function originText(result: SceneResult | null): string {
  if (!result) return "";
  const turned = result.system?.startsWith("cylindrical:")
    ? result.system.slice("cylindrical:".length).split(",")
    : null;
  return [
    LOCATIONS[result.location] ?? result.location,
    result.averaging ? averagingText(result.averaging) : "",
    result.layer ?? "",
    turned ? `about ${turned.slice(0, 3).join(",")} along ${turned.slice(3).join(",")}` : "",
  ]
    .filter((text) => text !== "")
    .join(" · ");
}

function choice(
  label: string,
  name: string,
  options: readonly string[],
  now: string,
  text: (option: string) => string,
  change: (option: string) => void,
): TemplateResult | null {
  if (options.length < 2) return null;
  const all = options.includes(now) ? options : [now, ...options];
  return html`<label><span>${name}</span><select aria-label="${name} of ${label}" data-choice=${name}
    @change=${(e: Event) => change((e.target as HTMLSelectElement).value)}
    >${all.map((option) => html`<option value=${option} ?selected=${option === now}>${option === "" ? "none" : text(option)}</option>`)}</select></label>`;
}

export function variantListTemplate(rows: readonly VariantRow[], actions: VariantActions): TemplateResult {
  const plain = (word: string) => word.replace(/_/g, " ");
  return html`<ul class="variants">${rows.map(
    (row) => html`<li data-key=${row.key}><b>${row.label}</b>
      ${choice(row.label, "component", row.components, row.component, plain, (component) => actions.choose(row.key, { component }))}
      ${choice(row.label, "averaging", row.averagings, row.averaging, averagingText, (averaging) => actions.choose(row.key, { averaging }))}
      ${choice(row.label, "layer", row.layers, row.layer, plain, (layer) => actions.choose(row.key, { layer }))}</li>`,
  )}</ul>`;
}
