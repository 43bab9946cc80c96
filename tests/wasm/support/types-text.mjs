// The types of the package as text.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** Of types.ts, what is generated for it and all in types/, where `folder` is that of the sources; or of what is compiled, with `ending` .d.ts. */
export function typesText(folder, ending) {
  const inside = readdirSync(join(folder, 'types')).filter((name) => name.endsWith(ending));
  return [
    `types${ending}`,
    `generated-report${ending}`,
    ...inside.map((name) => join('types', name)),
  ]
    .map((name) => readFileSync(join(folder, name), 'utf8'))
    .join('\n');
}
