// SPDX-License-Identifier: Apache-2.0
// A small bar as a scene by the contract of docs/scene-format.md, with values that tests can compute by formula.

export interface TinyOptions {
  /** Step 2 goes into tiny.d/*.bin beside the scene. */
  sideFiles?: boolean;
  /** Bricks along x, y and z. */
  cells?: readonly [number, number, number];
  /** Bars side by side along y, each a part; the second's node and element ids start 10,000 higher. */
  bars?: number;
  /** Steps of kind time after the two of every tiny scene. */
  times?: number;
  /** The mode of step 2 has an imaginary part. */
  complex?: boolean;
  /** Bars have a level of detail: their twelve triangles from corner to corner. "of temperature": no other result has a
   * bound, but the displacement of step 1. */
  levels?: boolean | "of temperature";
  /** The bar swollen to a ball of 60 mm, with this temperature everywhere. */
  ball?: number;
}
export interface TinyScene {
  glb: ArrayBuffer;
  /** Side files by the uri the scene names. */
  side: Map<string, ArrayBuffer>;
}

const SIZE = [120, 40, 30] as const;
export const FIRST_NODE_ID = 1001;
export const FIRST_ELEMENT_ID = 501;
/** Nodes past this x have no von Mises stress in the tiny scene. */
export const MISSING_FROM_X = 108;

/** Values at a place (mm) of the bar at step 1 or 2. */
export const tinyValues = {
  temperature: (x: number, y: number, step: number) => 20 + x + 0.5 * y + (step - 1) * 30,
  /** Imaginary part of the mode's displacement. */
  imaginary: (x: number): [number, number, number] => [0.03 * Math.sin(x / 20), 0, 0.02],
  displacement: (x: number, step: number): [number, number, number] =>
    step === 1 ? [0, 0, -0.0004 * x * x] : [0, 0.0002 * x * x, 0.01 * Math.sin(x / 20)],
  vonMises: (x: number, z: number, step: number) => Math.abs(z - 15) * (SIZE[0] - x) * 0.2 * step + 1,
};

interface Vertex {
  position: [number, number, number];
  normal: [number, number, number];
  node: number;
  corners: number[];
}
interface Skin {
  vertices: Vertex[];
  triangles: number[];
  elements: number[];
  edgeVertices: Vertex[];
  edges: number[];
}

/** Between the bars, mm; and what their ids are apart. */
const BAR_PITCH = 60;
const BAR_IDS = 10_000;

function buildSkin(cells: readonly [number, number, number], bar: number): Skin {
  const skin: Skin = { vertices: [], triangles: [], elements: [], edgeVertices: [], edges: [] };
  const points = cells.map((n) => n + 1) as [number, number, number];
  const nodeId = (g: number[]) =>
    FIRST_NODE_ID + bar * BAR_IDS + g[0]! + points[0] * (g[1]! + points[1] * g[2]!);
  const place = (g: number[]) =>
    g.map((k, a) => (k * SIZE[a]!) / cells[a]! + (a === 1 ? bar * BAR_PITCH : 0)) as [number, number, number];
  const elementId = (g: number[]) =>
    FIRST_ELEMENT_ID + bar * BAR_IDS + g[0]! + cells[0] * (g[1]! + cells[1] * g[2]!);
  for (let axis = 0; axis < 3; ++axis) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    for (const end of [0, 1]) {
      const normal: [number, number, number] = [0, 0, 0];
      normal[axis] = end ? 1 : -1;
      const local = new Map<number, number>();
      const vertexOf = (g: number[]) => {
        const id = nodeId(g);
        if (!local.has(id)) {
          local.set(id, skin.vertices.length);
          skin.vertices.push({ position: place(g), normal, node: id, corners: [] });
        }
        return local.get(id)!;
      };
      for (let i = 0; i < cells[u]!; ++i) {
        for (let j = 0; j < cells[v]!; ++j) {
          const corner = (du: number, dv: number) => {
            const g = [0, 0, 0];
            g[axis] = end ? cells[axis]! : 0;
            g[u] = i + du;
            g[v] = j + dv;
            return g;
          };
          const ring = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          if (!end) ring.reverse();
          const corners = ring.map(vertexOf);
          const centre = skin.vertices.length;
          const mean = [0, 1, 2].map(
            (a) => corners.reduce((sum, c) => sum + skin.vertices[c]!.position[a]!, 0) / 4,
          ) as [number, number, number];
          skin.vertices.push({ position: mean, normal, node: 0, corners });
          const cell = corner(0, 0);
          if (end) cell[axis] = cells[axis]! - 1;
          for (let k = 0; k < 4; ++k) {
            skin.triangles.push(corners[k]!, corners[(k + 1) % 4]!, centre);
            skin.elements.push(elementId(cell));
          }
          for (let k = 0; k < 4; ++k) {
            for (const g of [ring[k]!, ring[(k + 1) % 4]!]) {
              skin.edges.push(skin.edgeVertices.length);
              skin.edgeVertices.push({ position: place(g), normal, node: nodeId(g), corners: [] });
            }
          }
        }
      }
    }
  }
  return skin;
}

