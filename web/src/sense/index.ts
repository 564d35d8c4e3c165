// SPDX-License-Identifier: Apache-2.0
// Sound and vibration. Per frame: sound.update(frame or null), haptics.update(frame or null), haptics.tick(seconds).
export { createSound, defaultSound, type Sound, type SoundFrame, type SoundOptions } from "./audio";
export { Beacon, beaconRate, directionWords, type HeadDirection } from "./beacon";
export type { EventKind } from "./earcons";
export { EventWatch, type ProbeState, type SenseEvent, type SenseLimit } from "./events";
export { guideRate, rankOf } from "./guidance";
export {
  type Actuator,
  actuatorOf,
  actuatorOfDevice,
  createHaptics,
  type HapticEvent,
  type HapticFrame,
  type Haptics,
  type SentPulse,
} from "./haptics";
export { stopWhenLeft } from "./leave";
export { type LegendMoment, pitchLegend, pulseLegend, type SensedLegend, tickLegend } from "./legend";
