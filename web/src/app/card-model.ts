// SPDX-License-Identifier: Apache-2.0
// Report of a place -> what the card says of it.
import type { CardModel, CardRow, IconName } from "../ui";
import { numberText, unitText } from "../ui";
import { isPast, utilisation } from "./limits";
import type { ModelView, Shown } from "./model-view";
import type { Reading } from "./opening";
import { type PresentationDoc, type Slot, slotsOf } from "./presentation-doc";
import type { ProbeReport } from "./probe-report";

const ICONS: Record<Slot, IconName> = {
  colour: "eye",
  pitch: "ear",
  ticks: "ticks",
  pulses: "hand",
  shape: "shape",
};

function alarmOf(shown: Shown, value: number | null): string | null {
  if (shown.limit === null || value === null) return null;
  if (!isPast(value, shown)) return null;
  const limit = `${numberText(shown.limit)} ${unitText(shown.unit)}`.trim();
  const label = shown.limitLabel && shown.limitLabel !== limit ? ` (${shown.limitLabel})` : "";
  return `${shown.limitIsUpper ? "above" : "below"} the limit ${limit}${label}`;
}

export function cardModel(
  view: ModelView,
  doc: PresentationDoc,
  report: ProbeReport,
  options: { pinned: boolean; sounding: boolean; vibrates: boolean; reading: Reading | null },
): CardModel {
  const rows = report.results.flatMap((entry): CardRow[] => {
    const shown = view.shown.find((s) => s.key === entry.key);
    if (!shown) return [];
    return [
      {
        key: shown.key,
        label: shown.label,
        unit: entry.unit,
        value: entry.value,
        nodeValue: entry.nodeValue,
        state: entry.state,
        senses: slotsOf(doc, entry.key).map((slot) => ICONS[slot]),
        alarm: alarmOf(shown, entry.value),
        utilisation: utilisation(entry.value, shown),
        bound: entry.bound,
      },
    ];
  });
  // Ticks of no result of their own are those of what cannot be felt here.
  const standsIn = !options.vibrates && view.shownAs("ticks") === null;
  const heard = [
    report.hz > 0 ? `tone ${numberText(report.hz, 4)} Hz` : "",
    report.tickRate > 0 ? `${numberText(report.tickRate, 3)} ticks/s${standsIn ? " for touch" : ""}` : "",
    options.vibrates && report.pulse.rate > 0 ? `${numberText(report.pulse.rate, 3)} pulses/s` : "",
  ].filter((text) => text !== "");
  return {
    report,
    rows,
    pinned: options.pinned,
    reading: options.reading,
    lengthUnit: view.scene.extras.lengthUnit?.name ?? null,
    sounding: options.sounding && heard.length > 0 ? heard.join(" · ") : null,
  };
}
