// SPDX-License-Identifier: Apache-2.0
// The way for a headset or a phone to this page, when the server says in the page's head that there is one.
import { connectTemplate, type Section } from "../../ui";
import type { Feature } from "./feature";

export class Connect implements Feature {
  readonly id = "connect";
  readonly #address = document.querySelector<HTMLMetaElement>("meta[name=feelem-connect]")?.content ?? null;

  section(): Section | null {
    const address = this.#address;
    if (address === null) return null;
    return {
      id: this.id,
      title: "Headset or phone",
      summary: "by a QR code",
      body: () => connectTemplate(address),
    };
  }
}
