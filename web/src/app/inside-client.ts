// SPDX-License-Identifier: Apache-2.0
// Questions to the server about the inside of the model (docs/serving.md): the newest of a kind wins, a busy server is
// asked again.
import type { InteriorAnswer } from "../probe";
import { readSection, type SectionData } from "../scene";

/** A component of a result of the scene. */
export interface AskedField {
  readonly result: string;
  readonly component: number;
}
export interface AskedShape {
  readonly result: string;
  readonly factor: number;
}

interface PointAnswer {
  readonly element: number | null;
  readonly type?: string;
  readonly nodes?: readonly number[];
  readonly weights?: readonly number[];
  readonly results: readonly {
    readonly value: number | null;
    readonly elemental: boolean;
    readonly nodeValues: readonly (number | null)[];
  }[];
}

const BUSY = 503;
const SUPERSEDED = 409;
const TRIES = 40;

/** Was given up, by us or by a newer question: nothing to say of it. */
export function isGivenUp(error: unknown): boolean {
  return error instanceof DOMException && error.name === "AbortError";
}

const pause = (milliseconds: number, signal: AbortSignal) =>
  new Promise<void>((resolve, reject) => {
    const timer = setTimeout(resolve, milliseconds);
    signal.addEventListener("abort", () => {
      clearTimeout(timer);
      reject(signal.reason);
    });
  });

const fieldText = ({ result, component }: AskedField) => `${result}:${component}`;

export class InsideClient {
  readonly #base: string;
  readonly #origin: readonly [number, number, number];
  /** Tells this page from others behind the same address. */
  readonly #id = crypto.getRandomValues(new Uint32Array(2)).join("_");
  readonly #asking = new Map<string, AbortController>();

  constructor(base: string, origin: readonly [number, number, number]) {
    this.#base = base;
    this.#origin = origin;
  }

  /** Null: the page's server has no volume elements, only the scene. */
  static find(origin: readonly [number, number, number]): InsideClient | null {
    const meta = document.querySelector<HTMLMetaElement>("meta[name=feelem-inside]");
    return meta ? new InsideClient(meta.content, origin) : null;
  }

  /** Gives up what was asked under that name. */
  giveUp(slot: string): void {
    this.#asking.get(slot)?.abort();
    this.#asking.delete(slot);
  }

  async #ask(slot: string, path: string, keys: Record<string, string>): Promise<Response> {
    this.giveUp(slot);
    const controller = new AbortController();
    this.#asking.set(slot, controller);
    const { signal } = controller;
    const query = new URLSearchParams({ ...keys, client: `${this.#id}_${slot}` });
    try {
      for (let tries = 0; ; ++tries) {
        const response = await fetch(`${this.#base}${path}?${query}`, { signal });
        if (response.ok) return response;
        const reason = (await response.text()).trim();
        if (response.status === SUPERSEDED) throw new DOMException(reason, "AbortError");
        if (response.status !== BUSY || tries >= TRIES) throw new Error(reason);
        await pause(1000 * Number(response.headers.get("Retry-After") ?? 1), signal);
      }
    } finally {
      if (this.#asking.get(slot) === controller) this.#asking.delete(slot);
    }
  }

  /** Triangles where a plane of the solver's coordinates cuts the solids. */
  async section(
    slot: string,
    plane: { readonly normal: readonly number[]; readonly offset: number },
    field: AskedField,
    step: number,
    shape: AskedShape | null,
  ): Promise<SectionData> {
    const response = await this.#ask(slot, "section", {
      plane: [...plane.normal, plane.offset].join(","),
      result: fieldText(field),
      step: String(step),
      ...(shape ? { shape: `${shape.result},${shape.factor}` } : {}),
    });
    return readSection(await response.arrayBuffer(), this.#origin);
  }

  /** Triangles where a result has a value. */
  async surface(
    slot: string,
    field: AskedField,
    value: number,
    step: number,
    shape: AskedShape | null,
  ): Promise<SectionData> {
    const response = await this.#ask(slot, "surface", {
      value: String(value),
      result: fieldText(field),
      step: String(step),
      ...(shape ? { shape: `${shape.result},${shape.factor}` } : {}),
    });
    return readSection(await response.arrayBuffer(), this.#origin);
  }

  /** Values at a place of the solver's coordinates, by key; without a key the field is not asked for. */
  async point(
    slot: string,
    at: readonly number[],
    fields: ReadonlyMap<string, AskedField>,
    step: number,
    shape: AskedShape | null,
  ): Promise<InteriorAnswer> {
    const response = await this.#ask(slot, "point", {
      at: at.join(","),
      results: [...fields.values()].map(fieldText).join(","),
      step: String(step),
      ...(shape ? { shape: `${shape.result},${shape.factor}` } : {}),
    });
    return answerOf((await response.json()) as PointAnswer, [...fields.keys()]);
  }
}

/** The float32 that the shortest decimal stands for. */
const floatOf = (number: number | null | undefined) =>
  number === null || number === undefined ? null : Math.fround(number);

export function answerOf(answer: PointAnswer, keys: readonly string[]): InteriorAnswer {
  const weights = answer.weights ?? [];
  const nodes = answer.nodes ?? [];
  let best = -1;
  for (const [i, weight] of weights.entries()) {
    const most = weights[best] ?? Number.NEGATIVE_INFINITY;
    if (weight > most || (weight === most && (nodes[i] ?? 0) < (nodes[best] ?? 0))) best = i;
  }
  return {
    elementId: answer.element,
    elementType: answer.type ?? "",
    nodeId: nodes[best] ?? null,
    values: new Map(
      keys.map((key, i) => {
        const read = answer.results[i];
        const nodeValue = read?.elemental ? null : floatOf(read?.nodeValues[best]);
        return [key, { value: floatOf(read?.value), nodeValue }];
      }),
    ),
  };
}
