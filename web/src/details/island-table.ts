import { UV_FAULT } from 'abflat';
import '../css/island-table.css';
import { create } from '../base/dom';
import type { ChartAreas } from '../mesh/chart-areas';
import type { Packed } from '../model/model';
import { CHART_LIST } from '../words/charts';
import { count, measure } from '../words/format';
import { ISLAND_COLUMNS, ISLAND_LIST } from '../words/islands';

/** Nobody reads more rows, and they would be slow. */
const MOST_ROWS = 200;

export interface IslandTableEvents {
  /** The pointer is over an island; null: over none any more. */
  pointed(island: number | null): void;
  chosen(island: number): void;
}

export interface Island {
  index: number;
  triangles: number;
  /** Share of the surface's area. */
  share: number;
  /** Texels per unit of the mesh. */
  density: number;
  /** Triangles with each fault. */
  faults: Record<keyof typeof UV_FAULT, number>;
  /** Those that it is stacked with. */
  stackedWith: number[];
}

interface Column {
  name: string;
  title: string;
  text(island: Island): string;
  /** What rows are sorted by. */
  key(island: Island): number;
}

const faultyOf = ({ faults }: Island) => Object.values(faults).reduce((sum, n) => sum + n, 0);

const COLUMNS: Column[] = [
  { ...ISLAND_COLUMNS.island, text: ({ index }) => count(index), key: ({ index }) => -index },
  {
    ...ISLAND_COLUMNS.triangles,
    text: ({ triangles }) => count(triangles),
    key: ({ triangles }) => triangles,
  },
  {
    ...ISLAND_COLUMNS.area,
    text: ({ share }) => `${(100 * share).toPrecision(2)}\u202f%`,
    key: ({ share }) => share,
  },
  {
    ...ISLAND_COLUMNS.density,
    text: ({ density }) => measure(density),
    key: ({ density }) => density,
  },
  {
    ...ISLAND_COLUMNS.faults,
    text: (island) => ISLAND_LIST.faults(island.faults, island.stackedWith) || '\u2013',
    key: (island) => faultyOf(island) + Number(island.stackedWith.length > 0) / 2,
  },
];

const FAULTS = COLUMNS.length - 1;

/** Of each island, from what is drawn of it. */
export function islandsOf({ result, fileStacks }: Packed, { flat, solid }: ChartAreas): Island[] {
  const { islandOfTriangle, report } = result;
  const faults = fileStacks?.faults ?? result.faults;
  const total = solid.reduce((sum, area) => sum + area, 0);
  const stackOf = new Map(fileStacks?.stacks.flatMap((stack) => stack.map((i) => [i, stack])));
  const islands = Array.from(
    solid,
    (area, index): Island => ({
      index,
      triangles: 0,
      share: total > 0 ? area / total : 0,
      density: area > 0 ? report.resolution * Math.sqrt(flat[index] / area) : 0,
      faults: { overlapping: 0, outside: 0, empty: 0, flipped: 0 },
      stackedWith: (stackOf.get(index) ?? []).filter((other) => other !== index),
    }),
  );
  islandOfTriangle.forEach((index, f) => {
    const island = islands[index];
    if (!island) return; // without texcoords
    ++island.triangles;
    for (const fault of Object.keys(UV_FAULT) as (keyof typeof UV_FAULT)[])
      if (faults[f] & UV_FAULT[fault]) ++island.faults[fault];
  });
  return islands;
}

/** The uv islands of a file, sorted by any column: first those with the most faults. */
export class IslandTable {
  readonly element = create('table', 'data-table chart-table island-table');
  private readonly body = create('tbody', '');
  private readonly headers: HTMLTableCellElement[] = [];
  private readonly more = create('caption', 'panel-text');
  private islands: Island[] = [];
  private selected: ReadonlySet<number> = new Set();
  private order = { column: FAULTS, sign: -1 };

  constructor(private readonly events: IslandTableEvents) {
    const head = create('thead', '');
    head.append(this.headRow());
    this.element.ariaLabel = ISLAND_LIST.caption;
    this.element.append(this.more, head, this.body);
    for (const type of ['mouseleave', 'focusout'] as const)
      this.body.addEventListener(type, () => events.pointed(null));
  }

  show(islands: Island[]): void {
    this.islands = islands;
    this.fill();
  }

  showSelected(islands: ReadonlySet<number>): void {
    this.selected = islands;
    for (const row of this.body.rows)
      row.ariaSelected = String(islands.has(Number(row.dataset.chart)));
  }

  private fill(): void {
    const { column, sign } = this.order;
    const { key } = COLUMNS[column];
    const sorted = [...this.islands].sort(
      (a, b) => sign * (key(a) - key(b)) || b.share - a.share || a.index - b.index,
    );
    this.body.replaceChildren(...sorted.slice(0, MOST_ROWS).map((island) => this.row(island)));
    this.headers.forEach((header, i) => {
      header.ariaSort = i !== column ? 'none' : sign < 0 ? 'descending' : 'ascending';
    });
    const left = sorted.length - MOST_ROWS;
    this.more.textContent = left > 0 ? CHART_LIST.more(left) : '';
  }

  private headRow(): HTMLTableRowElement {
    const row = create('tr', '');
    COLUMNS.forEach(({ name, title }, column) => {
      const cell = create('th', '');
      cell.scope = 'col';
      const button = create('button', 'sort', name);
      button.type = 'button';
      button.title = title;
      button.addEventListener('click', () => {
        this.order = { column, sign: this.order.column === column ? -this.order.sign : -1 };
        this.fill();
      });
      cell.append(button);
      this.headers.push(cell);
      row.append(cell);
    });
    return row;
  }

  private row(island: Island): HTMLTableRowElement {
    const { index } = island;
    const row = create('tr', '');
    row.dataset.chart = String(index);
    row.ariaSelected = String(this.selected.has(index));
    row.append(...COLUMNS.slice(1).map(({ text }) => create('td', '', text(island))));
    row.prepend(nameCell(index));
    if (faultyOf(island) > 0) row.lastElementChild?.classList.add('bad');
    row.addEventListener('mouseenter', () => this.events.pointed(index));
    row.addEventListener('focusin', () => this.events.pointed(index));
    row.addEventListener('click', () => this.events.chosen(index));
    return row;
  }
}

function nameCell(index: number): HTMLElement {
  const cell = create('th', '');
  cell.scope = 'row';
  const button = create('button', 'chart-name', count(index));
  button.type = 'button';
  button.ariaLabel = CHART_LIST.show(index);
  cell.append(button);
  return cell;
}
