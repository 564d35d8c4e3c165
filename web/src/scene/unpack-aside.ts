// SPDX-License-Identifier: Apache-2.0
// Has arrays unpacked in a worker, so that the page stays awake.
import type { Packed } from "./packed-view";
import { SceneError } from "./scene-types";
import type { UnpackAnswer, UnpackTask } from "./unpack-worker";

export type Unpack = (bytes: Uint8Array, packed: Packed) => Promise<Uint8Array<ArrayBuffer>>;

interface Waiting {
  readonly resolve: (rows: Uint8Array<ArrayBuffer>) => void;
  readonly reject: (reason: SceneError) => void;
}

const refused = (why: string) => new SceneError(`a packed array cannot be read: ${why}`);

/** Starts its worker when the first array asks for it, and lets it go when none has asked for a while. */
class Unpacker {
  #worker: Worker | null = null;
  #next = 0;
  #idle: ReturnType<typeof setTimeout> | undefined;
  readonly #waiting = new Map<number, Waiting>();

  run(bytes: Uint8Array, packed: Packed): Promise<Uint8Array<ArrayBuffer>> {
    clearTimeout(this.#idle);
    this.#worker ??= this.#start();
    const worker = this.#worker;
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      const own = bytes.slice();
      worker.postMessage({ id, bytes: own, packed } satisfies UnpackTask, [own.buffer]);
    });
  }

  #start(): Worker {
    const worker = new Worker(new URL("./unpack-worker.ts", import.meta.url), { type: "module" });
    worker.onmessage = ({ data }: MessageEvent<UnpackAnswer>) => this.#answer(data);
    worker.onerror = (event) => {
      for (const { reject } of this.#waiting.values()) reject(refused(event.message || "its worker failed"));
      this.#waiting.clear();
      this.#stop();
    };
    return worker;
  }

  #answer({ id, rows, error }: UnpackAnswer): void {
    const one = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (rows) one?.resolve(rows);
    else one?.reject(refused(error ?? ""));
    if (this.#waiting.size === 0) this.#idle = setTimeout(() => this.#stop(), 20_000);
  }

  #stop(): void {
    this.#worker?.terminate();
    this.#worker = null;
  }
}

/** One worker a scene. */
export function unpackAside(): Unpack {
  const unpacker = new Unpacker();
  return (bytes, packed) => unpacker.run(bytes, packed);
}