/** The bar's surface blown up to a ball. */
function swell(skin: Skin): Skin {
  const round = (v: Vertex): Vertex => {
    const away = v.position.map((x, a) => (x - SIZE[a]! / 2) / SIZE[a]!);
    const length = Math.hypot(...away);
    const normal = away.map((x) => x / length) as [number, number, number];
    return {
      ...v,
      normal,
      position: normal.map((x, a) => SIZE[a]! / 2 + 30 * x) as [number, number, number],
    };
  };
  return { ...skin, vertices: skin.vertices.map(round), edgeVertices: skin.edgeVertices.map(round) };
}

class GlbWriter {
  readonly json: Record<string, unknown[]> & { buffers: { uri?: string; byteLength: number }[] } = {
    accessors: [],
    bufferViews: [],
    buffers: [{ byteLength: 0 }],
  };
  readonly #chunks: Uint8Array[][] = [[]];

  add(name: string, data: Float32Array | Uint32Array, type: string, buffer = 0): number {
    const width = type === "VEC3" ? 3 : 1;
    const bytes = new Uint8Array(data.buffer.slice(0));
    const info = this.json.buffers[buffer]!;
    this.json.bufferViews!.push({ buffer, byteOffset: info.byteLength, byteLength: bytes.length });
    info.byteLength += bytes.length;
    this.#chunks[buffer]!.push(bytes);
    const componentType = data instanceof Float32Array ? 5126 : 5125;
    this.json.accessors!.push({
      bufferView: this.json.bufferViews!.length - 1,
      componentType,
      count: data.length / width,
      type,
      name,
    });
    return this.json.accessors!.length - 1;
  }

  addBuffer(uri: string): number {
    this.json.buffers.push({ uri, byteLength: 0 });
    this.#chunks.push([]);
    return this.#chunks.length - 1;
  }

  bytesOf(buffer: number): Uint8Array {
    const out = new Uint8Array(this.json.buffers[buffer]!.byteLength);
    let at = 0;
    for (const chunk of this.#chunks[buffer]!) {
      out.set(chunk, at);
      at += chunk.length;
    }
    return out;
  }

  finish(rest: object): ArrayBuffer {
    const pad = (n: number) => (n + 3) & ~3;
    const text = new TextEncoder().encode(
      JSON.stringify({ asset: { version: "2.0" }, ...this.json, ...rest }),
    );
    const bin = this.bytesOf(0);
    const total = 12 + 8 + pad(text.length) + 8 + pad(bin.length);
    const out = new Uint8Array(total).fill(0x20);
    const view = new DataView(out.buffer);
    view.setUint32(0, 0x46546c67, true);
    view.setUint32(4, 2, true);
    view.setUint32(8, total, true);
    view.setUint32(12, pad(text.length), true);
    view.setUint32(16, 0x4e4f534a, true);
    out.set(text, 20);
    const at = 20 + pad(text.length);
    view.setUint32(at, pad(bin.length), true);
    view.setUint32(at + 4, 0x004e4942, true);
    out.set(bin, at + 8);
    return out.buffer;
  }
}

interface Quantity {
  id: string;
  name: string;
  quantity: string;
  components: string[];
  source: string;
  unit: string;
  derived: boolean;
  at: (position: readonly number[], step: number) => number[];
  missingFromX?: number;
  complex?: "imaginary";
  onlyStep?: number;
}

