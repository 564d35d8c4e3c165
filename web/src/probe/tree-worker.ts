// SPDX-License-Identifier: Apache-2.0
// Runs beside the page: builds one hierarchy after the other.
import { growTree } from "./grow-tree";

export interface TreeTask {
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
}

self.onmessage = ({ data }: MessageEvent<TreeTask>) => {
  const tree = growTree(data.positions, data.indices);
  const carried = tree ? [tree.nodes, tree.order.buffer as ArrayBuffer] : [];
  self.postMessage(tree, { transfer: carried });
};
