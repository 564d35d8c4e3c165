// SPDX-License-Identifier: Apache-2.0
// Notes that stay at nodes, and the ruler between two of them.
import { findNode, type Place, placePoint, placeVertex } from "../../probe";
import { RulerLine } from "../../render";
import type { NoteActions } from "../../ui";
import { notesTemplate, numberText, type PanelPage, type Section, unitText } from "../../ui";
import type { App } from "../app";
import { chosenNode } from "../chosen-node";
import type { Feature, PlaceMark } from "./feature";

export const MOST_NOTES = 50;

export class Notes implements Feature, NoteActions {
  readonly id = "notes";
  readonly #app: App;
  readonly #places = new Map<number, Place | null>();
  readonly #line: RulerLine;

  constructor(app: App) {
    this.#app = app;
    this.#line = new RulerLine(app.stage.scene);
  }

  /** Where a node is; found once. */
  #placeOf(node: number): Place | null {
    let place = this.#places.get(node);
    if (place === undefined) {
      place = findNode(this.#app.view.scene.parts, node);
      this.#places.set(node, place);
    }
    return place;
  }

  #node(): number | null {
    return chosenNode(this.#app);
  }

  pinHere(): void {
    const node = this.#node();
    const { pins } = this.#app.store.state;
    if (node === null) this.#app.say("Point at a node first, or go to one.");
    else if (pins.some((pin) => pin.node === node)) this.#app.say(`Node ${node} has a note already.`);
    else if (pins.length >= MOST_NOTES) this.#app.say(`There is room for ${MOST_NOTES} notes.`);
    else {
      const id = Math.max(0, ...pins.map((pin) => pin.id)) + 1;
      this.#app.store.set({ pins: [...pins, { id, node, note: "" }] });
      this.#app.say(`Note ${id} at node ${node}.`);
    }
  }

