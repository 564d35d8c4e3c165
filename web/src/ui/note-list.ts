// SPDX-License-Identifier: Apache-2.0
// Notes at nodes, the ruler between two, differences of steps, and what can be saved.
import { html, type TemplateResult } from "lit";
import { icon } from "./icons";

export interface NoteRow {
  readonly id: number;
  readonly node: number;
  readonly note: string;
  /** Value of what is seen, with its unit. */
  readonly value: string;
}

export interface NoteActions {
  write(id: number, note: string): void;
  remove(id: number): void;
  goTo(id: number): void;
  pinHere(): void;
  measure(): void;
  clearRuler(): void;
}

export function notesTemplate(rows: readonly NoteRow[], ruler: string, actions: NoteActions): TemplateResult {
  return html`<ul class="plainlist notes">${rows.map(
    (row) => html`<li>
      <button type="button" class="link" aria-label="go to note ${row.id}" @click=${() => actions.goTo(row.id)}>${row.id}</button>
      <span class="note-place">node ${row.node}<small>${row.value}</small></span>
      <input aria-label="text of note ${row.id}" placeholder="note" .value=${row.note} @change=${(e: Event) => actions.write(row.id, (e.target as HTMLInputElement).value)} />
      <button type="button" class="cell" aria-label="remove note ${row.id}" title="remove" @click=${() => actions.remove(row.id)}>${icon("close")}</button>
    </li>`,
  )}</ul>
  <div class="row"><button type="button" class="push" @click=${() => actions.pinHere()}>Note at this node</button>
    <button type="button" class="push" @click=${() => actions.measure()}>Measure from here</button></div>
  <p class="ruler" ?hidden=${ruler === ""}><span>${ruler}</span><button type="button" class="cell" aria-label="put the ruler away" @click=${() => actions.clearRuler()}>${icon("close")}</button></p>`;
}

export interface DifferenceModel {
  readonly results: readonly { readonly key: string; readonly label: string }[];
  readonly steps: readonly { readonly id: number; readonly name: string }[];
  readonly add: (key: string, step: number) => void;
}

export function differenceTemplate(model: DifferenceModel): TemplateResult {
  const submit = (event: Event) => {
    event.preventDefault();
    const data = new FormData(event.target as HTMLFormElement);
    model.add(String(data.get("result")), Number(data.get("step")));
  };
  return html`<form class="fields" @submit=${submit}>
    <label class="wide"><span>result</span><select name="result" aria-label="result to compare">${model.results.map((r) => html`<option value=${r.key}>${r.label}</option>`)}</select></label>
    <label class="wide"><span>minus</span><select name="step" aria-label="step to subtract">${model.steps.map((s) => html`<option value=${s.id}>${s.name}</option>`)}</select></label>
    <button type="submit" class="push">See the difference</button>
  </form><p class="hint">Value of the step shown minus that of the step above, node by node; missing where either is.</p>`;
}

export interface SaveModel {
  readonly separator: string;
  readonly hasHistory: boolean;
  readonly save: (what: "picture" | "nodes" | "places" | "history" | "presentation") => void;
  readonly separate: (separator: string) => void;
  readonly openFile: () => void;
}

export function saveTemplate(model: SaveModel): TemplateResult {
  const button = (what: Parameters<SaveModel["save"]>[0], text: string, enabled = true) =>
    html`<button type="button" class="push" ?disabled=${!enabled} @click=${() => model.save(what)}>${text}</button>`;
  return html`<div class="row">${button("picture", "Picture")}${button("presentation", "Presentation")}
      <button type="button" class="push" @click=${() => model.openFile()}>Open a file …</button></div>
    <div class="row">${button("nodes", "All visible nodes")}${button("places", "Notes and hot spots")}${button("history", "Node over all steps", model.hasHistory)}</div>
    <div class="row"><label class="label">columns parted by <select aria-label="columns parted by" @change=${(e: Event) => model.separate((e.target as HTMLSelectElement).value)}>
      ${[
        [",", "comma (.csv)"],
        [";", "semicolon (.csv)"],
        ["\t", "tab (.tsv)"],
      ].map(
        ([word, text]) =>
          html`<option value=${word ?? ""} ?selected=${word === model.separator}>${text}</option>`,
      )}</select></label></div>`;
}
