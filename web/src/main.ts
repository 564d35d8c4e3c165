// SPDX-License-Identifier: Apache-2.0
// Starts the page: ?scene=ADDRESS names the scene, 'scene.glb' beside the page is the default.
import "./style.css";
import { publishApi } from "./app/api";
import { App } from "./app/app";
import { fetchScene } from "./app/first-state";
import { Page } from "./app/page";

const query = new URLSearchParams(location.search);
const host = document.getElementById("app") ?? document.body;
let app: App | null = null;

async function start(): Promise<void> {
  const page = new Page(host);
  try {
    const sceneUrl = query.get("scene") ?? "scene.glb";
    const options = { sceneUrl, antialias: query.get("antialias") !== "0", openFile: () => undefined };
    app = new App(page, await fetchScene(sceneUrl), options);
    await app.start();
  } catch (error) {
    page.showFailure(error instanceof Error ? error.message : String(error));
    throw error;
  }
}

const ready = start();
publishApi(ready, () => app);
ready.catch((error: unknown) => console.error(error));
