import type { UnwrapReport } from 'abflat';
import { create, element } from '../base/dom';
import type { Stack } from '../model/stacks';
import { svg } from '../plot/svg';
import { CHART_LIST, LOCKS } from '../words/charts';
import { VALIDITY } from '../words/details';
import { count, inPageWords } from '../words/format';
import { type ChartRow, COLUMNS, chartRows, type Order, sortedRows } from './chart-rows';

/** Nobody reads more rows, and they would be slow. */
const MOST_ROWS = 200;
/** Columns to sort by; initially, charts with the most faces come first. */
const BY_NUMBER = 0;
const BY_FACES = 1;

export interface ChartTableEvents {
  /** The pointer is over a chart; null: over none any more. */
  pointed(chart: number | null): void;
  chosen(chart: number): void;
  /** Locks or unlocks a chart. */
  locked(chart: number): void;
}

/** The charts of an atlas, one row each, sortable by any column. */
export class ChartTable {
  private readonly place = element('charts', HTMLElement);
  private readonly more = element('charts-more', HTMLElement);
  private readonly headers: HTMLTableCellElement[] = [];
  private readonly body = create('tbody', '');
  private rows: ChartRow[] = [];
  /** The number of each chart's colour. */
  private colors: ArrayLike<number> | null = null;
  private locks: ReadonlySet<number> = new Set();
  /** Those that cannot be unlocked here. */
  private keptUvs: ReadonlySet<number> = new Set();
  private stacks: Stack[] = [];
  private selected: ReadonlySet<number> = new Set();
  private order: Order = { column: BY_FACES, descending: true };

  constructor(private readonly events: ChartTableEvents) {
    const table = create('table', 'data-table chart-table');
    const head = create('thead', '');
    head.append(this.headRow());
    table.append(create('caption', 'visually-hidden', CHART_LIST.caption), head, this.body);
    this.place.append(table);
    for (const type of ['mouseleave', 'focusout'] as const)
      this.body.addEventListener(type, () => events.pointed(null));
  }

  show(report: UnwrapReport, colors: ArrayLike<number> | null, stacks: Stack[] = []): void {
    this.rows = chartRows(report);
    this.colors = colors;
    this.stacks = stacks;
    this.fill();
  }

  clear(): void {
    this.rows = [];
    this.fill();
  }

  showSelected(charts: ReadonlySet<number>): void {
    this.selected = charts;
    for (const row of this.body.rows)
      row.ariaSelected = String(charts.has(Number(row.dataset.chart)));
  }

  /** `keptUvs`: charts that have the uv of the file, and stay for that reason. */
  showLocks(charts: ReadonlySet<number>, keptUvs: ReadonlySet<number>): void {
    this.locks = charts;
    this.keptUvs = keptUvs;
    for (const button of this.body.querySelectorAll<HTMLElement>('.lock')) this.showLock(button);
  }

  private showLock(button: HTMLElement): void {
    const chart = Number(button.dataset.chart);
    const isKept = this.keptUvs.has(chart);
    button.ariaPressed = String(isKept || this.locks.has(chart));
    button.ariaDisabled = String(isKept);
    button.title = isKept ? LOCKS.keptUvs : LOCKS.about;
  }

  private fill(): void {
    const sorted = sortedRows(this.rows, this.order);
    this.body.replaceChildren(...sorted.slice(0, MOST_ROWS).map((row) => this.row(row)));
    this.headers.forEach((header, i) => {
      const isSorted = i === this.order.column;
      header.ariaSort = isSorted ? (this.order.descending ? 'descending' : 'ascending') : 'none';
    });
    const left = sorted.length - MOST_ROWS;
    this.more.hidden = left <= 0;
    this.more.textContent = CHART_LIST.more(left);
  }

  private headRow(): HTMLTableRowElement {
    const row = create('tr', '');
    COLUMNS.forEach(({ name, title }, column) => {
      const cell = create('th', '');
      cell.scope = 'col';
      const button = create('button', 'sort', name);
      button.type = 'button';
      button.title = title;
      button.addEventListener('click', () => this.sortBy(column));
      cell.append(button);
      this.headers.push(cell);
      row.append(cell);
    });
    const lock = create('th', '');
    lock.scope = 'col';
    lock.append(create('span', 'visually-hidden', LOCKS.column));
    row.append(lock);
    return row;
  }

  private sortBy(column: number): void {
    const isSame = this.order.column === column;
    const descending = isSame ? !this.order.descending : column !== BY_NUMBER;
    this.order = { column, descending };
    this.fill();
  }

  private row(row: ChartRow): HTMLTableRowElement {
    const { index, chart } = row;
    const made = create('tr', '');
    made.dataset.chart = String(index);
    made.ariaSelected = String(this.selected.has(index));
    COLUMNS.forEach(({ text }, column) => {
      if (column === 0) made.append(this.nameCell(index));
      else made.append(create('td', '', text(row)));
    });
    const verdict = made.lastElementChild as HTMLElement;
    verdict.className = chart.valid ? 'good' : 'bad';
    verdict.ariaLabel = chart.valid ? VALIDITY.valid : VALIDITY.notValid;
    verdict.title = inPageWords(chart.problem);
    made.append(this.lockCell(index));
    made.addEventListener('mouseenter', () => this.events.pointed(index));
    made.addEventListener('focusin', () => this.events.pointed(index));
    made.addEventListener('click', () => this.events.chosen(index));
    return made;
  }

  private lockCell(index: number): HTMLElement {
    const cell = create('td', 'lock-cell');
    const button = create('button', 'lock');
    button.type = 'button';
    button.dataset.chart = String(index);
    button.ariaLabel = LOCKS.lock(index);
    this.showLock(button);
    const icon = svg('svg', { class: 'icon', viewBox: '0 0 16 16', 'aria-hidden': 'true' });
    icon.append(
      svg('path', { class: 'lock-body', d: 'M3.500 7.500h9v6h-9z' }),
      svg('path', { d: 'M5.500 7.500v-2.500a2.500 2.500 0 0 1 5 0' }),
      svg('path', { class: 'lock-leg', d: 'M10.500 5v2.500' }),
    );
    button.append(icon);
    button.addEventListener('click', (event) => {
      event.stopPropagation();
      this.events.locked(index);
    });
    cell.append(button);
    return cell;
  }

  private nameCell(index: number): HTMLElement {
    const cell = create('th', '');
    cell.scope = 'row';
    const button = create('button', 'chart-name');
    button.type = 'button';
    if (this.colors) {
      const swatch = create('span', 'swatch');
      swatch.style.background = `var(--chart-${this.colors[index]})`;
      button.append(swatch);
    }
    button.append(count(index));
    button.ariaLabel = CHART_LIST.show(index);
    const stack = this.stacks.find((stack) => stack.includes(index));
    if (stack) {
      const what = CHART_LIST.stacked(stack.filter((other) => other !== index));
      button.append(stackMark(what));
      button.ariaLabel += `. ${what}`;
    }
    cell.append(button);
    return cell;
  }
}

/** Says which other charts lie on the same place. */
function stackMark(what: string): HTMLElement {
  const mark = create('span', 'stack-mark');
  mark.title = what;
  const icon = svg('svg', { class: 'icon', viewBox: '0 0 16 16', 'aria-hidden': 'true' });
  icon.append(svg('path', { d: 'M2.500 5.500h8v8h-8zM5.500 5.500v-3h8v8h-3' }));
  mark.append(icon);
  return mark;
}
