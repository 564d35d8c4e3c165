// SPDX-License-Identifier: Apache-2.0
// The binary part of a scene, whole or as it comes: of a stream only what the page will read is kept.
import { type Container, type GltfJson, parseJson, readHead } from "./gltf";
import { storedOf } from "./packed-view";
import { SceneError } from "./scene-types";

const CUT_OFF = "the scene is cut off: the file ends before its data";
/** Bytes: an array of a million triangles' corners fits. */
const FIRST_ROOM = 16 << 20;
const CHUNK_JSON = 0x4e4f534a;
const CHUNK_BIN = 0x004e4942;

/** The bytes of a bufferView of the scene's own buffer. */
export interface OwnBytes {
  view(index: number): Promise<Uint8Array>;
  /** Nobody will ask for these again. */
  release(views: Iterable<number>): void;
}

export class WholeBytes implements OwnBytes {
  readonly #json: GltfJson;
  readonly #bin: Uint8Array | null;

  constructor(container: Container) {
    this.#json = container.json;
    this.#bin = container.bin;
  }

  async view(index: number): Promise<Uint8Array> {
    const view = this.#json.bufferViews?.[index];
    if (!this.#bin || !view) throw new SceneError("the scene's binary part is missing");
    const { start, length } = storedOf(view);
    if (!(start >= 0) || start + length > this.#bin.byteLength) throw new SceneError(CUT_OFF);
    return this.#bin.subarray(start, start + length);
  }

  release(): void {}
}

/** Bytes from a stream, so many at a time. */
class Feed {
  readonly #reader: ReadableStreamDefaultReader<Uint8Array>;
  #rest: Uint8Array = new Uint8Array(0);

  constructor(stream: ReadableStream<Uint8Array>) {
    this.#reader = stream.getReader();
  }

  /** At most so many of the next bytes; none at the end. */
  async some(most: number): Promise<Uint8Array> {
    while (this.#rest.byteLength === 0) {
      const { done, value } = await this.#reader.read();
      if (done) break;
      this.#rest = value;
    }
    const piece = this.#rest.subarray(0, most);
    this.#rest = this.#rest.subarray(piece.byteLength);
    return piece;
  }

  /** Exactly so many, or all that come: a length in a file is not believed before its bytes are there. */
  async gather(most: number): Promise<Uint8Array> {
    const pieces: Uint8Array[] = [];
    let length = 0;
    while (length < most) {
      const piece = await this.some(most - length);
      if (piece.byteLength === 0) break;
      pieces.push(piece);
      length += piece.byteLength;
    }
    const whole = new Uint8Array(length);
    let at = 0;
    for (const piece of pieces) {
      whole.set(piece, at);
      at += piece.byteLength;
    }
    return whole;
  }

  async pass(count: number): Promise<void> {
    for (let left = count; left > 0; ) {
      const piece = await this.some(left);
      if (piece.byteLength === 0) throw new SceneError(CUT_OFF);
      left -= piece.byteLength;
    }
  }

  /** Exactly so many; room is made as they come, since the length may be a lie. */
  async take(size: number): Promise<Uint8Array> {
    let bytes = new Uint8Array(Math.min(size, FIRST_ROOM));
    for (let at = 0; at < size; ) {
      if (at === bytes.byteLength) {
        const larger = new Uint8Array(Math.min(size, 2 * at));
        larger.set(bytes);
        bytes = larger;
      }
      const piece = await this.some(bytes.byteLength - at);
      if (piece.byteLength === 0) throw new SceneError(CUT_OFF);
      bytes.set(piece, at);
      at += piece.byteLength;
    }
    return bytes;
  }

  end(): void {
    this.#reader.cancel().catch(() => {});
  }
}

/** Views that overlap come together. */
interface Segment {
  readonly start: number;
  end: number;
  readonly bytes: Promise<Uint8Array>;
  readonly came: (bytes: Uint8Array) => void;
  readonly failed: (reason: unknown) => void;
}

function segmentFrom(start: number, end: number): Segment {
  let came: Segment["came"] = () => {};
  let failed: Segment["failed"] = () => {};
  const bytes = new Promise<Uint8Array>((resolve, reject) => {
    came = resolve;
    failed = reject;
  });
  // Who waits for it hears of it; when nobody does, nobody needs to.
  bytes.catch(() => {});
  return { start, end, bytes, came, failed };
}

export class ComingBytes implements OwnBytes {
  readonly #json: GltfJson;
  readonly #segments: Segment[] = [];
  readonly #ofView = new Map<number, Segment>();

  constructor(json: GltfJson, wanted: Iterable<number>) {
    this.#json = json;
    const views = [...new Set(wanted)].flatMap((index) => {
      const view = json.bufferViews?.[index];
      if (!view) return [];
      const { start, length } = storedOf(view);
      return start >= 0 && length >= 0 ? [{ index, start, end: start + length }] : [];
    });
    views.sort((a, b) => a.start - b.start);
    for (const { index, start, end } of views) {
      let segment = this.#segments.at(-1);
      if (segment && start < segment.end) segment.end = Math.max(segment.end, end);
      else {
        segment = segmentFrom(start, end);
        this.#segments.push(segment);
      }
      this.#ofView.set(index, segment);
    }
  }

  async view(index: number): Promise<Uint8Array> {
    const segment = this.#ofView.get(index);
    const view = this.#json.bufferViews?.[index];
    if (!segment || !view) throw new SceneError("the scene's binary part is missing");
    const { start, length } = storedOf(view);
    const from = start - segment.start;
    return (await segment.bytes).subarray(from, from + length);
  }

  release(views: Iterable<number>): void {
    for (const index of views) this.#ofView.delete(index);
  }

  /** No more will come. */
  fail(reason: unknown): void {
    for (const segment of this.#segments) segment.failed(reason);
  }

  /** Takes the bytes of the binary chunk, in the order of the file, and ends with the last that is wanted. */
  async pump(feed: Feed, length: number): Promise<void> {
    let at = 0;
    try {
      for (const segment of this.#segments) {
        if (segment.end > length) throw new SceneError(CUT_OFF);
        await feed.pass(segment.start - at);
        segment.came(await feed.take(segment.end - segment.start));
        at = segment.end;
      }
    } catch (error) {
      this.fail(error);
    }
    this.#segments.length = 0;
    feed.end();
  }
}

export interface ComingScene {
  readonly json: GltfJson;
  /** `wanted`: bufferViews of the scene's own buffer that will be read. */
  start(wanted: Iterable<number>): OwnBytes;
}

/** The head of a scene that is still coming. */
export async function readComing(stream: ReadableStream<Uint8Array>): Promise<ComingScene> {
  const feed = new Feed(stream);
  const head = await feed.gather(12);
  if (!readHead(head)) {
    const rest = await feed.gather(Number.POSITIVE_INFINITY);
    const text = new Uint8Array(head.byteLength + rest.byteLength);
    text.set(head);
    text.set(rest, head.byteLength);
    const json = parseJson(text);
    return { json, start: () => new WholeBytes({ json, bin: null }) };
  }
  const nextChunk = async () => {
    const bytes = await feed.gather(8);
    if (bytes.byteLength < 8) return null;
    const view = new DataView(bytes.buffer);
    return { length: view.getUint32(0, true), type: view.getUint32(4, true) };
  };
  const first = await nextChunk();
  if (first?.type !== CHUNK_JSON) throw new SceneError("the scene has no JSON chunk");
  const text = await feed.gather(first.length);
  if (text.byteLength < first.length) throw new SceneError(CUT_OFF);
  const json = parseJson(text);
  const start = (wanted: Iterable<number>): OwnBytes => {
    const own = new ComingBytes(json, wanted);
    void nextChunk().then(
      (chunk) => own.pump(feed, chunk?.type === CHUNK_BIN ? chunk.length : 0),
      (error: unknown) => own.fail(error),
    );
    return own;
  };
  return { json, start };
}
