import type { MethodResult } from 'abflat';
import { create } from '../base/dom';
import { brief, count, duration, sentence } from '../base/format';

interface ColumnOf {
  name: string;
  title: string;
  value(method: MethodResult): string;
  isBad?(method: MethodResult): boolean;
}

const COLUMNS: ColumnOf[] = [
  { name: 'Time', title: 'Time for the layout only', value: ({ seconds }) => duration(seconds) },
  {
    name: 'Angle',
    title: 'Angular distortion: mean over corners of ((x - α)/α)²',
    value: ({ angularDistortion }) => orDash(angularDistortion),
  },
  {
    name: 'Length',
    title: 'Length distortion: mean over edges of (sL/l - 1)²',
    value: ({ lengthDistortion }) => orDash(lengthDistortion),
  },
  {
    name: 'Area',
    title: 'Area distortion: mean by 3D area of |log(area in the layout / area in 3D)|',
    value: ({ areaDistortion }) => orDash(areaDistortion),
  },
  {
    name: 'Flips',
    title: 'Flipped triangles',
    value: ({ flippedTriangles }) => count(flippedTriangles),
    isBad: ({ flippedTriangles }) => flippedTriangles > 0,
  },
  {
    name: 'Cross.',
    title: 'Pairs of boundary edges that cross or touch',
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
  table.append(create('caption', 'visually-hidden', 'Methods'), head, body);
  return table;
}

function headRow(): HTMLTableRowElement {
  const row = create('tr', '');
  for (const { name, title } of [{ name: 'Method', title: '' }, ...COLUMNS]) {
    const cell = create('th', '', name);
    cell.scope = 'col';
    cell.title = title;
    row.append(cell);
  }
  const valid = create('th', '');
  valid.scope = 'col';
  valid.append(create('span', 'visually-hidden', 'Valid'));
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
  verdict.ariaLabel = method.valid ? 'valid' : 'not valid';
  verdict.title = method.problem;
  row.append(verdict);
  row.addEventListener('click', () => {
    if (!button.disabled) select(method);
  });
  return row;
}

function orDash(value: number | null): string {
  return value === null ? '\u2013' : brief(value);
}