const QUANTITIES: Quantity[] = [
  {
    id: "temperature",
    name: "Temperature",
    quantity: "temperature",
    components: ["value"],
    source: "NDTEMP",
    unit: "degC",
    derived: false,
    at: (p, s) => [tinyValues.temperature(p[0]!, p[1]!, s)],
  },
  {
    id: "displacement",
    name: "Displacement",
    quantity: "displacement",
    components: ["x", "y", "z"],
    source: "DISP",
    unit: "mm",
    derived: false,
    at: (p, s) => tinyValues.displacement(p[0]!, s),
  },
  {
    id: "displacement_magnitude",
    name: "Displacement magnitude",
    quantity: "displacement",
    components: ["magnitude"],
    source: "DISP",
    unit: "mm",
    derived: true,
    at: (p, s) => [Math.hypot(...tinyValues.displacement(p[0]!, s).map(Math.fround))],
  },
  {
    id: "stress_von_mises",
    name: "Von Mises stress",
    quantity: "stress",
    components: ["von_mises"],
    source: "STRESS",
    unit: "MPa",
    derived: true,
    at: (p, s) => [tinyValues.vonMises(p[0]!, p[2]!, s)],
    missingFromX: MISSING_FROM_X,
  },
];

/** The presentation the tiny scene carries: temperature seen, displacement heard, von Mises felt. */
export const TINY_PRESENTATION = {
  format: "feelem-presentation",
  version: 1,
  title: "Bar",
  step: { input: 0, step: 1, substep: 1 },
  results: [
    {
      key: "T",
      name: "temperature",
      component: "value",
      location: "nodal",
      unit: "degC",
      range: { mode: "auto", lo: 20, hi: 160, scale: "lin" },
    },
    {
      key: "U",
      name: "displacement",
      component: "magnitude",
      location: "nodal",
      unit: "mm",
      range: { mode: "auto", lo: 0, hi: 5.76, scale: "lin" },
    },
    {
      key: "S",
      name: "stress",
      component: "von_mises",
      location: "nodal",
      unit: "MPa",
      range: { mode: "auto", lo: 1, hi: 361, scale: "lin" },
      limit: { value: 300, kind: "above", label: "yield" },
    },
  ],
  effects: [
    { result: "T", sense: "visual", type: "colour", map: "batlow", bands: 9, invert: false },
    { result: "U", sense: "audio", type: "pitch", midi: [48, 84], gamma: 1 },
    { result: "S", sense: "touch", type: "pulses", rateHz: [2, 10], ampMin: 0.15, pulseMs: 35 },
  ],
  deformation: { result: "U", mode: "auto5percent", factor: null },
};

const IMAGINARY: Quantity = {
  id: "displacement_im",
  name: "Displacement (imaginary)",
  quantity: "displacement",
  components: ["x", "y", "z"],
  source: "DISP",
  unit: "mm",
  derived: false,
  complex: "imaginary",
  onlyStep: 2,
  at: (p) => tinyValues.imaginary(p[0]!),
};

const floats = (list: Vertex[], pick: (v: Vertex) => readonly number[]) =>
  Float32Array.from(list.flatMap((v) => [...pick(v)]));

/** Geometry of one bar into the file; gives its glTF mesh pair. */
function writeBar(writer: GlbWriter, skin: Skin, p: string) {
  const position = writer.add(
    `${p}/POSITION`,
    floats(skin.vertices, (v) => v.position),
    "VEC3",
  );
  const normal = writer.add(
    `${p}/NORMAL`,
    floats(skin.vertices, (v) => v.normal),
    "VEC3",
  );
  const nodes = writer.add(
    `${p}/_NODE_ID`,
    floats(skin.vertices, (v) => [v.node]),
    "SCALAR",
  );
  const indices = writer.add(`${p}/indices`, Uint32Array.from(skin.triangles), "SCALAR");
  writer.add(`${p}/elements`, Uint32Array.from(skin.elements), "SCALAR");
  const outward = (v: Vertex) => v.position.map((x, a) => x + v.normal[a]! * 0.06);
  const edgePosition = writer.add(`${p}/edges/POSITION`, floats(skin.edgeVertices, outward), "VEC3");
  const edgeNodes = writer.add(
    `${p}/edges/_NODE_ID`,
    floats(skin.edgeVertices, (v) => [v.node]),
    "SCALAR",
  );
  const edgeIndices = writer.add(`${p}/edges/indices`, Uint32Array.from(skin.edges), "SCALAR");
  const attributes = { POSITION: position, NORMAL: normal, _NODE_ID: nodes };
  const edgeAttributes = { POSITION: edgePosition, _NODE_ID: edgeNodes };
  return [
    { primitives: [{ attributes, indices, mode: 4 }] },
    { primitives: [{ attributes: edgeAttributes, indices: edgeIndices, mode: 1 }] },
  ];
}

