// SPDX-License-Identifier: Apache-2.0
// A result minus itself at another step, as a result: subtracted in double, rounded once, missing where either is.
import { INTERPOLATED, MISSING, type PartField, type SceneResult, SOLVER } from "./scene-types";

const made = new WeakMap<SceneResult, Map<number, SceneResult>>();

/** The same object each time, so that who compares results knows it again. */
export function differenceResult(result: SceneResult, step: number, stepName: string): SceneResult {
  const known = made.get(result) ?? new Map<number, SceneResult>();
  made.set(result, known);
  let difference = known.get(step);
  if (!difference) {
    difference = {
      ...result,
      id: `${result.id} minus step ${step}`,
      name: `${result.name} − ${stepName}`,
      quantity: `${result.quantity ?? result.id} minus step ${step}`,
      derived: true,
      minus: { result, step },
      // The scene states no extremes of a difference: those of the skin stand in.
      values: result.values.map((v) => ({ step: v.step, accessors: [], min: null, max: null })),
    };
    known.set(step, difference);
  }
  return difference;
}

export function differenceField(one: PartField | null, two: PartField | null): PartField | null {
  if (!one || !two) return null;
  const { components } = one;
  const values = new Float32Array(one.values.length);
  const state = new Uint8Array(one.state.length);
  for (let i = 0; i < state.length; ++i) {
    const gone = one.state[i] === MISSING || two.state[i] === MISSING;
    const filled = one.state[i] === INTERPOLATED || two.state[i] === INTERPOLATED;
    state[i] = gone ? MISSING : filled ? INTERPOLATED : SOLVER;
    for (let c = 0; c < components; ++c) {
      const at = i * components + c;
      values[at] = gone ? Number.NaN : (one.values[at] ?? Number.NaN) - (two.values[at] ?? Number.NaN);
    }
  }
  return { components, values, state };
}
