// SPDX-License-Identifier: Apache-2.0
// The page sends the pulses of tests/contract/pulses.json, frame by frame, as the native viewer does.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { createHaptics, type HapticEvent, type HapticFrame } from "../../src/sense";

interface Step {
  frames: number;
  touch?: HapticFrame;
  event?: string;
  stop?: boolean;
  strength?: number;
}
interface Case {
  name: string;
  hz: number;
  steps: Step[];
  pulses: [frame: number, strength: number, milliseconds: number, cause: string][];
}

const path = new URL("../../../tests/contract/pulses.json", import.meta.url);
const { cases } = JSON.parse(readFileSync(path, "utf8")) as { cases: Case[] };

/** The page has one event for both directions of a band, and none that a missing value is felt by. */
function pageEvent(name: string): HapticEvent | null {
  if (name === "noValue") return null;
  return name.startsWith("band") ? "band" : (name as HapticEvent);
}

function play({ hz, steps }: Case): Case["pulses"] {
  const haptics = createHaptics();
  haptics.setActuator({ pulse: () => {} });
  const pulses: Case["pulses"] = [];
  let frame = 0;
  for (const step of steps) {
    if (step.strength !== undefined) haptics.setStrength(step.strength);
    if (step.stop) haptics.stop();
    const event = step.event === undefined ? null : pageEvent(step.event);
    if (event) haptics.event(event);
    for (let i = 0; i < step.frames; i++, frame++) {
      haptics.update(step.touch ?? null);
      haptics.tick(frame / hz);
      const sent = haptics.pulses().at(-1);
      if (sent && sent.time === frame / hz) {
        pulses.push([frame, sent.strength, sent.milliseconds, sent.cause]);
      }
    }
  }
  return pulses;
}

test("the contract has pulses of every cause", () => {
  const causes = new Set(cases.flatMap((c) => c.pulses.map((p) => p[3])));
  expect([...causes].sort()).toEqual(
    ["bandDown", "bandUp", "beat", "enter", "limitDown", "limitUp", "maximum", "minimum"].sort(),
  );
});

test.each(cases)("pulses: $name", (c) => {
  const expected = c.pulses.map(([frame, strength, ms, cause]) => [
    frame,
    strength,
    ms,
    cause === "beat" ? cause : pageEvent(cause),
  ]);
  expect(play(c)).toEqual(expected);
});
