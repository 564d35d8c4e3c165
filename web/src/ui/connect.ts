// SPDX-License-Identifier: Apache-2.0
// The link to this page as a code to scan.
import { html, type TemplateResult } from "lit";

/** `address`: the server's page about it; the code alone lies beside it as an .svg. */
export function connectTemplate(address: string): TemplateResult {
  return html`<p class="label">Scan it in the same network. Who has the link sees the model.</p>
    <img class="connect-code" src=${address.replace(/html$/, "svg")} alt="QR code of the link to this page" width="220" height="220" />
    <p><a href=${address} target="_blank" rel="noopener">The link, the fingerprint, and the way by USB</a></p>`;
}
