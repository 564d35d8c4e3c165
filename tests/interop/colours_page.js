// SPDX-License-Identifier: Apache-2.0
// Runs in the browser: what colour a place of a scene must have, from the scene's bytes alone.

/** The parts of a .glb with texture coordinates and palettes, in metres. */
export class Reference {
  static async load(url) {
    const bytes = await (await fetch(url)).arrayBuffer();
    const size = new DataView(bytes).getUint32(12, true);
    const reference = new Reference();
    reference.json = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, size)));
    reference.chunk = bytes.slice(28 + size);
    reference.pictures = await Promise.all(reference.json.images.map((image) => reference.#picture(image)));
    reference.#gather();
    return reference;
  }

  async #picture(image) {
    const view = this.json.bufferViews[image.bufferView];
    const blob = new Blob([this.chunk.slice(view.byteOffset, view.byteOffset + view.byteLength)], { type: 'image/png' });
    const bitmap = await createImageBitmap(blob, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height);
  }

  #numbers(index) {
    const accessor = this.json.accessors[index];
    const view = this.json.bufferViews[accessor.bufferView];
    const width = { SCALAR: 1, VEC2: 2, VEC3: 3 }[accessor.type];
    const Kind = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array }[accessor.componentType];
    return new Kind(this.chunk, view.byteOffset, accessor.count * width);
  }

  #gather() {
    const m = this.json.nodes.find((node) => node.extras.feelem.role === 'model').matrix;
    this.triangles = [];
    for (const node of this.json.nodes.filter((n) => n.extras.feelem.role === 'part')) {
      const primitive = this.json.meshes[node.mesh].primitives[0];
      const p = this.#numbers(primitive.attributes.POSITION);
      const index = this.#numbers(primitive.indices);
      const uv = [];
      for (let set = 0; `TEXCOORD_${set}` in primitive.attributes; set++) uv.push(this.#numbers(primitive.attributes[`TEXCOORD_${set}`]));
      const place = (v) => [0, 1, 2].map((row) => m[row] * p[3 * v] + m[4 + row] * p[3 * v + 1] + m[8 + row] * p[3 * v + 2] + m[12 + row]);
      for (let i = 0; i < index.length; i += 3) {
        const vertices = [...index.slice(i, i + 3)];
        this.triangles.push({ corners: vertices.map(place), uv: uv.map((set) => vertices.map((v) => [set[2 * v], set[2 * v + 1]])), primitive });
      }
    }
    this.low = [0, 1, 2].map((a) => Math.min(...this.triangles.flatMap((t) => t.corners.map((c) => c[a]))));
    this.high = [0, 1, 2].map((a) => Math.max(...this.triangles.flatMap((t) => t.corners.map((c) => c[a]))));
  }

  get variants() {
    return this.json.extensions.KHR_materials_variants.variants.map((variant) => variant.name);
  }

  /** Colour at barycentric weights of a triangle under a variant, as NEAREST and CLAMP_TO_EDGE give it. */
  colour(triangle, weights, variant) {
    const mapping = triangle.primitive.extensions.KHR_materials_variants.mappings.find((m) => m.variants.includes(this.variants.indexOf(variant)));
    const info = this.json.materials[mapping.material].pbrMetallicRoughness.baseColorTexture;
    const picture = this.pictures[this.json.textures[info.index].source];
    const at = [0, 1].map((k) => weights.reduce((sum, w, i) => sum + w * triangle.uv[info.texCoord ?? 0][i][k], 0));
    const texel = (x, size) => Math.min(size - 1, Math.max(0, Math.floor(x * size)));
    const pixel = 4 * (texel(at[1], picture.height) * picture.width + texel(at[0], picture.width));
    // Where the next texel differs, a pixel may show either: such places say nothing.
    const near = [-0.004, 0.004].map((d) => 4 * (texel(at[1], picture.height) * picture.width + texel(at[0] + d * 0.1, picture.width)));
    const steady = near.every((other) => [0, 1, 2].every((c) => Math.abs(picture.data[other + c] - picture.data[pixel + c]) <= 1));
    return { rgb: [...picture.data.slice(pixel, pixel + 3)], steady };
  }

  /** First triangle along a ray with its weights. */
  hit(origin, direction) {
    let best = null;
    for (const triangle of this.triangles) {
      const [a, b, c] = triangle.corners;
      const e1 = sub(b, a), e2 = sub(c, a), h = cross(direction, e2), det = dot(e1, h);
      if (Math.abs(det) < 1e-30) continue;
      const s = sub(origin, a), u = dot(s, h) / det, q = cross(s, e1), v = dot(direction, q) / det, t = dot(e2, q) / det;
      if (u < 0 || v < 0 || u + v > 1 || t < 0 || (best && t >= best.t)) continue;
      best = { t, triangle, weights: [1 - u - v, u, v] };
    }
    return best;
  }
}

/** Is the place far enough inside its triangle for edge lines and neighbours not to matter? */
export const isInside = (weights) => Math.min(...weights) > 0.12;

const sub = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
