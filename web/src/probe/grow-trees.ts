// SPDX-License-Identifier: Apache-2.0
// The hierarchies of all parts: of a large model in a worker, so that the page stays awake.
import type { ScenePart } from "../scene";
import { growTree, type TreeData } from "./grow-tree";
import type { TreeTask } from "./tree-worker";

/** Triangles above which a worker is worth its start. */
const WORKER_FROM = 150_000;

function askWorker(worker: Worker, part: ScenePart): Promise<TreeData | null> {
  // The worker gets copies, so that the page can go on drawing and reading; one part at a time.
  const task: TreeTask = { positions: part.positions.slice(), indices: part.indices.slice() };
  return new Promise((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<TreeData | null>) => resolve(data);
    worker.onerror = (event) => reject(new Error(event.message));
    worker.postMessage(task, [task.positions.buffer, task.indices.buffer]);
  });
}

async function growAside(parts: readonly ScenePart[]): Promise<(TreeData | null)[]> {
  const worker = new Worker(new URL("./tree-worker.ts", import.meta.url), { type: "module" });
  try {
    const trees: (TreeData | null)[] = [];
    for (const part of parts) trees.push(await askWorker(worker, part));
    return trees;
  } finally {
    worker.terminate();
  }
}

export async function growTrees(parts: readonly ScenePart[]): Promise<(TreeData | null)[]> {
  const triangles = parts.reduce((sum, part) => sum + part.indices.length / 3, 0);
  if (triangles >= WORKER_FROM && typeof Worker !== "undefined") {
    try {
      return await growAside(parts);
    } catch (error) {
      console.warn("no worker for the hierarchy; it is built on the page", error);
    }
  }
  return parts.map((part) => growTree(part.positions, part.indices));
}
