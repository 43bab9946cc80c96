// The types of the package as text.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** Everything in types/ and the generated report types: of the sources (`ending` .ts) or of the compiled package (.d.ts). */
export function typesText(folder, ending) {
  const inside = readdirSync(join(folder, 'types')).filter((name) => name.endsWith(ending));
  return [`base/generated-report${ending}`, ...inside.map((name) => join('types', name))]
    .map((name) => readFileSync(join(folder, name), 'utf8'))
    .join('\n');
}
