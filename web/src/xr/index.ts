// SPDX-License-Identifier: Apache-2.0
// The headset.
export { askForVr, requestVr, type VrAnswer } from "./enter";
export { Grab, type GripPose } from "./grab";
export { onTable, placeBefore, standOf, TABLE_DISTANCE, TABLE_HEIGHT, TABLE_SIZE } from "./room";
export { VrSession } from "./vr-session";
