// SPDX-License-Identifier: Apache-2.0
// Reads a scene by a path that shares no code with the page, to know what the page must say.

export function readScene(bytes) {
  const buffer =
    bytes instanceof ArrayBuffer
      ? bytes
      : bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const view = new DataView(buffer);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, length)));
  const start = 28 + length;
  const read = (accessor) => {
    const { bufferView, byteOffset = 0, componentType, count, type } = accessor;
    const { byteOffset: from = 0, buffer: which } = json.bufferViews[bufferView];
    if (which !== 0) throw new Error("not in the scene's own buffer");
    const Type = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array }[componentType];
    const width = { SCALAR: 1, VEC2: 2, VEC3: 3 }[type];
    return new Type(
      buffer.slice(
        start + from + byteOffset,
        start + from + byteOffset + count * width * Type.BYTES_PER_ELEMENT,
      ),
    );
  };
  const named = (name) => read(json.accessors.find((a) => a.name === name));
  const extras = json.extras.feelem;
  const model = json.nodes.find((n) => n.extras?.feelem?.role === "model");
  const parts = extras.parts.map((info) => {
    const node = json.nodes.find(
      (n) => n.extras?.feelem?.role === "part" && n.extras.feelem.part === info.id,
    );
    const { attributes, indices } = json.meshes[node.mesh].primitives[0];
    const low = read(json.accessors[attributes._NODE_ID]);
    const high =
      attributes._NODE_ID_HIGH === undefined ? null : read(json.accessors[attributes._NODE_ID_HIGH]);
    return {
      positions: read(json.accessors[attributes.POSITION]),
      indices: read(json.accessors[indices]),
      nodeIds: Array.from(low, (id, i) => id + (high ? high[i] * 16777216 : 0)),
      elements: named(info.elements),
    };
  });
  /** Values and mask of a scalar result on a part at a step. */
  const field = (resultId, step, part) => {
    const entry = extras.results.find((r) => r.id === resultId).values.find((v) => v.step === step);
    const mask = entry.valid?.[part] ? named(entry.valid[part]) : null;
    return { values: named(entry.accessors[part]), mask };
  };
  return { extras, parts, matrix: model.matrix, field, named };
}

function weightsOf(p, a, b, c) {
  const sub = (u, v) => u.map((x, i) => x - v[i]);
  const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const n = cross(sub(b, a), sub(c, a));
  const area = dot(n, n);
  const w = [
    dot(cross(sub(c, b), sub(p, b)), n),
    dot(cross(sub(a, c), sub(p, c)), n),
    dot(cross(sub(b, a), sub(p, a)), n),
  ];
  return { weights: w.map((x) => x / area), off: Math.abs(dot(sub(p, a), n)) / Math.sqrt(area) };
}

/** The value the scene has at a point of an element's skin: barycentric on the triangle that holds the point. */
export function valueAtPoint(scene, resultId, step, elementId, point) {
  let best = null;
  for (const [index, part] of scene.parts.entries()) {
    const { values, mask } = scene.field(resultId, step, index);
    for (let t = 0; t < part.elements.length; ++t) {
      if (part.elements[t] !== elementId) continue;
      const corners = [0, 1, 2].map((k) => part.indices[3 * t + k]);
      const at = corners.map((v) => Array.from(part.positions.subarray(3 * v, 3 * v + 3)));
      const { weights, off } = weightsOf(point, ...at);
      const miss = Math.max(0, ...weights.map((w) => -w)) + off;
      if (best && best.miss <= miss) continue;
      const missing = mask ? corners.some((v) => mask[v] === 0) : false;
      const value = missing ? null : corners.reduce((sum, v, k) => sum + weights[k] * values[v], 0);
      best = { value, miss, corners, weights };
    }
  }
  return best;
}

/** The scene's value at a node, bit for bit; null when missing. */
export function valueAtNode(scene, resultId, step, nodeId) {
  for (const [index, part] of scene.parts.entries()) {
    const vertex = part.nodeIds.indexOf(nodeId);
    if (vertex < 0) continue;
    const { values, mask } = scene.field(resultId, step, index);
    return mask && mask[vertex] === 0 ? null : values[vertex];
  }
  return null;
}

/** Result id of the scene for an entry of lastProbe().results. */
export function resultIdOf(scene, { name, component }) {
  const fits = (r) =>
    r.quantity === name &&
    r.components.length === 1 &&
    (r.components[0] === component || component === "value");
  return scene.extras.results.find(fits)?.id;
}
