// SPDX-License-Identifier: Apache-2.0
// Inside the solids: the value at a typed place, and the surface where the result that is seen has a value.
import { html, type TemplateResult } from "lit";
import { numberText, unitText } from "./format";

export interface InsideFormModel {
  readonly lengthUnit: string | null;
  readonly place: readonly [string, string, string];
  /** What was found there; null: nothing was asked. */
  readonly found: {
    readonly text: string;
    readonly rows: readonly {
      readonly label: string;
      readonly unit: string | null;
      readonly value: number | null;
      readonly nodeValue: number | null;
    }[];
  } | null;
  readonly surface: {
    readonly on: boolean;
    /** Of the result that is seen; empty: none is. */
    readonly label: string;
    readonly unit: string | null;
    readonly value: number;
    readonly lo: number;
    readonly hi: number;
    readonly text: string;
  };
  readonly seeThrough: boolean;
}

export interface InsideActions {
  type(axis: number, text: string): void;
  read(): void;
  toggleSurface(): void;
  setLevel(value: number): void;
  toggleSeeThrough(): void;
}

const AXES = ["x", "y", "z"] as const;

function foundTemplate(found: NonNullable<InsideFormModel["found"]>): TemplateResult {
  return html`<p class="inside-found" role="status">${found.text}</p>
    ${
      found.rows.length === 0
        ? null
        : html`<table class="inside-values">
            <thead><tr><th scope="col">result</th><th scope="col">here</th><th scope="col">at that node</th></tr></thead>
            <tbody>${found.rows.map(
              (row) => html`<tr><th scope="row">${row.label}</th>
                <td>${row.value === null ? "no value" : `${numberText(row.value)} ${unitText(row.unit)}`}</td>
                <td>${row.nodeValue === null ? "–" : numberText(row.nodeValue)}</td></tr>`,
            )}</tbody>
          </table>`
    }`;
}

export function insideTemplate(model: InsideFormModel, actions: InsideActions): TemplateResult {
  const { surface } = model;
  const submit = (event: Event) => {
    event.preventDefault();
    actions.read();
  };
  const level = (event: Event) => {
    const value = Number((event.target as HTMLInputElement).value.replace(",", "."));
    if (Number.isFinite(value)) actions.setLevel(value);
  };
  return html`<form class="inside-place" @submit=${submit}>
      <fieldset><legend>Value at a place${model.lengthUnit ? `, ${unitText(model.lengthUnit)}` : ""}</legend>
        <div class="row">${AXES.map(
          (
            axis,
            i,
          ) => html`<label>${axis}<input inputmode="decimal" aria-label="${axis} of the place" .value=${model.place[i] ?? ""}
            @change=${(event: Event) => actions.type(i, (event.target as HTMLInputElement).value)} /></label>`,
        )}<button type="submit" class="push">Read</button></div>
      </fieldset>
    </form>
    ${model.found ? foundTemplate(model.found) : html`<p class="hint">Of the undeformed model, by the shape functions of the element that is there.</p>`}
    <div class="row">
      <button type="button" class="push" aria-pressed=${surface.on ? "true" : "false"} ?disabled=${surface.label === ""}
        @click=${() => actions.toggleSurface()}>Surface of equal value</button>
      <button type="button" class="push" aria-pressed=${model.seeThrough ? "true" : "false"} @click=${() => actions.toggleSeeThrough()}>See through the skin</button>
    </div>
    ${
      surface.on && surface.label !== ""
        ? html`<div class="row">
            <input class="cut-slider" type="range" min=${surface.lo} max=${surface.hi} step=${(surface.hi - surface.lo) / 200 || 1}
              .value=${String(surface.value)} aria-label="value of the surface" @input=${level} />
            <input class="number cut-place" inputmode="decimal" aria-label="value of the surface, typed" .value=${numberText(surface.value)} @change=${level} />
            <span class="unit">${unitText(surface.unit)}</span>
          </div>`
        : null
    }
    ${surface.on ? html`<p class="cut-section" role="status">${surface.text}</p>` : null}`;
}
