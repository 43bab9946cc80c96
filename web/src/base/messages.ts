// What is said above the views until it is closed. Escape closes the newest.

/** How to close those that are shown, the newest last. */
const shown = new Map<HTMLElement, () => void>();

export function messageShown(box: HTMLElement, close: () => void): void {
  shown.delete(box);
  shown.set(box, close);
}

export function messageHidden(box: HTMLElement): void {
  shown.delete(box);
}

/** Whether Escape closes one, and so does nothing else. A run in flight is cancelled first. */
export const isMessageNext = () => shown.size > 0 && !document.body.ariaBusy;

/** What is open above the page comes first. */
export const closesSomething = ({ target }: KeyboardEvent) =>
  target instanceof Element && target.closest('dialog, [role="menu"]') !== null;

document.addEventListener('keydown', (event) => {
  if (event.key !== 'Escape' || closesSomething(event) || !isMessageNext()) return;
  [...shown.values()].at(-1)?.();
  event.stopImmediatePropagation();
});
