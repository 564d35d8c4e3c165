// SPDX-License-Identifier: Apache-2.0
// Which scene is open: from an address, dropped on the page, or chosen from a file. Nothing leaves this machine.
import { isPreview, openScene } from "../scene";
import { App, type AppOptions } from "./app";
import { fetchScene } from "./first-state";
import { Opening, type OpeningNews } from "./opening";
import { Page } from "./page";

const JSON_NAME = /\.json$/i;
/** What a server that was given a model serves as its scene. */
const OWN_SCENE = "scene.glb";
const SCENE_NAME = /\.(glb|gltf)$/i;

/** Files of a drop, folders with all that is in them. */
async function droppedFiles(data: DataTransfer): Promise<File[]> {
  const entries = [...data.items].flatMap((item) => item.webkitGetAsEntry?.() ?? []);
  if (entries.length === 0) return [...data.files];
  const files: File[] = [];
  const walk = async (entry: FileSystemEntry): Promise<void> => {
    if (files.length > 20_000) return;
    if (entry.isFile) {
      files.push(
        await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject)),
      );
      return;
    }
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    for (;;) {
      const some = await new Promise<FileSystemEntry[]>((resolve, reject) =>
        reader.readEntries(resolve, reject),
      );
      if (some.length === 0) return;
      for (const one of some) await walk(one);
    }
  };
  for (const entry of entries) await walk(entry);
  return files;
}

type Drawing = Pick<AppOptions, "antialias" | "governed" | "mostTriangles">;

export class Shell {
  readonly #host: HTMLElement;
  readonly #drawing: Drawing;
  #app: App | null = null;
  #page: Page;
  /** Somebody has opened another scene than that of the address. */
  #isOther = false;

  constructor(host: HTMLElement, drawing: Drawing) {
    this.#host = host;
    this.#drawing = drawing;
    this.#page = new Page(host);
    window.addEventListener("dragover", (event) => {
      event.preventDefault();
      host.classList.add("dropping");
    });
    window.addEventListener("dragleave", (event) => {
      if (event.relatedTarget === null) host.classList.remove("dropping");
    });
    window.addEventListener("drop", (event) => {
      event.preventDefault();
      host.classList.remove("dropping");
      if (event.dataTransfer) void droppedFiles(event.dataTransfer).then((files) => this.openFiles(files));
    });
  }

  get app(): App | null {
    return this.#app;
  }

  async openAddress(sceneUrl: string): Promise<void> {
    const served = sceneUrl === OWN_SCENE;
    const opening = served ? Opening.find() : null;
    try {
      if (opening) await this.#open(opening, sceneUrl);
      else {
        await this.#show(await fetchScene(sceneUrl), sceneUrl, served);
        this.#sayUnfinished();
      }
    } catch (error) {
      // Whatever it is, it is not about the scene that is seen.
      if (this.#isOther) return;
      const reason = error instanceof Error ? error.message : String(error);
      if (this.#app?.view.isPreview) this.#app.setReading({ stage: "", percent: 0, failed: reason });
      else this.#page.showFailure(reason);
      throw error;
    }
  }

  /** A scene that is still being made: its shape at once, and the rest in its place when it is there. */
  async #open(opening: Opening, sceneUrl: string): Promise<void> {
    let news = await opening.ask(0);
    if (news.state !== "reading") return this.#finish(news, sceneUrl);
    const shape = await fetchScene(opening.shape);
    const shown = this.#show(shape, sceneUrl, true);
    const app = this.#app;
    // What could not be drawn is said below, when it is waited for.
    shown.catch(() => {});
    while (news.state === "reading" && isPreview(shape.extras)) {
      app?.setReading({ stage: news.stage, percent: news.percent, failed: null });
      news = await opening.ask(news.version);
      // Somebody has opened something else.
      if (this.#app !== app) return;
    }
    await shown;
    if (isPreview(shape.extras) && this.#app === app) await this.#finish(news, sceneUrl);
  }

  async #finish(news: OpeningNews, sceneUrl: string): Promise<void> {
    if (news.state === "failed") throw new Error(news.text);
    const app = this.#app;
    const scene = await fetchScene(sceneUrl);
    if (this.#app !== app || (app && (await app.adopt(scene)))) return;
    await this.#show(scene, sceneUrl, true);
  }

  /** The shape alone, kept as a file: nobody is reading its results. */
  #sayUnfinished(): void {
    const failed = "This file was made before they were. Open the finished scene.";
    this.#app?.setReading({ stage: "", percent: 0, failed });
  }

  /** A scene with its side files, or a presentation for the scene that is open. */
  async openFiles(files: readonly File[]): Promise<void> {
    try {
      const scene = files.find((file) => SCENE_NAME.test(file.name));
      const presentation = files.find((file) => JSON_NAME.test(file.name));
      if (scene) {
        const beside = async (uri: string) => {
          const name = decodeURIComponent(uri.split("/").at(-1) ?? "");
          const file = files.find((f) => f.name === name);
          if (!file) throw new Error("drop it together with the scene");
          return file.arrayBuffer();
        };
        const opened = await openScene(scene.stream(), beside);
        // The view in the address was that of another scene.
        history.replaceState(history.state, "", location.pathname + location.search);
        this.#isOther = true;
        await this.#show(opened, scene.name, false);
        this.#sayUnfinished();
      }
      if (presentation) this.#app?.openPresentation(JSON.parse(await presentation.text()));
      if (!scene && !presentation)
        throw new Error(
          "it takes scenes (.glb, .gltf) and presentations (.json); `feelem convert` makes a scene",
        );
    } catch (error) {
      const reason = `That cannot be opened: ${error instanceof Error ? error.message : String(error)}`;
      if (this.#app) this.#app.store.set({ problem: reason });
      else this.#page.showFailure(reason);
    }
  }

  async #show(
    scene: Awaited<ReturnType<typeof openScene>>,
    sceneUrl: string,
    served: boolean,
  ): Promise<void> {
    if (this.#app) {
      this.#app.dispose();
      this.#page = new Page(this.#host);
    }
    const options: AppOptions = { sceneUrl, ...this.#drawing, served, openFile: () => this.#choose() };
    this.#app = new App(this.#page, scene, options);
    await this.#app.start();
  }

  #choose(): void {
    const input = document.createElement("input");
    input.type = "file";
    input.multiple = true;
    input.accept = ".glb,.gltf,.bin,.json";
    input.addEventListener("change", () => void this.openFiles([...(input.files ?? [])]));
    input.click();
  }
}