function quantityAt(q: Quantity, skin: Skin, v: Vertex, step: number): number[] {
  if (v.corners.length === 0) return q.at(v.position, step).map(Math.fround);
  const corners = v.corners.map((c) => quantityAt(q, skin, skin.vertices[c]!, step));
  return q.components.map((_, k) => Math.fround(corners.reduce((sum, c) => sum + c[k]!, 0) / 4));
}

function isMissing(q: Quantity, skin: Skin, v: Vertex): boolean {
  if (q.missingFromX === undefined) return false;
  if (v.corners.length > 0) return v.corners.some((c) => isMissing(q, skin, skin.vertices[c]!));
  return v.position[0] > q.missingFromX;
}

/** Values of a result at a step, all bars one after the other. */
function writeValues(writer: GlbWriter, skins: Skin[], q: Quantity, step: number, buffer: number) {
  const attribute = `_${q.id.toUpperCase()}`;
  const scalars: { value: number; node: number }[] = [];
  const valid: (string | null)[] = [];
  const accessors = skins.map((skin, bar) => {
    const known = skin.vertices.filter((v) => !isMissing(q, skin, v));
    for (const v of known)
      if (v.node) scalars.push({ value: quantityAt(q, skin, v, step)[0]!, node: v.node });
    const fill = q.components.map((_, k) =>
      known.reduce((low, v) => Math.min(low, quantityAt(q, skin, v, step)[k]!), Number.POSITIVE_INFINITY),
    );
    const name = `p${bar}/${attribute}/${step}`;
    const data = floats(skin.vertices, (v) => (isMissing(q, skin, v) ? fill : quantityAt(q, skin, v, step)));
    writer.add(name, data, q.components.length === 3 ? "VEC3" : "SCALAR", buffer);
    const mask = q.missingFromX === undefined ? null : `p${bar}/${attribute}_VALID/${step}`;
    const states = floats(skin.vertices, (v) => [isMissing(q, skin, v) ? 0 : v.node ? 1 : 2]);
    if (mask) writer.add(mask, states, "SCALAR", buffer);
    valid.push(mask);
    return name;
  });
  scalars.sort((a, b) => a.value - b.value || a.node - b.node);
  const top = scalars.at(-1)!.value;
  const scalar = q.components.length === 1;
  const max = scalar ? scalars.find((s) => s.value === top) : null;
  return { step, accessors, valid, missing: 0, min: scalar ? scalars[0] : null, max };
}

/** Two triangles a face of the bar, between its outermost vertices; its faces follow each other. */
function cornerTriangles(skin: Skin): number[] {
  const faces = new Map<string, number[]>();
  for (const [i, v] of skin.vertices.entries()) {
    const key = v.normal.join(" ");
    faces.set(key, [...(faces.get(key) ?? []), i]);
  }
  const at = (i: number) => skin.vertices[i]!.position;
  return [...faces.values()].flatMap((own) => {
    const normal = skin.vertices[own[0]!]!.normal;
    const k = normal.findIndex((c) => c !== 0);
    const [u, v] = [(k + 1) % 3, (k + 2) % 3];
    const far = (su: number, sv: number) =>
      own.reduce((best, i) =>
        su * at(i)[u]! + sv * at(i)[v]! > su * at(best)[u]! + sv * at(best)[v]! ? i : best,
      );
    const [a, b, c, d] = [far(-1, -1), far(1, -1), far(1, 1), far(-1, 1)];
    return normal[k]! > 0 ? [a, b, c, a, c, d] : [a, c, b, a, d, c];
  });
}

