// SPDX-License-Identifier: Apache-2.0
// Presentations are read as C++ reads them, and the schema says the same.
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { colourMaps, defaultColour, PresentationError, parsePresentation } from "../../src/present";
import { violations } from "./schema";

const projectFile = (path: string) => readFileSync(new URL(`../../../${path}`, import.meta.url), "utf8");
const schema = JSON.parse(projectFile("schema/presentation.schema.json"));
const contract: { document: string; wrong: string }[] = JSON.parse(
  projectFile("tests/contract/presentations.json"),
);
const boiler: unknown = JSON.parse(projectFile("examples/boiler/boiler.presentation.json"));

function wrongPath(document: unknown): string {
  try {
    parsePresentation(document);
    return "";
  } catch (error) {
    if (!(error instanceof PresentationError)) throw error;
    return error.path || error.message.split(": ")[0] || "?";
  }
}

test("documents are refused where the contract says, and only those", () => {
  expect(contract.filter((c) => c.wrong).length).toBeGreaterThan(50);
  expect(contract.filter((c) => !c.wrong).length).toBeGreaterThan(20);
  for (const { document, wrong } of contract) {
    expect(wrongPath(JSON.parse(document)), document).toBe(wrong);
  }
});

/** What a schema cannot say: that keys exist, differ, and stand in order. */
const beyondSchema = /no result has|already|must be less|is above hi|signed result|same label/;

test("the schema allows what the reader allows and refuses what it refuses", () => {
  for (const { document, wrong } of contract) {
    const value: unknown = JSON.parse(document);
    let reason = "";
    try {
      parsePresentation(value);
    } catch (error) {
      reason = String(error);
    }
    const refused = violations(value, schema).length > 0;
    if (wrong && beyondSchema.test(reason)) continue;
    expect(refused, `${document}: ${reason}`).toBe(wrong !== "");
  }
});

test("the schema knows every colour map", () => {
  expect(schema.$defs.colour.properties.map.enum).toEqual([...colourMaps(), null]);
});

test("the boiler's presentation is right and says what it says", () => {
  expect(violations(boiler, schema)).toEqual([]);
  const presentation = parsePresentation(boiler);

  expect(presentation.results.map((r) => `${r.key} ${r.name}.${r.component}`)).toEqual([
    "T temperature.value",
    "U displacement.magnitude",
    "S stress.von_mises",
  ]);
  expect(presentation.effects.map((e) => `${e.result} ${e.type}`)).toEqual([
    "T colour",
    "U pitch",
    "S pulses",
  ]);
  expect(presentation.effects[0]).toMatchObject({ colour: defaultColour });
  expect(presentation.effects[2]).toMatchObject({ fallback: { rateLow: 1.5, rateHigh: 12 } });
  expect(presentation.results[2]?.limit).toEqual({ value: 250, kind: "above", label: "250 MPa" });
  expect(presentation.results[2]?.rangeMode).toBe("percentile");
  expect(presentation.deformation).toBe("U");
  expect(presentation.card).toEqual(["T", "U", "S"]);
});

test("what C++ writes is right by the schema", () => {
  const written: unknown = JSON.parse(projectFile("tests/data/present/boiler.json"));

  expect(violations(written, schema)).toEqual([]);
});

test("keys of an object's prototype are no keys", () => {
  expect(wrongPath(JSON.parse('{"effects": [{"result": "constructor", "type": "colour"}]}'))).toBe(
    "effects[0].result",
  );
  expect(parsePresentation({}).title).toBe("");
});
