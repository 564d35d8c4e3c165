// SPDX-License-Identifier: Apache-2.0
// Runs in the page before its own scripts: counts what goes to the graphics card, draw calls, frames and stalls.

/** What lands in `globalThis.watched`; times in milliseconds since the page was asked for. */
export function watchPage() {
  const watched = {
    bufferBytes: 0,
    textureBytes: 0,
    calls: 0,
    largestDraw: 0,
    sizes: [],
    firstModelPicture: null,
    frames: [],
    stalls: [],
  };
  globalThis.watched = watched;
  const { prototype } = WebGL2RenderingContext;
  const live = new Map();
  const bound = new Map();
  watched.liveBuffers = () => [...live.values()].reduce((sum, bytes) => sum + bytes, 0);
  const wrap = (name, see) => {
    const own = prototype[name];
    prototype[name] = function (...given) {
      see.call(this, given);
      return own.apply(this, given);
    };
  };
  const sizeOf = (given) => given.find((g) => ArrayBuffer.isView(g))?.byteLength ?? 0;
  wrap("bindBuffer", ([target, buffer]) => bound.set(target, buffer));
  wrap("deleteBuffer", ([buffer]) => live.delete(buffer));
  wrap("bufferData", (given) => {
    const bytes = typeof given[1] === "number" ? given[1] : sizeOf(given);
    watched.bufferBytes += bytes;
    watched.sizes.push(bytes);
    if (bound.get(given[0])) live.set(bound.get(given[0]), bytes);
  });
  wrap("bufferSubData", (given) => {
    watched.bufferBytes += sizeOf(given);
    watched.sizes.push(sizeOf(given));
  });
  for (const name of ["texImage2D", "texSubImage2D", "texSubImage3D"])
    wrap(name, (given) => {
      watched.textureBytes += sizeOf(given);
    });
  const draw = (count) => {
    watched.calls += 1;
    watched.largestDraw = Math.max(watched.largestDraw, count);
    if (count > 3000) watched.firstModelPicture ??= performance.now();
  };
  wrap("drawElements", (given) => draw(given[1]));
  wrap("drawArrays", (given) => draw(given[2]));
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries()) watched.stalls.push([startTime, duration]);
  }).observe({ type: "longtask", buffered: true });
}
