// SPDX-License-Identifier: Apache-2.0
// What belongs to the person and not to the presentation: volume, mono, captions, strength, handedness,
// how moving is.

export interface Person {
  /** 0..1 */
  readonly master: number;
  readonly mono: boolean;
  readonly captions: boolean;
  /** Of vibration, 0..1.5. */
  readonly strength: number;
  readonly leftHanded: boolean;
  /** Tones over four octaves instead of three. */
  readonly wide: boolean;
  /** Amplitude of the weakest pulse, 0.08..0.4; null: the presentation's. */
  readonly weakest: number | null;
  /** How dark the edge of sight gets while a world moves fast, 0..1; 0: never. */
  readonly vignette: number;
  /** Two hands turn the model about the vertical alone. */
  readonly upright: boolean;
  /** In the headset a touch is heard and felt without a press. */
  readonly byTouch: boolean;
  /** W, A, S, D walk instead of what they mean otherwise. */
  readonly walkKeys: boolean;
}

const KEY = "feelem.person";
export const DEFAULT_PERSON: Person = Object.freeze({
  master: 0.5,
  mono: false,
  captions: true,
  strength: 1,
  leftHanded: false,
  wide: false,
  weakest: null,
  vignette: 1,
  upright: true,
  byTouch: false,
  walkKeys: false,
});

/** Whatever the storage holds, the answer can be used. */
export function personOf(value: unknown, fallback: Person = DEFAULT_PERSON): Person {
  const given = (typeof value === "object" && value !== null ? value : {}) as Record<string, unknown>;
  const within = (v: unknown, most: number, other: number) =>
    typeof v === "number" && v >= 0 && v <= most ? v : other;
  const flag = (v: unknown, other: boolean) => (typeof v === "boolean" ? v : other);
  return {
    master: within(given.master, 1, fallback.master),
    mono: flag(given.mono, fallback.mono),
    captions: flag(given.captions, fallback.captions),
    strength: within(given.strength, 1.5, fallback.strength),
    leftHanded: flag(given.leftHanded, fallback.leftHanded),
    wide: flag(given.wide, fallback.wide),
    weakest: given.weakest === null ? null : weakestOf(given.weakest, fallback.weakest),
    vignette: within(given.vignette, 1, fallback.vignette),
    upright: flag(given.upright, fallback.upright),
    byTouch: flag(given.byTouch, fallback.byTouch),
    walkKeys: flag(given.walkKeys, fallback.walkKeys),
  };
}

/** Weaker is not felt by everybody, stronger leaves no room above. */
export const WEAKEST: readonly [number, number] = [0.08, 0.4];

function weakestOf(value: unknown, other: number | null): number | null {
  return typeof value === "number" && value >= WEAKEST[0] && value <= WEAKEST[1] ? value : other;
}

/** What is remembered, else what the presentation suggests. */
export function rememberedPerson(suggested: unknown): Person {
  const first = personOf(suggested);
  try {
    return personOf(JSON.parse(localStorage.getItem(KEY) ?? "null"), first);
  } catch {
    return first;
  }
}

export function rememberPerson(person: Person): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(person));
  } catch {
    // Without storage it lasts as long as the page.
  }
}
