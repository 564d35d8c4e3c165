// SPDX-License-Identifier: Apache-2.0
// Numbers and units as people read them.

const UNITS: Record<string, string> = { degC: "°C", degF: "°F", um: "µm", degrees: "°" };

/** The unit as printed; an undeclared unit stays undeclared. */
export function unitText(unit: string | null | undefined): string {
  if (!unit) return "";
  return (UNITS[unit] ?? unit)
    .replace(/\bum\b/g, "µm")
    .replace(/\^?2\b/g, "²")
    .replace(/\^?3\b/g, "³");
}

/** Up to `digits` significant digits; no digit that the number does not have. */
export function numberText(value: number | null | undefined, digits = 6): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "no value";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(digits));
  if (size >= 1e7 || size < 1e-4) {
    const [mantissa, exponent] = rounded.toExponential().split("e");
    return `${mantissa}e${Number(exponent)}`;
  }
  return String(rounded);
}

/** All labels of an axis with the same number of decimals, enough to tell neighbours apart and no more. */
export function axisTexts(values: readonly number[]): string[] {
  const sorted = [...values].sort((a, b) => a - b);
  const size = Math.max(...values.map(Math.abs));
  let gap = Number.POSITIVE_INFINITY;
  for (let i = 1; i < sorted.length; ++i) gap = Math.min(gap, (sorted[i] ?? 0) - (sorted[i - 1] ?? 0));
  const exponential = size >= 1e6 || size < 1e-3;
  const decimals = 2 - Math.floor(Math.log10(gap));
  if (!(gap > 0) || exponential || decimals > 9) return values.map((v) => numberText(v, 4));
  return values.map((v) => v.toFixed(Math.max(decimals, 0)));
}

export function withUnit(value: number | null | undefined, unit: string | null | undefined): string {
  const text = numberText(value);
  const printed = unitText(unit);
  return value === null || value === undefined || !printed ? text : `${text} ${printed}`;
}

const SOLVER_WORDS: Record<string, string> = {
  static: "static",
  time: "time",
  mode: "mode",
  frequency: "frequency",
  buckling: "buckling",
};

export interface StepLike {
  readonly id: number;
  readonly kind: string;
  readonly number?: readonly number[];
  readonly value?: number | null;
  readonly unit?: string | null;
  readonly name?: string;
}

/** "Mode 3 · 172.844 Hz", "Step 1.4 · 480 s". */
export function stepText(step: StepLike): string {
  const value = step.value === null || step.value === undefined ? "" : withUnit(step.value, step.unit);
  const kind = SOLVER_WORDS[step.kind] ?? step.kind;
  const name = step.name?.trim() || `Step ${(step.number ?? [step.id]).join(".")}`;
  if (step.kind === "static") return `${name} · ${kind}`;
  return value ? `${name} · ${value}` : `${name} · ${kind}`;
}

/** A bound to two digits, never to less than it is. */
export function boundText(bound: number): string {
  if (!(bound > 0)) return "0";
  const place = 10 ** (Math.floor(Math.log10(bound)) - 1);
  return numberText(Math.ceil(bound / place - 1e-9) * place, 2);
}
