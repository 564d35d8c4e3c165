// SPDX-License-Identifier: Apache-2.0
// A finger that rests on the model asks what is to be done there.
import type { Place } from "../probe";
import type { PlaceChoice } from "../ui";
import type { App } from "./app";
import type { Notes } from "./features/notes";
import type { Parts } from "./features/parts";

/** Choices at a place; each closes the menu first. */
export function placeChoices(app: App, place: Place, close: () => void): PlaceChoice[] {
  const notes = app.feature<Notes>("notes");
  const part = app.view.scene.parts[place.part];
  const choice = (id: string, text: string, act: () => void) => ({
    id,
    text,
    run: () => {
      close();
      act();
    },
  });
  // The finger is gone when the choice is made: the place stays marked.
  const here = (act: () => void) => () => {
    app.mark(place);
    act();
  };
  return [
    choice(
      "note",
      "Note here",
      here(() => notes.pinHere()),
    ),
    choice(
      "measure",
      "Measure",
      here(() => notes.measure()),
    ),
    choice(
      "mark",
      "Stay here",
      here(() => {}),
    ),
    ...(part
      ? [choice("hide", "Hide this part", () => app.feature<Parts>("parts").show(part.index, false))]
      : []),
    choice("close", "Close", () => {}),
  ];
}
