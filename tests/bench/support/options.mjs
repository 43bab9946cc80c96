// The command line that both benchmarks share.

import { parseArgs } from 'node:util';
import { Failure } from '../../../scripts/lib/run.mjs';
import { meshName } from './mesh_files.mjs';

const USAGE = `Options:
  --sizes 10k,100k,360k,1.4M  faces of the generated heads
  --scans bunny-disk+3,face+0,face+1
                              disks, each face split into four so many times; "none": without. "face" is
                              ../shared/meshes/face.obj, and skipped where that is missing
  --t 2                       bound of the boundary angles, times pi
  --repeat 5                  medians of so many runs; of one from 1 M faces on, unless given
  --csv [FILE]                append the rows to FILE
  --check                     fail on invalid results and on more Newton steps than are recorded`;

const SUFFIXES = { k: 1e3, M: 1e6 };
const LARGE = 1e6;

function facesOf(word) {
  const match = /^(\d+(?:\.\d+)?)([kM]?)$/.exec(word);
  if (!match)
    throw new Failure(`"${word}" is not a number of faces such as 10k or 1.4M.\n${USAGE}`);
  return Math.round(Number(match[1]) * (SUFFIXES[match[2]] ?? 1));
}

function scanOf(word) {
  const name = meshName(word);
  if (!name) throw new Failure(`"${word}" is not a mesh such as bunny-disk+2.\n${USAGE}`);
  return name;
}

function numberOf(word, name, isGood) {
  const value = Number(word);
  if (word.trim() === '' || !isGood(value))
    throw new Failure(`--${name} cannot be "${word}".\n${USAGE}`);
  return value;
}

/** `--csv` alone means the default file. */
export const withCsvFile = (args, file) =>
  args.flatMap((arg, i) =>
    arg === '--csv' && (args[i + 1] ?? '--').startsWith('--') ? [arg, file] : [arg],
  );

function parse(args) {
  const text = (value) => ({ type: 'string', default: value });
  try {
    return parseArgs({
      args,
      options: {
        sizes: text('10k,100k,360k,1.4M'),
        scans: text('bunny-disk+3,face+0,face+1'),
        t: text('2'),
        repeat: { type: 'string' },
        csv: { type: 'string' },
        check: { type: 'boolean', default: false },
        help: { type: 'boolean', default: false },
      },
    }).values;
  } catch (error) {
    if (!String(error.code).startsWith('ERR_PARSE_ARGS')) throw error;
    throw new Failure(`${error.message}\n${USAGE}`);
  }
}

/** Undefined after the help text. */
export function benchOptions(args, csvFile) {
  const values = parse(withCsvFile(args, csvFile));
  if (values.help) {
    console.log(USAGE);
    return undefined;
  }
  const repeat =
    values.repeat && numberOf(values.repeat, 'repeat', (n) => Number.isInteger(n) && n > 0);
  return {
    sizes: values.sizes.split(',').map((word) => ({ name: `head-${word}`, faces: facesOf(word) })),
    scans: values.scans === 'none' ? [] : values.scans.split(',').map(scanOf),
    t: numberOf(values.t, 't', (n) => n > 0),
    repeatFor: (faces) => repeat ?? (faces >= LARGE ? 1 : 5),
    csv: values.csv,
    check: values.check,
  };
}
