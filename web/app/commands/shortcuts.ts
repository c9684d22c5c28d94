// Keys of controls, as their attribute `aria-keyshortcuts` has them: 'Control+Z Meta+Z' are two ways.

/** The first one that is there is the system's own: ⌘ on a Mac, Ctrl elsewhere. */
const isMac = /mac|iphone|ipad/i.test(navigator.platform);

const words: Record<string, string> = {
  Control: 'Ctrl',
  Meta: '⌘',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Escape: 'Esc',
  Plus: '+',
  Minus: '−',
};

/** A key with what is held meanwhile: 'Shift+ArrowUp'. */
export type Shortcut = string;

/** The keys of a control. */
export function shortcutsOf(control: Element): Shortcut[] {
  return control.getAttribute('aria-keyshortcuts')?.split(' ') ?? [];
}

/** The shortcuts that this system's keyboards have: not both Ctrl and ⌘. */
export function usualHere(shortcuts: readonly Shortcut[]): Shortcut[] {
  const foreign = isMac ? /^Control\+/ : /^Meta\+/;
  const own = shortcuts.filter((shortcut) => !foreign.test(shortcut));
  return own.length > 0 ? own : [...shortcuts];
}

/** The keys of a shortcut as keyboards show them. */
export function keyWords(shortcut: Shortcut): string[] {
  return shortcut.split('+').map((key) => words[key] ?? key);
}

/** The key's name in events. */
const eventKey = (key: string): string => ({ Plus: '+', Minus: '-' })[key] ?? key;

/** The event of a shortcut, to be handed to what listens for keys. */
export function eventOf(shortcut: Shortcut): KeyboardEvent {
  const held = shortcut.split('+');
  const key = eventKey(held.pop()!);
  return new KeyboardEvent('keydown', {
    key: key.length === 1 ? key.toLowerCase() : key,
    ctrlKey: held.includes('Control'),
    metaKey: held.includes('Meta'),
    shiftKey: held.includes('Shift'),
    cancelable: true,
  });
}

/** Whether an event is what a shortcut says. Signs are typed with Shift on some keyboards and without on others. */
export function isPressed(shortcut: Shortcut, event: KeyboardEvent): boolean {
  const wanted = eventOf(shortcut);
  const isSign = wanted.key.length === 1 && !/[\p{L}\p{N}]/u.test(wanted.key);
  return (
    wanted.key.toLowerCase() === event.key.toLowerCase() &&
    wanted.ctrlKey === event.ctrlKey &&
    wanted.metaKey === event.metaKey &&
    !event.altKey &&
    (isSign || wanted.shiftKey === event.shiftKey)
  );
}

/** Words on a control with its keys behind them: 'Undo (Ctrl+Z)'. */
export function withKeys(words: string, control: Element): string {
  const [first = ''] = usualHere(shortcutsOf(control));
  return `${words} (${keyWords(first).join('+')})`;
}
