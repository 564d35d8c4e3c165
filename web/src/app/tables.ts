// SPDX-License-Identifier: Apache-2.0
// Which tables can be saved: all visible nodes, notes and hot spots, one node over all steps.
import { MISSING } from "../scene";
import { stepText } from "../ui";
import type { App } from "./app";
import type { History } from "./features/history";
import type { HotSpots } from "./features/hot-spots";
import type { Notes } from "./features/notes";
import type { Shown } from "./model-view";
import type { Cell } from "./table";

export interface Table {
  readonly head: readonly string[];
  readonly rows: Iterable<readonly Cell[]>;
}

const heading = (shown: Shown) => (shown.unit ? `${shown.label} [${shown.unit}]` : shown.label);

function readValue(shown: Shown, part: number, vertex: number): number | null {
  const field = shown.fields[part];
  if (!field || field.state[vertex] === MISSING) return null;
  return field.values[vertex * field.components + shown.componentIndex] ?? null;
}

/** Each node of the visible skin once a part, as the solver numbered it. */
function* nodeRows(app: App, shown: readonly Shown[]): Generator<Cell[]> {
  const { scene } = app.view;
  const origin = scene.extras.origin ?? [0, 0, 0];
  for (const [index, part] of scene.parts.entries()) {
    if (app.store.state.hidden.includes(part.index)) continue;
    const seen = new Set<number>();
    for (let vertex = 0; vertex < part.nodeIds.length; ++vertex) {
      const node = part.nodeIds[vertex] ?? 0;
      if (node === 0 || seen.has(node)) continue;
      seen.add(node);
      const at = [0, 1, 2].map((a) => (part.positions[3 * vertex + a] ?? 0) + (origin[a] ?? 0));
      yield [node, part.info.name, ...at, ...shown.map((s) => readValue(s, index, vertex))];
    }
  }
}

export function nodeTable(app: App): Table {
  const shown = app.view.shown.filter((s) => s.result);
  const unit = app.view.scene.extras.lengthUnit?.name;
  const axes = ["x", "y", "z"].map((a) => (unit ? `${a} [${unit}]` : a));
  return { head: ["node", "part", ...axes, ...shown.map(heading)], rows: nodeRows(app, shown) };
}

export function placeTable(app: App): Table {
  const notes = app.feature<Notes>("notes").rows();
  const spots = app.feature<HotSpots>("hot-spots").found();
  const shown = app.view.shown.filter((s) => s.result);
  const values = (part: number, vertex: number) => shown.map((s) => readValue(s, part, vertex));
  return {
    head: ["what", "node", "note", ...shown.map(heading)],
    rows: [
      ...notes.map((n) => ["note", n.node, n.note, ...values(n.part, n.vertex)]),
      ...spots.map((f, i) => [
        `hot spot ${i + 1}`,
        f.spot.node,
        f.shown.label,
        ...values(f.spot.part, f.spot.vertex),
      ]),
    ],
  };
}

export function historyTable(app: App): Table {
  const lines = app.feature<History>("history").lines();
  const { steps } = app.view.scene.extras;
  return {
    head: [
      "step",
      "name",
      "value of the step",
      ...lines.map((l) => (l.unit ? `${l.label} [${l.unit}]` : l.label)),
    ],
    rows: steps.map((step) => [
      step.id,
      stepText(step),
      step.value ?? null,
      ...lines.map((l) => l.points.find((p) => p.step === step.id)?.value ?? null),
    ]),
  };
}
