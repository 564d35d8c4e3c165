// SPDX-License-Identifier: Apache-2.0
// The part of JSON Schema that our schemas use. A word it does not know is an error of the schema.

type Schema = Readonly<Record<string, unknown>>;

const silent = new Set(["$schema", "$defs", "title", "description", "default"]);

function typeOf(value: unknown): string[] {
  if (value === null) return ["null"];
  if (Array.isArray(value)) return ["array"];
  if (typeof value === "number") return Number.isInteger(value) ? ["number", "integer"] : ["number"];
  return [typeof value];
}

/** Paths of what the schema does not allow. */
export function violations(value: unknown, schema: Schema, root: Schema = schema, path = ""): string[] {
  const all: string[] = [];
  const check = (holds: boolean) => {
    if (!holds) all.push(path);
  };
  const sub = (part: unknown, of: unknown = value, at = path) => violations(of, part as Schema, root, at);
  const object = typeOf(value)[0] === "object" ? (value as Record<string, unknown>) : null;
  for (const [word, rule] of Object.entries(schema)) {
    if (word === "$ref") {
      const name = String(rule).replace("#/$defs/", "");
      all.push(...sub((root.$defs as Record<string, Schema>)[name]));
    } else if (word === "type") check(typeOf(value).some((t) => [rule].flat().includes(t)));
    else if (word === "const") check(value === rule);
    else if (word === "enum") check((rule as unknown[]).includes(value));
    else if (word === "minimum") check(typeof value !== "number" || value >= Number(rule));
    else if (word === "maximum") check(typeof value !== "number" || value <= Number(rule));
    else if (word === "pattern") check(typeof value !== "string" || new RegExp(String(rule)).test(value));
    else if (word === "minLength") check(typeof value !== "string" || value.length >= Number(rule));
    else if (word === "minItems") check(!Array.isArray(value) || value.length >= Number(rule));
    else if (word === "maxItems") check(!Array.isArray(value) || value.length <= Number(rule));
    else if (word === "items") {
      if (Array.isArray(value))
        value.forEach((item, i) => void all.push(...sub(rule, item, `${path}[${i}]`)));
    } else if (word === "required") check(!object || (rule as string[]).every((key) => key in object));
    else if (word === "properties") {
      for (const [key, part] of Object.entries(rule as Schema)) {
        if (object && key in object) all.push(...sub(part, object[key], path ? `${path}.${key}` : key));
      }
    } else if (word === "allOf") for (const part of rule as Schema[]) all.push(...sub(part));
    else if (word === "if") {
      if (sub(rule).length === 0 && schema.then) all.push(...sub(schema.then));
    } else if (word !== "then" && !silent.has(word)) throw new Error(`the schema uses '${word}'`);
  }
  return all;
}
