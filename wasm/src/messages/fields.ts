// Reads the objects of callers. What every object inherits does not count: any script of the page may
// have added to Object.prototype.

/**
 * A copy with the object's own properties and nothing else. Getters run once, before anything is
 * checked.
 */
export function ownFields<T extends object>(object: T): T {
  return { __proto__: null, ...object };
}

/** The value of a property that the object or its class has; its class may have a getter for it. */
export function fieldOf(object: unknown, name: string): unknown {
  return hasField(object, name) ? (object as Record<string, unknown>)[name] : undefined;
}

export function hasField(object: unknown, name: string): boolean {
  let holder: object | null = Object(object);
  while (holder && !Object.hasOwn(holder, name)) holder = Object.getPrototypeOf(holder);
  return holder !== null && (holder === object || Object.getPrototypeOf(holder) !== null);
}

/** These properties of an object, each read once. */
export function fieldsOf<K extends string>(
  object: unknown,
  names: readonly K[],
): Partial<Record<K, unknown>> {
  const fields: Partial<Record<K, unknown>> = ownFields({});
  for (const name of names)
    if (hasField(object, name)) fields[name] = (object as Record<K, unknown>)[name];
  return fields;
}
