// Gives any mesh an atlas: node unwrap.mjs mesh.obj mesh-uv.obj

import { readFile, writeFile } from 'node:fs/promises';
import { createAbflat } from 'abflat';

const [input = 'mesh.obj', output = 'mesh-uv.obj'] = process.argv.slice(2);

const abflat = await createAbflat();
const bytes = await readFile(input);
const { obj, report } = await abflat.unwrap({ bytes, name: input }, { padding: 4, obj: true });
await writeFile(output, obj);
console.log(report.valid, report.charts.length, report.atlas.utilization);
