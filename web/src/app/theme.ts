// SPDX-License-Identifier: Apache-2.0
// Dark and light: the person's choice stays with the browser, else the system's holds.
import { Color } from "three";
import type { Stage } from "../render";
import type { ViewState } from "./store";

const KEY = "feelem.theme";

export function rememberedTheme(): ViewState["theme"] {
  try {
    const word = localStorage.getItem(KEY);
    return word === "dark" || word === "light" ? word : "auto";
  } catch {
    return "auto";
  }
}

/** While nobody has chosen, the page follows the system as it changes. Returns its own removal. */
export function followSystem(changed: () => void): () => void {
  const query = matchMedia("(prefers-color-scheme: dark)");
  query.addEventListener("change", changed);
  return () => query.removeEventListener("change", changed);
}

export function applyTheme(theme: ViewState["theme"], stage: Stage): void {
  const dark = theme === "dark" || (theme === "auto" && matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  try {
    if (theme === "auto") localStorage.removeItem(KEY);
    else localStorage.setItem(KEY, theme);
  } catch {
    // Without storage the choice lasts as long as the page.
  }
  const colour = getComputedStyle(document.documentElement).getPropertyValue("--stage").trim();
  stage.renderer.setClearColor(new Color(colour || "#e3e7e7"));
  stage.invalidate();
}
