import { isTyping } from './dom';

/** Does what belongs to a key of the whole page, such as `Ctrl+S`; on a Mac that is Cmd+S, too. */
export function bindShortcuts(shortcuts: Record<string, () => void>): void {
  document.addEventListener('keydown', (event) => {
    const action = shortcuts[shortcutOf(event)];
    if (!action || (event.key.length === 1 && !hasCtrl(event) && isTyping(event.target))) return;
    event.preventDefault();
    if (!event.repeat) action();
  });
}

/** A sign such as ? is what it is, whatever keys it takes. */
function shortcutOf(event: KeyboardEvent): string {
  if (!hasCtrl(event)) return event.altKey ? '' : event.key;
  const modifiers = `Ctrl+${event.altKey ? 'Alt+' : ''}${event.shiftKey ? 'Shift+' : ''}`;
  return modifiers + event.key.toUpperCase();
}

const hasCtrl = ({ ctrlKey, metaKey }: KeyboardEvent) => ctrlKey || metaKey;
