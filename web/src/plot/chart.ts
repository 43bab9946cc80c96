import { create } from '../base/dom';
import type { ChartSpec, Column, Table } from './chart-spec';
import { columnAreas, drawAxes, drawKey, drawSeries, type Frame, frameOf } from './draw';
import { svg } from './svg';

const KEYS: Record<string, (i: number, last: number) => number> = {
  ArrowLeft: (i) => i - 1,
  ArrowRight: (i) => i + 1,
  Home: () => 0,
  End: (_, last) => last,
};

let charts = 0;

/**
 * A chart that fills the width of its element. Values are read out under the pointer, with the
 * arrow keys and in a hidden table.
 */
export class Chart {
  private readonly id = `chart-${++charts}`;
  private readonly caption = create('figcaption', 'chart-caption');
  private readonly picture = svg('svg', { class: 'chart-picture', role: 'group' });
  private readonly table = create('table', '');
  private spec: ChartSpec | null = null;
  /** The x of the column that Tab reaches. */
  private entry: number | null = null;

  /**
   * `read` gets the text of the column that is under the pointer or has the focus, null if there is
   * none.
   */
  constructor(
    figure: HTMLElement,
    private readonly height: number,
    private readonly read: (text: string | null) => void,
  ) {
    this.picture.setAttribute('aria-labelledby', `${this.id}-title`);
    this.picture.setAttribute('aria-describedby', `${this.id}-desc`);
    const hidden = create('div', 'visually-hidden');
    hidden.append(this.table);
    figure.classList.add('chart');
    figure.append(this.caption, this.picture, hidden);
    this.picture.style.height = `${height}px`;
    this.picture.addEventListener('pointerleave', () => this.point(null));
    // Not on the picture, since Chromium would then make it a tab stop.
    figure.addEventListener('focusout', () => this.point(null));
    figure.addEventListener('keydown', (event) => this.onKey(event));
    new ResizeObserver(() => this.draw()).observe(this.picture);
  }

  show(spec: ChartSpec): void {
    this.spec = spec;
    this.caption.replaceChildren(spec.title, legendOf(spec));
    fillTable(this.table, spec.title, spec.table);
    this.draw();
  }

  private draw(): void {
    const width = this.picture.clientWidth;
    if (!this.spec || width === 0) return;
    const { spec } = this;
    const hadFocus = this.picture.contains(document.activeElement);
    const frame = frameOf(spec, width, this.height);
    this.picture.setAttribute('viewBox', `0 0 ${width} ${this.height}`);
    this.picture.replaceChildren(
      svg('title', { id: `${this.id}-title` }, spec.title),
      svg('desc', { id: `${this.id}-desc` }, spec.description),
      drawAxes(spec, frame),
      svg('line', {
        class: 'chart-pointer',
        y1: frame.top,
        y2: frame.bottom,
        visibility: 'hidden',
      }),
      ...spec.series.map((series) => drawSeries(series, frame)),
      ...this.drawColumns(frame),
    );
    if (hadFocus)
      this.columns()
        .find((column) => column.tabIndex === 0)
        ?.focus();
  }

  private drawColumns(frame: Frame): SVGRectElement[] {
    const { columns = [] } = this.spec ?? {};
    const areas = columnAreas(columns, frame, this.height);
    const entry = Math.max(
      0,
      columns.findIndex(({ x }) => x === this.entry),
    );
    return columns.map((column, i) => {
      const rect = svg('rect', {
        class: column.select ? 'chart-column selectable' : 'chart-column',
        ...areas[i],
        role: column.select ? 'button' : 'img',
        tabindex: i === entry ? 0 : -1,
        'aria-label': column.text,
      });
      rect.addEventListener('pointerenter', () => this.point(column, frame.x(column.x)));
      rect.addEventListener('focus', () => this.point(column, frame.x(column.x)));
      if (column.select) rect.addEventListener('click', column.select);
      return rect;
    });
  }

  private point(column: Column | null, x = 0): void {
    const line = this.picture.querySelector('.chart-pointer');
    line?.setAttribute('visibility', column ? 'visible' : 'hidden');
    line?.setAttribute('x1', String(x));
    line?.setAttribute('x2', String(x));
    this.read(column?.text ?? null);
  }

  private columns(): SVGRectElement[] {
    return [...this.picture.querySelectorAll<SVGRectElement>('.chart-column')];
  }

  private onKey(event: KeyboardEvent): void {
    const columns = this.columns();
    const i = columns.findIndex((column) => column.matches(':focus'));
    if (i < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      this.spec?.columns[i].select?.();
      return;
    }
    const to = KEYS[event.key]?.(i, columns.length - 1);
    if (to === undefined) return;
    event.preventDefault();
    const next = Math.min(columns.length - 1, Math.max(0, to));
    this.entry = this.spec?.columns[next].x ?? null;
    columns[i].tabIndex = -1;
    columns[next].tabIndex = 0;
    columns[next].focus();
  }
}

/** Names of the series, if there is more than one. */
function legendOf({ series }: ChartSpec): HTMLElement {
  const legend = create('span', 'chart-legend');
  if (series.length < 2) return legend;
  for (const each of series) {
    const item = create('span', 'chart-legend-item');
    item.append(drawKey(each), each.name);
    legend.append(item);
  }
  return legend;
}

function fillTable(table: HTMLTableElement, title: string, { head, rows }: Table): void {
  const row = (tag: 'th' | 'td', cells: string[]) => {
    const made = create('tr', '');
    made.append(...cells.map((cell) => create(tag, '', cell)));
    return made;
  };
  table.replaceChildren(
    create('caption', '', title),
    row('th', head),
    ...rows.map((cells) => row('td', cells)),
  );
}
