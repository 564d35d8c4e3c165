// SPDX-License-Identifier: Apache-2.0
// Files that a page carries inside itself (`feelem convert … -o review.html`): gzip in base64, in script elements
// that no browser runs.

/** Bytes of a carried file by its name. */
export type CarriedFiles = (name: string) => Promise<ArrayBuffer>;

/** Null for a page that finds its scene elsewhere. */
export function carriedFiles(): CarriedFiles | null {
  const elements = [...document.querySelectorAll<HTMLScriptElement>("script[data-file]")];
  if (elements.length === 0) return null;
  return async (name) => {
    const wanted = decodeURIComponent(name);
    const found = elements.find((element) => element.dataset.file === wanted);
    if (!found) throw new Error(`this page does not carry '${wanted}'`);
    const packed = await fetch(`data:application/gzip;base64,${found.textContent ?? ""}`);
    if (!packed.body) throw new Error(`'${wanted}' in this page is empty`);
    return new Response(packed.body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
  };
}
