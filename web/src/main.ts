// SPDX-License-Identifier: Apache-2.0
// Starts the page: ?scene=ADDRESS names the scene, 'scene.glb' beside the page is the default.
import "./style.css";
import "./narrow.css";
import { publishApi } from "./app/api";
import { Shell } from "./app/shell";

const query = new URLSearchParams(location.search);
const host = document.getElementById("app") ?? document.body;
const shell = new Shell(host, {
  antialias: query.get("antialias") !== "0",
  governed: query.get("governor") !== "0",
  mostTriangles: Number(query.get("triangles")) || Number.POSITIVE_INFINITY,
});

const ready = shell.openAddress(query.get("scene") ?? "scene.glb");
publishApi(ready, () => shell.app);
ready.catch((error: unknown) => console.error(error));
