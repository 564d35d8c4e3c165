// SPDX-License-Identifier: Apache-2.0
// How fine the picture is while it moves, from the times of frames alone. It knows nothing of values: what is read, heard
// and felt is the same at every level.

/** What a level draws. */
export interface Level {
  /** Of the pixels along each side. */
  readonly resolution: number;
  /** Lines of elements. */
  readonly edges: boolean;
  /** Of the skin at most, where the scene has levels of detail. */
  readonly triangles: number;
}

const FEW = 500_000;
const FEWEST = 125_000;
/** What a headset draws in time, whatever its frames say: it must not drop any before it is known to be slow. */
export const HEADSET_TRIANGLES = FEW;

export const LEVELS: readonly Level[] = [
  { resolution: 1, edges: true, triangles: Number.POSITIVE_INFINITY },
  { resolution: 0.75, edges: true, triangles: FEW },
  { resolution: 0.6, edges: false, triangles: FEW },
  { resolution: 0.45, edges: false, triangles: FEWEST },
  { resolution: 0.33, edges: false, triangles: FEWEST },
];
export const FINEST: Level = LEVELS[0] ?? { resolution: 1, edges: true, triangles: FEW };

/** Which level of a scene fits: 0 for all triangles, else counted from 1, from fine to coarse. The coarsest when none does. */
export function levelWithin(budget: number, all: number, levels: readonly number[]): number {
  if (all <= budget || levels.length === 0) return 0;
  const found = levels.findIndex((triangles) => triangles <= budget);
  return found < 0 ? levels.length : found + 1;
}

export interface Governor {
  readonly level: number;
  /** Of the frames since the level changed, milliseconds, the latest last. */
  readonly times: readonly number[];
  /** Rounds that must be quick before a finer level is tried: more each time it was tried in vain. */
  readonly patience: number;
  readonly quickRounds: number;
  /** Whether this level was come to from a coarser one. */
  readonly tried: boolean;
}

export const AT_FIRST: Governor = { level: 0, times: [], patience: 1, quickRounds: 0, tried: false };

/** Milliseconds: what a frame may take, and how often the display shows one at most. */
export interface Pace {
  readonly budget: number;
  readonly interval: number;
}

/** Frames that are looked at together. */
export const ROUND = 6;
const MOST_PATIENCE = 16;
/** Of the budget: past it the picture gets coarser. */
const TOO_SLOW = 1.25;
/** Of the budget: two levels at once. */
const FAR_TOO_SLOW = 4;
/** Of the budget: what a finer level may be expected to take. */
const QUICK = 0.9;
/** Of the display's interval: as quick as frames can be seen to be, whatever they really took. */
const AS_QUICK_AS_SHOWN = 1.1;
/** A page that was asleep says nothing of its frames. */
const ASLEEP_MS = 3000;

function medianOf(times: readonly number[]): number {
  const sorted = [...times].sort((a, b) => a - b);
  return sorted[sorted.length >> 1] ?? 0;
}

/** Worst case: all time goes into pixels. */
function costOfFiner(level: number): number {
  const ratio = (LEVELS[level - 1]?.resolution ?? 1) / (LEVELS[level]?.resolution ?? 1);
  return ratio * ratio;
}

/** After one more frame that took `ms`. */
export function govern(governor: Governor, ms: number, { budget, interval }: Pace): Governor {
  if (!(ms > 0 && ms < ASLEEP_MS)) return governor;
  const times = [...governor.times, ms];
  if (times.length < ROUND) return { ...governor, times };
  const median = medianOf(times);
  const { level, patience, tried } = governor;
  if (median > TOO_SLOW * budget) {
    const coarser = Math.min(level + (median > FAR_TOO_SLOW * budget ? 2 : 1), LEVELS.length - 1);
    if (coarser === level) return { ...governor, times: [], quickRounds: 0 };
    const longer = tried ? Math.min(2 * patience, MOST_PATIENCE) : patience;
    return { level: coarser, times: [], patience: longer, quickRounds: 0, tried: false };
  }
  const quick = median * costOfFiner(level) <= QUICK * budget || median <= AS_QUICK_AS_SHOWN * interval;
  if (level === 0 || !quick) return { ...governor, times: [], quickRounds: 0 };
  const quickRounds = governor.quickRounds + 1;
  if (quickRounds < patience) return { ...governor, times: [], quickRounds };
  return { level: level - 1, times: [], patience, quickRounds: 0, tried: true };
}
