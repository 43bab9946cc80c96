import type { MethodResult } from 'abflat';
import { create } from '../base/dom';
import { METHODS, VALIDITY } from '../words/details';
import { brief, count, distortion, duration, sentence } from '../words/format';
import { METHOD_COLUMNS } from '../words/methods';

interface ColumnOf {
  name: string;
  title: string;
  value(method: MethodResult): string;
  isBad?(method: MethodResult): boolean;
}

const COLUMNS: ColumnOf[] = [
  { ...METHOD_COLUMNS.time, value: ({ seconds }) => duration(seconds) },
  {
    ...METHOD_COLUMNS.angle,
    value: ({ angularDistortion }) => orDash(angularDistortion),
  },
  {
    ...METHOD_COLUMNS.length,
    value: ({ lengthDistortion }) => orDash(lengthDistortion),
  },
  {
    ...METHOD_COLUMNS.area,
    value: ({ areaDistortion }) => orDash(areaDistortion),
  },
  {
    ...METHOD_COLUMNS.flips,
    value: ({ flippedTriangles }) => count(flippedTriangles),
    isBad: ({ flippedTriangles }) => flippedTriangles > 0,
  },
  {
    ...METHOD_COLUMNS.crossings,
    value: ({ boundaryCrossings }) => count(boundaryCrossings),
    isBad: ({ boundaryCrossings }) => boundaryCrossings > 0,
  },
];

/** One row per method; `select` is called with the method of the chosen row. */
export function methodTable(
  methods: MethodResult[],
  select: (method: MethodResult) => void,
): HTMLTableElement {
  const table = create('table', 'data-table method-table');
  const head = create('thead', '');
  head.append(headRow());
  const body = create('tbody', '');
  body.append(...methods.map((method) => methodRow(method, select)));
  table.append(create('caption', 'visually-hidden', METHODS.caption), head, body);
  return table;
}

function headRow(): HTMLTableRowElement {
  const row = create('tr', '');
  for (const { name, title } of [{ name: METHODS.method, title: '' }, ...COLUMNS]) {
    const cell = create('th', '', name);
    cell.scope = 'col';
    cell.title = title;
    row.append(cell);
  }
  const valid = create('th', '');
  valid.scope = 'col';
  valid.append(create('span', 'visually-hidden', VALIDITY.column));
  row.append(valid);
  return row;
}

function methodRow(method: MethodResult, select: (method: MethodResult) => void): HTMLElement {
  const row = create('tr', '');
  const button = create('button', 'method-name');
  button.type = 'button';
  button.ariaPressed = 'false';
  button.disabled = method.uv.length === 0;
  const [name, ...detail] = method.title.split(', ');
  button.append(
    create('span', '', name === 'abflat' ? name : sentence(name)),
    ' ',
    create('span', 'method-detail', detail.join(', ')),
  );
  const first = create('th', '');
  first.scope = 'row';
  first.append(button);
  row.append(first);
  for (const { value, isBad } of COLUMNS)
    row.append(create('td', isBad?.(method) ? 'bad' : '', value(method)));
  const verdict = create('td', method.valid ? 'good' : 'bad', method.valid ? '\u2713' : '\u2717');
  verdict.ariaLabel = method.valid ? VALIDITY.valid : VALIDITY.notValid;
  verdict.title = method.problem;
  row.append(verdict);
  row.addEventListener('click', () => {
    if (!button.disabled) select(method);
  });
  return row;
}

function orDash(value: number | null): string {
  return value === null ? '\u2013' : distortion(value, brief);
}
