// SPDX-License-Identifier: Apache-2.0
// The part of JSON Schema that schema/*.json use.

/** Where `value` breaks `schema`: a list of "path: what is wrong". */
export function violations(schema, value, path = '') {
  if (schema.oneOf) {
    const fits = schema.oneOf.filter((option) => violations(option, value, path).length === 0).length;
    return fits === 1 ? [] : [`${path}: fits ${fits} of the ${schema.oneOf.length} forms`];
  }
  const found = [];
  if ('const' in schema && value !== schema.const) found.push(`${path}: is not ${schema.const}`);
  if (schema.enum && !schema.enum.includes(value)) found.push(`${path}: ${JSON.stringify(value)} is none of ${JSON.stringify(schema.enum)}`);
  if (schema.type && ![schema.type].flat().some((type) => isOf(type, value))) return [...found, `${path}: is no ${schema.type}`];
  if (schema.pattern && typeof value === 'string' && !new RegExp(schema.pattern).test(value)) found.push(`${path}: '${value}' does not match ${schema.pattern}`);
  if (schema.minimum !== undefined && value < schema.minimum) found.push(`${path}: ${value} is too small`);
  if (schema.exclusiveMinimum !== undefined && value <= schema.exclusiveMinimum) found.push(`${path}: ${value} is too small`);
  if (Array.isArray(value)) {
    if (value.length < (schema.minItems ?? 0) || value.length > (schema.maxItems ?? Infinity)) found.push(`${path}: has ${value.length} entries`);
    if (schema.items) found.push(...value.flatMap((entry, i) => violations(schema.items, entry, `${path}[${i}]`)));
  } else if (value !== null && typeof value === 'object') {
    for (const key of schema.required ?? []) if (!(key in value)) found.push(`${path}.${key}: is missing`);
    for (const [key, entry] of Object.entries(value)) {
      const rule = schema.properties?.[key] ?? schema.additionalProperties;
      if (rule) found.push(...violations(rule, entry, `${path}.${key}`));
    }
  }
  return found;
}

function isOf(type, value) {
  if (type === 'null') return value === null;
  if (type === 'array') return Array.isArray(value);
  if (type === 'object') return value !== null && typeof value === 'object' && !Array.isArray(value);
  if (type === 'integer') return Number.isInteger(value);
  return typeof value === type;
}
