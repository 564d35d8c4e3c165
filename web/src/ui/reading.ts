// SPDX-License-Identifier: Apache-2.0
// What the page says while only the shape is there: nobody takes it for the result.
import { html, type TemplateResult } from "lit";
import { type Reading, stageText } from "../app/opening";

/** Where a value would stand. */
export function withoutResults({ failed }: Reading): string {
  return failed === null ? "Results are still being read." : "The results could not be read.";
}

export function readingTemplate(reading: Reading): TemplateResult {
  const { failed, percent } = reading;
  if (failed !== null)
    return html`<div class="banner reading-failed" role="alert"><span><b>Only the shape is shown: the results could not be read.</b> ${failed}</span></div>`;
  return html`<div class="reading"><span role="status"><b>Only the shape:</b> results are still being read</span>
    <progress max="100" .value=${percent} aria-label="reading results"></progress><small>${stageText(reading)}</small></div>`;
}
