// SPDX-License-Identifier: Apache-2.0
// Which scene is open: from an address, dropped on the page, or chosen from a file. Nothing leaves this machine.
import { openScene } from "../scene";
import { App, type AppOptions } from "./app";
import { fetchScene } from "./first-state";
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
    try {
      await this.#show(await fetchScene(sceneUrl), sceneUrl, sceneUrl === OWN_SCENE);
    } catch (error) {
      this.#page.showFailure(error instanceof Error ? error.message : String(error));
      throw error;
    }
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
        await this.#show(opened, scene.name, false);
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
