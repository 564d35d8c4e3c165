// SPDX-License-Identifier: Apache-2.0
// Writes a curved sheet, one brick thick, with NDTEMP, DISP and STRESS at many steps as a binary .frd: the same bytes every time.
import { closeSync, openSync, writeSync } from "node:fs";

const RADIUS = 500;
const THICKNESS = 6;
const LENGTH = 900;
const ARC = 2.4;
const LITTLE = true;

const padded = (value, width) => String(value).padStart(width);

/** Nodes are numbered along the arc first, then along the axis, then outward; ids from 1. */
function sheet(cells) {
  const side = cells + 1;
  const node = (i, j, k) => 1 + i + side * (j + side * k);
  const place = (i, j, k) => {
    const angle = (ARC * i) / cells - ARC / 2;
    const radius = RADIUS + k * THICKNESS + 14 * Math.sin((9 * j) / cells) * Math.cos(6 * angle);
    return [radius * Math.sin(angle), (LENGTH * j) / cells, radius * Math.cos(angle)];
  };
  return { side, node, place, nodes: 2 * side * side, elements: cells * cells };
}

/** Values at a node: t runs from 0 to 1 over the steps. Smooth, with a hot spot that travels. */
function valuesAt(u, v, k, t) {
  const spot = Math.exp(-40 * ((u - t) ** 2 + (v - 0.5) ** 2));
  const temperature = 20 + 180 * spot + 15 * u * t + 2 * k;
  const swell = 12 * spot + 4 * t * Math.sin(3.1 * v);
  const displacement = [swell * (u - 0.5), 0.4 * swell * (v - 0.5), swell];
  const s = 220 * spot + 60 * t * Math.cos(5 * v) + 10 * k;
  const stress = [s, 0.6 * s - 20 * u, -0.3 * s, 25 * spot * (v - 0.5), -12 * t * u, 8 * u * v];
  return { temperature, displacement, stress };
}

const RESULTS = [
  { name: "NDTEMP", rows: [" -5  T           1    1    0    0"], size: 1, pick: (at) => [at.temperature] },
  {
    name: "DISP",
    rows: [1, 2, 3]
      .map((c) => ` -5  D${c}          1    2    ${c}    0`)
      .concat(" -5  ALL         1    2    0    0    1ALL"),
    size: 3,
    pick: (at) => at.displacement,
  },
  {
    name: "STRESS",
    rows: ["XX 1 1", "YY 2 2", "ZZ 3 3", "XY 1 2", "YZ 2 3", "ZX 3 1"].map((row) => {
      const [axes, one, two] = row.split(" ");
      return ` -5  S${axes}         1    4    ${one}    ${two}`;
    }),
    size: 6,
    pick: (at) => at.stress,
  },
];

function writeRecords(file, count, words, fill) {
  const bytes = Buffer.alloc(4 * count * words);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  for (let i = 0; i < count; ++i) fill(view, 4 * i * words, i);
  writeSync(file, bytes);
}

/** `cells` bricks each way (8 * cells² triangles and those of the rim), `parts` x `parts` materials. */
export function makeModel(path, { cells, steps, parts = 1 }) {
  const { side, node, place, nodes, elements } = sheet(cells);
  const file = openSync(path, "w");
  const line = (text) => writeSync(file, `${text}\n`);
  line("    1C");
  line("    1UPGM               CalculiX");
  line("    1UVERSION           Version 2.20");
  line(`    2C${padded(nodes, 30)}${padded(2, 38)}`);
  const grid = (n) => [n % side, Math.floor(n / side) % side, Math.floor(n / (side * side))];
  writeRecords(file, nodes, 4, (view, at, n) => {
    view.setInt32(at, n + 1, LITTLE);
    for (const [c, x] of place(...grid(n)).entries()) view.setFloat32(at + 4 + 4 * c, x, LITTLE);
  });
  line(`    3C${padded(elements, 30)}${padded(2, 38)}`);
  const patch = (i) => Math.floor((i * parts) / cells);
  writeRecords(file, elements, 12, (view, at, e) => {
    const [i, j] = [e % cells, Math.floor(e / cells)];
    const material = 1 + patch(i) + parts * patch(j);
    const ring = [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ];
    const corners = [0, 1].flatMap((k) => ring.map(([di, dj]) => node(i + di, j + dj, k)));
    for (const [w, word] of [e + 1, 1, 0, material, ...corners].entries())
      view.setInt32(at + 4 * w, word, LITTLE);
  });
  for (let step = 1; step <= steps; ++step) {
    const t = steps > 1 ? (step - 1) / (steps - 1) : 0;
    for (const { name, rows, size, pick } of RESULTS) {
      line(`    1PSTEP${padded(step, 26)}${padded(step, 12)}${padded(1, 12)}`);
      const head = `  100CL  101${padded((0.5 * step).toFixed(9), 12)}${padded(nodes, 12)}`;
      line(`${head}${padded(0, 22)}${padded(step, 5)}${padded(2, 12)}`);
      line(` -4  ${name.padEnd(8)}${padded(rows.length, 5)}    1`);
      for (const row of rows) line(row);
      writeRecords(file, nodes, 1 + size, (view, at, n) => {
        const [i, j, k] = grid(n);
        view.setInt32(at, n + 1, LITTLE);
        const values = pick(valuesAt(i / cells, j / cells, k, t));
        for (const [c, x] of values.entries()) view.setFloat32(at + 4 + 4 * c, x, LITTLE);
      });
    }
  }
  line(" 9999");
  closeSync(file);
}
