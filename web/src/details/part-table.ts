import '../css/objects.css';
import { create } from '../base/dom';
import { DensityField } from '../controls/density-field';
import type { NamedPart } from '../model/named-parts';
import { svg } from '../plot/svg';
import type { ChartStates } from '../view/chart-flags';
import { count } from '../words/format';
import { PART, PART_COLUMNS, type PartWords } from '../words/objects';
import { hiding, isIsolated, isolating, isWithin, selecting } from './part-charts';

/** What can be done to the charts of a part. */
export interface PartActions {
  /** What is selected and hidden. */
  readonly states: ChartStates;
  put(selected: ReadonlySet<number>, hidden: ReadonlySet<number>): void;
  /** Returns whether any of them can have it. */
  setDensity(density: number, charts: ReadonlySet<number>): boolean;
}

/** More would be slow. */
const MOST_ROWS = 1000;
const NONE: ReadonlySet<number> = new Set();

/** Shapes of icons; the last one of an eye shows that it is closed. */
const EYE = [
  'M1.500 8C5 3 11 3 14.500 8C11 13 5 13 1.500 8z',
  'M10 8a2 2 0 1 1-4 0a2 2 0 0 1 4 0z',
  'M3 13.500l10-11',
];
const CORNERS = [
  'M2.500 5.500v-3h3M10.500 2.500h3v3M13.500 10.500v3h-3M5.500 13.500h-3v-3',
  'M6 6h4v4h-4z',
];

/** The parts of one kind, one row each. */
export class PartTable {
  readonly place = create('div', 'parts');
  private readonly body = create('tbody', '');
  private readonly more = create('p', 'panel-text');
  private rows: Row[] = [];
  private chartCount = 0;

  constructor(
    private readonly words: PartWords,
    private readonly actions: PartActions,
    private readonly say: (text: string) => void,
  ) {
    const table = create('table', 'data-table part-table');
    const head = create('thead', '');
    head.append(headRow(words));
    table.append(create('caption', 'visually-hidden', words.caption), head, this.body);
    this.place.append(table, this.more);
  }

  list(parts: NamedPart[]): void {
    this.rows = parts.slice(0, MOST_ROWS).map((part, i) => this.row(part, i));
    this.body.replaceChildren(...this.rows.map(({ element }) => element));
    this.place.hidden = parts.length === 0;
    this.more.hidden = parts.length <= MOST_ROWS;
    this.more.textContent = PART.more(parts.length - MOST_ROWS);
  }

  /** `densities`: of all charts; null if they cannot have any. */
  show(
    chartsOf: (part: NamedPart) => ReadonlySet<number>,
    chartCount: number,
    densities: number[] | null,
  ): void {
    this.chartCount = chartCount;
    this.place.classList.toggle('without-density', densities === null);
    for (const row of this.rows) {
      row.charts = chartsOf(row.part);
      row.islands.textContent = count(row.charts.size);
      if (densities) row.density.update([...row.charts].map((chart) => densities[chart]));
    }
  }

  showStates({ selected, hidden }: ChartStates): void {
    for (const { charts, name, hide, isolate, element } of this.rows) {
      const isHidden = isWithin(charts, hidden);
      name.ariaPressed = String(isWithin(charts, selected));
      hide.ariaPressed = String(isHidden);
      isolate.ariaPressed = String(isIsolated(charts, this.chartCount, hidden));
      element.classList.toggle('is-hidden', isHidden);
    }
  }

  private row(part: NamedPart, i: number): Row {
    const { actions } = this;
    const name = nameOf(part, i, this.words);
    const field = create('input', 'number');
    field.type = 'number';
    field.step = 'any';
    field.inputMode = 'decimal';
    field.placeholder = PART.mixed;
    field.ariaLabel = PART.density(name);
    const put = ({ selected, hidden }: Pick<ChartStates, 'selected' | 'hidden'>) =>
      actions.put(selected, hidden);
    const row: Row = {
      part,
      charts: NONE,
      element: create('tr', ''),
      name: nameButton(part, name),
      islands: create('td', ''),
      density: new DensityField(
        field,
        (density) => {
          if (!actions.setDensity(density, row.charts)) row.density.putBack();
        },
        this.say,
      ),
      hide: iconButton(PART.hide(name), EYE),
      isolate: iconButton(PART.isolate(name), CORNERS),
    };
    row.hide.classList.add('eye');
    row.name.addEventListener('click', ({ shiftKey }) =>
      put(selecting(row.charts, shiftKey, actions.states)),
    );
    row.hide.addEventListener('click', () => put(hiding(row.charts, actions.states)));
    row.isolate.addEventListener('click', () =>
      put(isolating(row.charts, this.chartCount, actions.states)),
    );
    const triangles = part.runs.reduce((sum, [, length]) => sum + length, 0);
    row.element.append(
      cellOf('th', row.name),
      create('td', '', count(triangles)),
      row.islands,
      cellOf('td', field),
      cellOf('td', row.hide, row.isolate),
    );
    return row;
  }
}

interface Row {
  part: NamedPart;
  /** Those of the layout that have triangles of it. */
  charts: ReadonlySet<number>;
  element: HTMLTableRowElement;
  name: HTMLButtonElement;
  islands: HTMLElement;
  density: DensityField;
  hide: HTMLButtonElement;
  isolate: HTMLButtonElement;
}

function headRow(words: PartWords): HTMLTableRowElement {
  const row = create('tr', '');
  const { triangles, islands, density, actions } = PART_COLUMNS;
  for (const { name, title } of [words, triangles, islands, density]) {
    const cell = create('th', '', name);
    cell.scope = 'col';
    cell.title = title;
    row.append(cell);
  }
  const last = create('th', '');
  last.scope = 'col';
  last.append(create('span', 'visually-hidden', actions));
  row.append(last);
  return row;
}

function nameOf({ name, isThere }: NamedPart, i: number, { unnamed, none }: PartWords): string {
  if (name) return name;
  return isThere ? unnamed(i + 1) : none;
}

function nameButton({ copies }: NamedPart, name: string): HTMLButtonElement {
  const button = create('button', 'part-name', copies > 1 ? PART.copies(name, copies) : name);
  button.type = 'button';
  button.title = [name, ...(copies > 1 ? [PART.shared(copies)] : []), PART.aboutSelect].join('\n');
  return button;
}

function iconButton(label: string, paths: string[]): HTMLButtonElement {
  const button = create('button', 'part-button');
  button.type = 'button';
  button.ariaLabel = label;
  button.title = label;
  const icon = svg('svg', { class: 'icon', viewBox: '0 0 16 16', 'aria-hidden': 'true' });
  icon.append(...paths.map((d) => svg('path', { d })));
  button.append(icon);
  return button;
}

function cellOf(tag: 'th' | 'td', ...content: HTMLElement[]): HTMLElement {
  const cell = create(tag, '');
  if (cell instanceof HTMLTableCellElement && tag === 'th') cell.scope = 'row';
  cell.append(...content);
  return cell;
}
