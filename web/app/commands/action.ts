// Something that the page can do, as the command palette and the list of keys show it.

export interface Action {
  words: string;
  /** The place of the action on the page, from the outside in. */
  place: string[];
  /** The shortcuts, as `aria-keyshortcuts` has them. */
  keys: string[];
  /** Whether the action is a switch that is on, or a choice that is chosen. */
  isOn: boolean;
  isPossible: boolean;
  run(): void;
}
