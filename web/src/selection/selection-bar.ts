import { element } from '../base/dom';
import { MenuButton } from '../controls/menu-button';
import type { ChartList } from '../model/arrangeable';
import type { ChartStates } from '../view/chart-flags';
import { SELECTION } from '../words/selection';

export interface SelectionActions {
  frame(): void;
  isolate(): void;
  hide(): void;
  showAll(): void;
  pickNone(): void;
  /** An entry of the menu was chosen, by its `data-value`. */
  arrange(how: string): void;
}

/** What is selected or hidden, with buttons for it. */
export class SelectionBar {
  private readonly bar = element('selection', HTMLElement);
  private readonly text = element('selection-text', HTMLElement);
  private readonly onSelected = (['frame', 'isolate', 'hide', 'none', 'arrange'] as const).map(
    (name) => element(`selection-${name}`, HTMLButtonElement),
  );
  /** What a gesture does so far. */
  private gesture: string | null = null;
  private readonly isolate = element('selection-isolate', HTMLButtonElement);
  private readonly showAll = element('selection-show-all', HTMLButtonElement);

  constructor(actions: SelectionActions) {
    const [frame, isolate, hide, none] = this.onSelected;
    frame.addEventListener('click', () => actions.frame());
    isolate.addEventListener('click', () => actions.isolate());
    hide.addEventListener('click', () => actions.hide());
    none.addEventListener('click', () => actions.pickNone());
    new MenuButton('selection-arrange', 'arrange-menu', (how) => actions.arrange(how));
    this.showAll.addEventListener('click', () => actions.showAll());
  }

  show({ selected, hidden }: ChartStates, report: ChartList | null): void {
    this.bar.hidden = report === null || (selected.size === 0 && hidden.size === 0);
    for (const button of this.onSelected) button.hidden = selected.size === 0;
    // It would show all, too.
    this.isolate.hidden ||= hidden.size > 0;
    this.showAll.hidden = hidden.size === 0;
    if (!report || this.bar.hidden) return;
    this.text.textContent = this.gesture ?? selectionText(selected, hidden, report);
    this.bar.classList.toggle('busy', this.gesture !== null);
  }

  /** Scrolls a view out from under the bar, which is at the foot of a phone's screen. */
  uncover(view: HTMLElement): void {
    const isDocked = !this.bar.hidden && getComputedStyle(this.bar).position === 'fixed';
    if (isDocked) view.scrollIntoView({ block: 'nearest' });
  }

  /** Shows what a gesture does in place of the buttons; null: the buttons again. */
  showGesture(text: string | null, states: ChartStates, report: ChartList | null): void {
    this.gesture = text;
    this.show(states, report);
  }
}

function selectionText(
  selected: ReadonlySet<number>,
  hidden: ReadonlySet<number>,
  { charts }: ChartList,
): string {
  if (selected.size === 0) return SELECTION.hidden(hidden.size);
  const sum = (of: (chart: (typeof charts)[number]) => number, numbers: Iterable<number>) =>
    [...numbers].reduce((total, chart) => total + of(charts[chart]), 0);
  const areaOf = (numbers: Iterable<number>) => sum(({ area }) => area ?? 0, numbers);
  const triangles = sum(({ faces }) => faces, selected);
  if (selected.size === 1) {
    const [chart] = selected;
    return SELECTION.one(chart, triangles, charts[chart].symmetricDirichlet ?? Number.NaN);
  }
  const share = areaOf(selected) / areaOf(charts.keys());
  return SELECTION.several(selected.size, triangles, share);
}
