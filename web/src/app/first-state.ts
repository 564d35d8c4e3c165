// SPDX-License-Identifier: Apache-2.0
// The scene from its address, and the state the page starts in.
import { isPreview, openScene, type SceneData } from "../scene";
import { carriedFiles } from "./carried";
import { rememberedPerson } from "./person";
import { defaultPresentation, type PresentationDoc } from "./presentation-doc";
import type { ViewState } from "./store";
import { rememberedTheme } from "./theme";

/** Triangles up to which the ghost's lines are looked for unasked. */
const GHOST_UP_TO = 300_000;

/** Reads the scene; its side files are looked for beside it, or all of them in the page itself. */
export async function fetchScene(url: string): Promise<SceneData> {
  const carried = carriedFiles();
  if (carried) return openScene(await carried("scene.glb"), carried);
  const asked = async (address: string) => {
    const response = await fetch(address);
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`.trim());
    return response;
  };
  const base = new URL(url, document.baseURI);
  const bytes = await asked(base.href).catch((error: Error) => {
    throw new Error(`The scene '${url}' cannot be read: ${error.message}`);
  });
  // Read as it comes, so that the shape is drawn while results are still on their way.
  const coming = bytes.body ?? (await bytes.arrayBuffer());
  return openScene(coming, async (uri) => (await asked(new URL(uri, base).href)).arrayBuffer());
}

export function firstState(scene: SceneData): ViewState {
  const { extras } = scene;
  const given = extras.presentation as PresentationDoc | undefined;
  const doc = Array.isArray(given?.results) && given.results.length > 0 ? given : defaultPresentation(extras);
  const wanted = doc.step as { input?: number; step?: number; substep?: number } | undefined;
  const shown = extras.steps.find(
    (s) =>
      wanted &&
      (s.input ?? 0) === (wanted.input ?? 0) &&
      s.number?.[0] === wanted.step &&
      s.number?.[1] === (wanted.substep ?? 1),
  );
  // The step whose results stand in the scene's attributes is the one it wants shown first.
  const coloured = (extras.texcoords as { step?: number }[] | undefined)?.[0]?.step;
  const firstStep = coloured ?? extras.deformation?.step ?? extras.steps[0]?.id ?? 0;
  const triangles = scene.parts.reduce((sum, part) => sum + part.indices.length / 3, 0);
  const deformation = doc.deformation as { factor?: number | null; ghost?: unknown } | null | undefined;
  const typed = typeof deformation?.factor === "number" ? deformation.factor : null;
  return {
    doc,
    step: shown?.id ?? firstStep,
    deformMode: typed === null ? "auto" : typed === 1 ? "true" : "factor",
    typedFactor: typed ?? 1,
    playing: false,
    edges: true,
    shading: false,
    extremes: true,
    theme: rememberedTheme(),
    sound: true,
    touch: true,
    session: "none",
    problem:
      scene.gaps.length > 0 ? `The scene has lost ${scene.gaps.join(", ")}: they cannot be shown.` : null,
    notice: "",
    reading: isPreview(extras) ? { stage: "", percent: 0, failed: null } : null,
    person: rememberedPerson(doc.audio),
    guide: false,
    pins: [],
    ruler: [],
    cuts: [],
    ghost: deformation?.ghost === "featureEdges" && triangles < GHOST_UP_TO,
    speed: 1,
    hidden: [],
    clear: [],
    open: [],
    hot: { count: 5, share: 0.05, by: "value", end: "largest", marks: true },
  };
}
