// SPDX-License-Identifier: Apache-2.0
// The scene of a shape alone, as the converter offers it while results are being read: made of a finished one.

type Json = Record<string, unknown>;

/** `change` of the scene's JSON; arrays stay as they are. */
export function changedScene(glb: ArrayBuffer, change: (extras: Json) => void): ArrayBuffer {
  const view = new DataView(glb);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(glb, 20, length)));
  change(json.extras.feelem);
  const text = new TextEncoder().encode(JSON.stringify(json));
  const padded = Math.ceil(text.length / 4) * 4;
  const rest = new Uint8Array(glb, 20 + length);
  const made = new Uint8Array(20 + padded + rest.length).fill(0x20);
  made.set(new Uint8Array(glb, 0, 20));
  made.set(text, 20);
  made.set(rest, 20 + padded);
  const head = new DataView(made.buffer);
  head.setUint32(8, made.length, true);
  head.setUint32(12, padded, true);
  return made.buffer;
}

export function previewOf(glb: ArrayBuffer): ArrayBuffer {
  return changedScene(glb, (extras) => {
    Object.assign(extras, { inputs: [], results: [], texcoords: [], deformation: null });
    delete extras.levels;
    extras.presentation = { version: 1, results: [], effects: [] };
    extras.certificate = { notes: { preview: "the shape alone, while results were being read" } };
  });
}
