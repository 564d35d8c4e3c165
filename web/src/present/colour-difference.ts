// SPDX-License-Identifier: Apache-2.0
// How far apart colours look: CIE Lab, CIEDE2000 (Sharma, Wu, Dalal 2005), and vision without one kind of cone
// (Machado, Oliveira, Fernandes 2009, severity 1). Knows no other file, so that tests outside of the page use it too.

type Triple = readonly [number, number, number];
type Matrix = readonly [Triple, Triple, Triple];

export type Vision = "normal" | "protan" | "deutan" | "tritan";
export const visions: readonly Vision[] = ["normal", "protan", "deutan", "tritan"];

const seenBy: Record<Vision, Matrix> = {
  normal: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protan: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deutan: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritan: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};
const toXyz: Matrix = [
  [0.4124564, 0.3575761, 0.1804375],
  [0.2126729, 0.7151522, 0.072175],
  [0.0193339, 0.119192, 0.9503041],
];
const white: Triple = [0.95047, 1, 1.08883];

const product = (m: Matrix, v: Triple): Triple =>
  m.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]) as unknown as Triple;
const linear = (byte: number) => {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
};

/** CIE Lab (D65) of sRGB bytes as this vision has them. */
export function labOf([r, g, b]: Triple, vision: Vision = "normal"): Triple {
  const seen = product(seenBy[vision], [linear(r), linear(g), linear(b)]);
  const inside = seen.map((c) => Math.min(Math.max(c, 0), 1)) as unknown as Triple;
  const [x, y, z] = product(toXyz, inside).map((c, i) => {
    const share = c / (white[i] ?? 1);
    return share > 216 / 24389 ? Math.cbrt(share) : ((24389 / 27) * share + 16) / 116;
  }) as unknown as Triple;
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const hueOf = (a: number, b: number) => ((Math.atan2(b, a) * 180) / Math.PI + 360) % 360;
const saturation = (chroma: number) => Math.sqrt(chroma ** 7 / (chroma ** 7 + 25 ** 7));

/** CIEDE2000 of two colours in Lab. */
export function differenceOf(first: Triple, second: Triple): number {
  const mean = (Math.hypot(first[1], first[2]) + Math.hypot(second[1], second[2])) / 2;
  const stretch = 1 + 0.5 * (1 - saturation(mean));
  const chroma1 = Math.hypot(stretch * first[1], first[2]);
  const chroma2 = Math.hypot(stretch * second[1], second[2]);
  const hue1 = hueOf(stretch * first[1], first[2]);
  const hue2 = hueOf(stretch * second[1], second[2]);
  const grey = chroma1 * chroma2 === 0;
  let turn = grey ? 0 : hue2 - hue1;
  turn += turn > 180 ? -360 : turn < -180 ? 360 : 0;
  let hue = hue1 + hue2;
  if (!grey) hue = (Math.abs(hue1 - hue2) > 180 ? hue + (hue < 360 ? 360 : -360) : hue) / 2;
  const chroma = (chroma1 + chroma2) / 2;
  const lift = ((first[0] + second[0]) / 2 - 50) ** 2;
  const t =
    1 -
    0.17 * Math.cos(radians(hue - 30)) +
    0.24 * Math.cos(radians(2 * hue)) +
    0.32 * Math.cos(radians(3 * hue + 6)) -
    0.2 * Math.cos(radians(4 * hue - 63));
  const light = (second[0] - first[0]) / (1 + (0.015 * lift) / Math.sqrt(20 + lift));
  const strong = (chroma2 - chroma1) / (1 + 0.045 * chroma);
  const turned = (2 * Math.sqrt(chroma1 * chroma2) * Math.sin(radians(turn / 2))) / (1 + 0.015 * chroma * t);
  const rotation = -Math.sin(radians(60 * Math.exp(-(((hue - 275) / 25) ** 2)))) * 2 * saturation(chroma);
  return Math.sqrt(light ** 2 + strong ** 2 + turned ** 2 + rotation * strong * turned);
}

/** The two of these colours that look most alike: how far apart, and to whom. */
export function leastDifference(colours: readonly Triple[]): { apart: number; vision: Vision } {
  let least: { apart: number; vision: Vision } = { apart: Number.POSITIVE_INFINITY, vision: "normal" };
  for (const vision of visions) {
    const labs = colours.map((colour) => labOf(colour, vision));
    for (const [i, a] of labs.entries()) {
      for (const b of labs.slice(i + 1)) {
        const apart = differenceOf(a, b);
        if (apart < least.apart) least = { apart, vision };
      }
    }
  }
  return least;
}
