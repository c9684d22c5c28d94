// Something that the page can do, as the command palette and the list of keys show it.

export interface Action {
  words: string;
  /** Where on the page it is, from the outside in. */
  place: string[];
  /** As `aria-keyshortcuts` has them. */
  keys: string[];
  /** Whether it is a switch that is on, or a choice that is chosen. */
  isOn: boolean;
  isPossible: boolean;
  run(): void;
}
