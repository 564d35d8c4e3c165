// SPDX-License-Identifier: Apache-2.0
// Results that were read, as many as there is room for: what was not asked for longest goes first.
import type { PartField } from "./scene-types";

export type FieldList = readonly (PartField | null)[];

interface Entry {
  readonly field: Promise<FieldList>;
  bytes: number;
}

function bytesOf(fields: FieldList): number {
  return fields.reduce((sum, f) => sum + (f ? f.values.byteLength + f.state.byteLength : 0), 0);
}

export class FieldCache {
  readonly #room: number;
  readonly #entries = new Map<string, Entry>();
  #bytes = 0;

  constructor(room: number) {
    this.#room = room;
  }

  /** Bytes of what is kept. */
  get bytes(): number {
    return this.#bytes;
  }

  get(key: string, read: () => Promise<FieldList>): Promise<FieldList> {
    const known = this.#entries.get(key);
    if (known) {
      this.#entries.delete(key);
      this.#entries.set(key, known);
      return known.field;
    }
    const entry: Entry = { field: read(), bytes: 0 };
    this.#entries.set(key, entry);
    entry.field.then(
      (fields) => {
        if (this.#entries.get(key) !== entry) return;
        entry.bytes = bytesOf(fields);
        this.#bytes += entry.bytes;
        this.#shrink(key);
      },
      () => this.#entries.delete(key),
    );
    return entry.field;
  }

  #shrink(last: string): void {
    for (const [key, entry] of this.#entries) {
      if (this.#bytes <= this.#room) return;
      if (key === last || entry.bytes === 0) continue;
      this.#entries.delete(key);
      this.#bytes -= entry.bytes;
    }
  }
}