/** A level that promises a fiftieth of everything. */
function writeLevel(
  writer: GlbWriter,
  skins: Skin[],
  results: { id: string; values: { step: number }[] }[],
  isBound: (result: string, step: number) => boolean,
) {
  const lists = skins.map(cornerTriangles);
  const indices = lists.map((list, bar) => {
    writer.add(`p${bar}/indices/lod1`, Uint32Array.from(list), "SCALAR");
    return `p${bar}/indices/lod1`;
  });
  const triangles = lists.reduce((sum, list) => sum + list.length / 3, 0);
  const values = results.flatMap(({ id, values }) =>
    values
      .filter(({ step }) => isBound(id, step))
      .map(({ step }) => ({ result: id, step, bound: 0.123, max: 0.1, shown: 0.1 })),
  );
  return { triangles, indices, bound: 0.02, samples: 0, distance: { bound: 0.1, max: 0 }, values };
}

function stepsOf(options: TinyOptions) {
  const times = Array.from({ length: options.times ?? 0 }, (_, i) => ({
    id: 3 + i,
    kind: "time",
    input: 0,
    number: [3, 1 + i],
    value: 0.5 * (i + 1),
    unit: "s",
    name: "",
  }));
  return [
    { id: 1, kind: "static", input: 0, number: [1, 1], value: 1, unit: null, name: "Bending" },
    { id: 2, kind: "mode", input: 0, number: [2, 1], value: 76.66, unit: "Hz", name: "Mode 1" },
    ...times,
  ];
}

export function tinyScene(options: TinyOptions = {}): TinyScene {
  const bars = options.bars ?? 1;
  const { ball } = options;
  const built = Array.from({ length: bars }, (_, bar) => buildSkin(options.cells ?? [12, 4, 3], bar));
  const skins = ball === undefined ? built : built.map(swell);
  const writer = new GlbWriter();
  const meshes = skins.flatMap((skin, bar) => writeBar(writer, skin, `p${bar}`));
  const side = new Map<string, ArrayBuffer>();
  const steps = stepsOf(options);
  const all = options.complex ? [...QUANTITIES, IMAGINARY] : QUANTITIES;
  const quantities = all.map((q) =>
    ball !== undefined && q.id === "temperature" ? { ...q, at: () => [ball] } : q,
  );
  const results = quantities.map((q) => {
    const own = steps.filter((s) => q.onlyStep === undefined || q.onlyStep === s.id);
    const values = own.map(({ id: step }) => {
      const uri = `tiny.d/${q.id}.${step}.bin`;
      const buffer = options.sideFiles && step >= 2 ? writer.addBuffer(uri) : 0;
      const written = writeValues(writer, skins, q, step, buffer);
      if (buffer) side.set(uri, writer.bytesOf(buffer).buffer as ArrayBuffer);
      return written;
    });
    const { id, name, quantity, source, components, unit, derived } = q;
    const about = {
      id,
      attribute: `_${id.toUpperCase()}`,
      name,
      quantity,
      source,
      components,
      unit,
      derived,
    };
    const complex = q.complex ?? (options.complex && id === "displacement" ? "real" : false);
    return { ...about, location: "node", averaging: "solver", complex, values };
  });
  const parts = skins.map((skin, bar) => ({
    id: bar,
    name: bar === 0 ? "bar" : `bar ${bar + 1}`,
    kind: "solid",
    domain: "node",
    vertices: skin.vertices.length,
    triangles: skin.elements.length,
    elements: `p${bar}/elements`,
  }));
  const isBound = (id: string, step: number) =>
    options.levels !== "of temperature" || id === "temperature" || (id === "displacement" && step === 1);
  const feelem = {
    version: 1,
    title: "Bar",
    solver: { name: "formula", version: "1" },
    inputs: [],
    lengthUnit: { name: "mm", metres: 0.001 },
    origin: [0, 0, 0],
    parts,
    steps,
    results,
    ...(options.levels ? { levels: [writeLevel(writer, skins, results, isBound)] } : {}),
    texcoords: [],
    deformation: { result: "displacement", step: 1, factor: 1 },
    presentation: TINY_PRESENTATION,
    certificate: {},
  };
  const model = {
    name: "model",
    matrix: [0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1],
    children: meshes.map((_, i) => i + 1),
    extras: { feelem: { role: "model" } },
  };
  const nodes = meshes.map((_, i) => {
    const bar = Math.floor(i / 2);
    const role = i % 2 === 0 ? "part" : "edges";
    return { name: `bar ${bar} ${role}`, mesh: i, extras: { feelem: { role, part: bar } } };
  });
  const glb = writer.finish({
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [model, ...nodes],
    meshes,
    extras: { feelem },
  });
  return { glb, side };
}
