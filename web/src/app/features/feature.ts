// SPDX-License-Identifier: Apache-2.0
// A function of the page as one piece: its section, keys, page of the headset's panel, marks on the model, report.
import type { KeyCommand } from "../../input/keyboard";
import type { Place } from "../../probe";
import type { Handle, PanelPage, Section } from "../../ui";

export type { Handle };

/** A labelled place on the model. */
export interface PlaceMark {
  readonly kind: "max" | "min" | "hot" | "note" | "ruler";
  /** Tells it from its like; stays the same while it is the same. */
  readonly id: string;
  readonly text: string;
  readonly detail: string;
  readonly place: Place;
}

export interface Feature {
  readonly id: string;
  /** Part of the page's left column; null: nothing to offer for this scene. */
  section?(): Section | null;
  /** Page of the headset's panel. */
  page?(): PanelPage | null;
  commands?(): readonly KeyCommand[];
  marks?(): readonly PlaceMark[];
  /** Knobs on the model. */
  handles?(): readonly Handle[];
  /** What `window.feelem.state()` says of it. */
  report?(): Record<string, unknown>;
}
