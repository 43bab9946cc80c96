// Compares reports with the schema, key by key and in both directions.

import assert from 'node:assert/strict';
import { isIn, isNullable, typesOf } from '../../scripts/lib/report-schema.mjs';
import { isOptionOf } from '../../scripts/lib/schema.mjs';
import { SCHEMA } from './schema.mjs';

const TYPES = typesOf(SCHEMA);
const PLAIN = {
  number: (value) => typeof value === 'number',
  integer: Number.isInteger,
  count: (value) => Number.isInteger(value) && value >= 0,
  index: (value) => Number.isInteger(value) && value >= 0,
  long: Number.isInteger,
  boolean: (value) => typeof value === 'boolean',
  text: (value) => typeof value === 'string',
  pair: (value) => value.length === 2 && value.every(Number.isInteger),
  numbers: (value) => value instanceof Float64Array,
};

/** Checks reports of a product, 'cli' or 'package', and remembers which fields they had. */
export class ReportKeys {
  #product;
  #seen = new Set();

  constructor(product) {
    this.#product = product;
  }

  /**
   * Asserts that the object has the keys of the struct, in their order, with values of their types.
   */
  check(object, name) {
    const fields = this.#fields(name);
    const expected = fields.filter((field) => !field.absent || field.name in object);
    const keys = expected.map((field) => field.name);
    assert.deepEqual(Object.keys(object), keys, name);
    for (const field of expected) this.#checkField(object[field.name], field, name);
  }

  /** Fields that no report had, or only with null, empty or zero values. */
  unseen(...names) {
    return names
      .flatMap((name) => this.#all(name))
      .filter((path) => !this.#seen.has(path))
      .sort();
  }

  #fields(name) {
    const { fields, extends: base } = TYPES.get(name).struct;
    const own = fields.filter((field) => isIn(field, this.#product));
    return base ? [...this.#fields(base), ...own] : own;
  }

  #checkField(value, field, owner) {
    const path = `${owner}.${field.name}`;
    if (field.type === 'group') {
      assert.deepEqual(
        Object.keys(value),
        field.fields.map(({ name }) => name),
        path,
      );
      for (const member of field.fields) this.#checkField(value[member.name], member, path);
    } else if (field.nullFields) {
      const known = Object.entries(value).filter(([, each]) => each !== null);
      assert.deepEqual(
        Object.keys(value),
        this.#fields(field.type).map(({ name }) => name),
        path,
      );
      for (const [, each] of known) assert.equal(typeof each, 'number', path);
      this.#note(path, known.length > 0);
    } else if (value === null) {
      assert.ok(isNullable(field, this.#product), `${path} is null`);
    } else if (field.list) {
      assert.ok(Array.isArray(value), path);
      for (const element of value) this.#checkValue(element, field.type, path);
    } else {
      this.#checkValue(value, field.type, path);
    }
  }

  #checkValue(value, type, path) {
    const { struct, names, options } = TYPES.get(type);
    if (struct) this.check(value, type);
    else if (names) assert.ok(names.includes(value), `${path} is ${value}`);
    else if (options)
      assert.deepEqual(
        Object.keys(value),
        options.filter((option) => isOptionOf(option, this.#product)).map(({ name }) => name),
        path,
      );
    else assert.ok(PLAIN[type](value), `${path} is ${JSON.stringify(value)}`);
    this.#note(path, ![0, '', false].includes(value));
  }

  #note(path, hasMeaning) {
    if (hasMeaning) this.#seen.add(path);
  }

  /** Paths of all fields that a report may have. */
  #all(name) {
    return this.#fields(name).flatMap((field) => {
      const path = `${name}.${field.name}`;
      if (field.type === 'group') return field.fields.map((member) => `${path}.${member.name}`);
      const { struct } = TYPES.get(field.type);
      return struct && !field.nullFields ? [path, ...this.#all(field.type)] : [path];
    });
  }
}
