// SPDX-License-Identifier: Apache-2.0
// Results that were read, as many as there is room for: what was not asked for longest goes first.
import type { PartField } from "./scene-types";

export type FieldList = readonly (PartField | null)[];

interface Entry {
  readonly field: Promise<FieldList>;
  bytes: number;
}

export class FieldCache {
  readonly #room: number;
  readonly #counts: (buffer: ArrayBufferLike) => boolean;
  readonly #entries = new Map<string, Entry>();
  #bytes = 0;

  /** `counts`: whether letting a buffer go would make room. */
  constructor(room: number, counts: (buffer: ArrayBufferLike) => boolean = () => true) {
    this.#room = room;
    this.#counts = counts;
  }

  /** Parts share the buffer of a side file. */
  #bytesOf(fields: FieldList): number {
    const buffers = new Set(fields.flatMap((f) => (f ? [f.values.buffer, f.state.buffer] : [])));
    return [...buffers].reduce((sum, b) => sum + (this.#counts(b) ? b.byteLength : 0), 0);
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
        entry.bytes = this.#bytesOf(fields);
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