  write(id: number, note: string): void {
    const { pins } = this.#app.store.state;
    this.#app.store.set({
      pins: pins.map((pin) => (pin.id === id ? { ...pin, note: note.slice(0, 500) } : pin)),
    });
  }

  remove(id: number): void {
    this.#app.store.set({ pins: this.#app.store.state.pins.filter((pin) => pin.id !== id) });
  }

  goTo(id: number): void {
    const pin = this.#app.store.state.pins.find((p) => p.id === id);
    const place = pin && this.#placeOf(pin.node);
    if (place) this.#app.flyTo(place);
  }

  /** First press: from this node; second: to this one; a third starts anew. */
  measure(): void {
    const node = this.#node();
    const { ruler } = this.#app.store.state;
    if (node === null) this.#app.say("Point at a node first, or go to one.");
    else if (ruler.length === 1 && ruler[0] !== node) {
      this.#app.store.set({ ruler: [...ruler, node] });
      this.#app.say(this.#rulerText());
    } else {
      this.#app.store.set({ ruler: [node] });
      this.#app.say(`From node ${node}: now point at the other end and measure again.`);
    }
  }

  clearRuler(): void {
    this.#app.store.set({ ruler: [] });
  }

  /** Distance of the two nodes, model units: as they were, and as displacements of this step move them. */
  distance(): { undeformed: number; deformed: number | null } | null {
    const places = this.#app.store.state.ruler.map((node) => this.#placeOf(node));
    const [a, b] = places;
    if (!a || !b) return null;
    const { view } = this.#app;
    const at = (place: Place) => {
      const part = view.scene.parts[place.part];
      return part ? placePoint(part, place, [0, 0, 0]) : [0, 0, 0];
    };
    const moved = (place: Place) => view.displacementAt(place.part, placeVertex(view.scene.parts, place));
    const apart = (p: readonly number[], q: readonly number[]) =>
      Math.hypot(...p.map((v, i) => v - (q[i] ?? 0)));
    const [ma, mb] = [moved(a), moved(b)];
    const add = (p: readonly number[], m: readonly number[]) => p.map((v, i) => v + (m[i] ?? 0));
    return {
      undeformed: apart(at(a), at(b)),
      deformed: ma && mb ? apart(add(at(a), ma), add(at(b), mb)) : null,
    };
  }

  #rulerText(): string {
    const { ruler } = this.#app.store.state;
    if (ruler.length === 1) return `from node ${ruler[0]} …`;
    const distance = this.distance();
    if (!distance) return "";
    const unit = unitText(this.#app.view.scene.extras.lengthUnit?.name) || "units of length";
    const now = distance.deformed === null ? "" : `, deformed ${numberText(distance.deformed)} ${unit}`;
    return `node ${ruler[0]} to node ${ruler[1]}: ${numberText(distance.undeformed)} ${unit}${now}`;
  }

  /** Notes with where they are; those whose node is not in this scene have no place. */
  rows() {
    return this.#app.store.state.pins.flatMap((pin) => {
      const place = this.#placeOf(pin.node);
      const vertex = place ? placeVertex(this.#app.view.scene.parts, place) : -1;
      return place ? [{ ...pin, place, part: place.part, vertex }] : [];
    });
  }

  #valueText(part: number, vertex: number): string {
    const seen = this.#app.view.shownAs("colour");
    const field = seen?.fields[part];
    if (!seen || !field) return "";
    const value = field.values[vertex * field.components + seen.componentIndex];
    return value === undefined || Number.isNaN(value)
      ? "no value"
      : `${numberText(value)} ${unitText(seen.unit)}`;
  }

  section(): Section {
    const rows = this.rows().map((row) => ({ ...row, value: this.#valueText(row.part, row.vertex) }));
    const summary = rows.length > 0 ? String(rows.length) : "";
    return {
      id: this.id,
      title: "Notes and ruler",
      summary,
      body: () => notesTemplate(rows, this.#rulerText(), this),
    };
  }

  page(): PanelPage {
    const rows = this.rows().map((row) => ({
      text: `${row.id}  node ${row.node}  ${this.#valueText(row.part, row.vertex)}`,
      detail: row.note,
      buttons: [
        { id: `go:${row.id}`, text: "Mark", press: () => this.goTo(row.id) },
        { id: `no:${row.id}`, text: "Remove", press: () => this.remove(row.id) },
      ],
    }));
    const here = [
      { id: "pin", text: "Note here", press: () => this.pinHere() },
      { id: "measure", text: "Measure", press: () => this.measure() },
      { id: "clear", text: "No ruler", press: () => this.clearRuler() },
    ];
    return {
      id: this.id,
      title: "Notes",
      rows: [{ text: "The node pressed last", detail: this.#rulerText(), buttons: here }, ...rows],
    };
  }

  marks(): PlaceMark[] {
    const notes = this.rows().map((row): PlaceMark => {
      const text = `${row.id} ${row.note}`.trim();
      return {
        kind: "note",
        id: `note-${row.id}`,
        text,
        detail: this.#valueText(row.part, row.vertex),
        place: row.place,
      };
    });
    const { ruler } = this.#app.store.state;
    const ends = ruler.map((node) => this.#placeOf(node));
    const matrix = this.#app.view.model.worldMatrix();
    const world = (place: Place) => this.#app.view.picker.worldOf(place, matrix);
    const [a, b] = ends;
    this.#line.set(a && b ? world(a) : null, a && b ? world(b) : null);
    const unit = unitText(this.#app.view.scene.extras.lengthUnit?.name);
    const marks = ends.flatMap((place, i): PlaceMark[] => {
      const far = i === 1 ? `${numberText(this.distance()?.undeformed)} ${unit}` : "";
      return place ? [{ kind: "ruler", id: `ruler-${i}`, text: far, detail: i === 1 ? "" : "", place }] : [];
    });
    return [...notes, ...marks];
  }

  commands() {
    return [
      { keys: ["p"], shown: "P", text: "note at this node", down: () => this.pinHere() },
      { keys: ["k"], shown: "K", text: "measure from, to this node", down: () => this.measure() },
    ];
  }

  report() {
    const { pins, ruler } = this.#app.store.state;
    return { pins, ruler: ruler.length > 0 ? { nodes: ruler, ...this.distance() } : null };
  }
}
