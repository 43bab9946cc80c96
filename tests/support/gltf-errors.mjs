// Runs Khronos' validator.

import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';

/** Errors in a file whose resources are in a folder. */
export async function errorsIn(path, folder) {
  const externalResourceFunction = async (uri) =>
    new Uint8Array(readFileSync(folder(decodeURIComponent(uri))));
  const report = await validator.validateBytes(new Uint8Array(readFileSync(path)), {
    externalResourceFunction,
  });
  return report.issues.messages.filter((m) => m.severity === 0);
}
