// SPDX-License-Identifier: Apache-2.0
// The node that a command without a number means.
import type { App } from "./app";
import type { History } from "./features/history";

/** Under the pointer, else pressed or gone to last. */
export function chosenNode(app: App): number | null {
  return app.probing.report()?.nodeId ?? app.feature<History>("history").chosen()?.node ?? null;
}
