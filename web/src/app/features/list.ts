// SPDX-License-Identifier: Apache-2.0
// The list of features, in the order of their sections. A new one is a file beside this and a line here.
import type { App } from "../app";
import { BeaconFeature } from "./beacon";
import { Calibration } from "./calibration";
import { Connect } from "./connect";
import { Cuts } from "./cuts";
import { Device } from "./device";
import { Difference } from "./difference";
import type { Feature } from "./feature";
import { History } from "./history";
import { HotSpots } from "./hot-spots";
import { Inside } from "./inside";
import { Levels } from "./levels";
import { Limits } from "./limits";
import { Links } from "./links";
import { Listening } from "./listening";
import { Notes } from "./notes";
import { Palette } from "./palette";
import { Parts } from "./parts";
import { Path } from "./path";
import { Save } from "./save";
import { Sweep } from "./sweep";
import { Variants } from "./variants";
import { Vectors } from "./vectors";
import { Walking } from "./walking";

export function makeFeatures(app: App): readonly Feature[] {
  return [
    new Variants(app),
    new Limits(app),
    new HotSpots(app),
    new Parts(app),
    new Cuts(app),
    new Inside(app),
    new Vectors(app),
    new History(app),
    new Listening(app),
    new Calibration(app),
    new BeaconFeature(app),
    new Path(app),
    new Sweep(app),
    new Difference(app),
    new Notes(app),
    new Save(app),
    new Connect(),
    new Walking(app),
    new Levels(app),
    new Device(app),
    new Links(app),
    new Palette(app),
  ];
}
