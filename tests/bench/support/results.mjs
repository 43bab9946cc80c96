// Rows of results: printed as a table, appended to a CSV file, and judged.

import { spawnSync } from 'node:child_process';
import { appendFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname } from 'node:path';
import { ROOT } from '../../../scripts/lib/paths.mjs';

export const STAGES = ['read', 'connectivity', 'solve', 'layout', 'check', 'write'];

const cellOf = (value, digits) => {
  if (value === undefined || value === null) return '-';
  if (typeof value !== 'number' || Number.isInteger(value)) return String(value);
  return digits === undefined ? value.toExponential(1) : value.toFixed(digits);
};

/** Columns are `[title, key or function of the row, digits]`; without digits: scientific. */
export function printTable(columns, rows) {
  const lines = [
    columns.map(([title]) => title),
    ...rows.map((row) =>
      columns.map(([, key, digits]) =>
        cellOf(typeof key === 'function' ? key(row) : row[key], digits),
      ),
    ),
  ];
  const widths = columns.map((_, i) => Math.max(...lines.map((line) => line[i].length)));
  for (const line of lines)
    console.log(
      line.map((cell, i) => (i ? cell.padStart(widths[i]) : cell.padEnd(widths[i]))).join('  '),
    );
}

/** Least-squares slope of log time over log faces; undefined for fewer than two sizes. */
export function exponent(rows, timeOf) {
  const points = rows.map((row) => [Math.log(row.faces), Math.log(timeOf(row))]);
  if (points.length < 2) return undefined;
  const mean = (k) => points.reduce((sum, p) => sum + p[k], 0) / points.length;
  const [x, y] = [mean(0), mean(1)];
  const sum = (f) => points.reduce((total, p) => total + f(p), 0);
  return sum((p) => (p[0] - x) * (p[1] - y)) / sum((p) => (p[0] - x) ** 2);
}

export const totalOf = (row) => STAGES.reduce((sum, stage) => sum + row[stage], 0);

function machine() {
  const git = (...args) => spawnSync('git', args, { cwd: ROOT, encoding: 'utf8' }).stdout?.trim();
  const changed = git('status', '--porcelain', '--untracked-files=no') ? '+changes' : '';
  const [cpu] = cpus();
  return {
    date: new Date().toISOString().slice(0, 10),
    commit: `${git('rev-parse', '--short', 'HEAD') ?? 'unknown'}${changed}`,
    cpu: cpu?.model.trim() ?? 'unknown',
    cores: cpus().length,
  };
}

/** Appends rows with the same keys, in the order of `keys`. */
export function appendCsv(file, keys, rows) {
  const about = machine();
  const columns = [...Object.keys(about), ...keys];
  const quoted = (value) => (/[",]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value);
  const lineOf = (values) => `${values.map((value) => quoted(String(value ?? ''))).join(',')}\n`;
  mkdirSync(dirname(file), { recursive: true });
  const head = lineOf(columns);
  if (!existsSync(file)) appendFileSync(file, head);
  else if (!readFileSync(file, 'utf8').startsWith(head))
    throw new Error(`${file} has other columns; move it away`);
  for (const row of rows)
    appendFileSync(file, lineOf(columns.map((key) => ({ ...about, ...row })[key])));
  console.log(`appended to ${file}`);
}

/** What is wrong with the rows: invalid results, and more Newton steps than recorded. */
export function complaints(rows, recorded) {
  return rows.flatMap((row) => {
    const most = recorded[`${row.mesh} t=${row.t}`];
    return [
      ...(row.valid ? [] : [`${row.mesh}: the result is not valid`]),
      ...(row.identical === false
        ? [`${row.mesh}: one and two threads do not write the same bytes`]
        : []),
      ...(row.iterations > most
        ? [
            `${row.mesh}: ${row.iterations} Newton steps, ${most} are recorded in tests/bench/recorded.json`,
          ]
        : []),
    ];
  });
}
