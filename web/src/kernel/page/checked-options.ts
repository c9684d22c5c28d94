// Options of calls, whose names are checked: a name that is written wrong would have no effect.

import { failure, type GirthError } from '../types/errors.js';
import { warnOfOlder } from '../types/older-names.js';
import type { CallOptionNames } from '../types/option-names.js';

/** The error USAGE where options have a name that is not one of `names`; names within options have a dot. */
export function wrongOption(
  options: unknown,
  names: readonly string[],
  within = '',
): GirthError | undefined {
  if (typeof options !== 'object' || options === null) return undefined;
  for (const [key, value] of Object.entries(options)) {
    const name = within + key;
    if (!names.includes(name)) return unknownOption(name, names);
    const hasInner = names.some((one) => one.startsWith(`${name}.`));
    const inner = hasInner ? wrongOption(value, names, `${name}.`) : undefined;
    if (inner) return inner;
  }
  return undefined;
}

/** Older names of options, until 2.0. */
const olderNames: Readonly<Record<string, string>> = {
  thickness: 'shapeDiameter',
  'sdf.coneAngle': 'coneRadians',
  'thickness.sharpAngle': 'sharpRadians',
};

/** Options with each older name replaced by the present one, and a warning of it. */
function withPresentNames(options: unknown, names: readonly string[], within = ''): unknown {
  if (typeof options !== 'object' || options === null) return options;
  const entries = Object.entries(options).map(([key, value]): [string, unknown] => {
    const [name, now] = [within + key, olderNames[within + key]];
    if (names.some((one) => one.startsWith(`${name}.`))) {
      return [key, withPresentNames(value, names, `${name}.`)];
    }
    if (!now || names.includes(name) || !names.includes(within + now)) return [key, value];
    warnOfOlder(name, now);
    return [now, value];
  });
  return Object.fromEntries(entries);
}

type Call = (this: unknown, ...args: unknown[]) => Promise<unknown>;

/** Makes calls that return promises check the names of their options first; older names still work. */
export function checkCalls(owner: object, names: CallOptionNames): void {
  const calls = owner as Record<string, Call>;
  for (const [call, parameters] of Object.entries(names)) {
    const unchecked = calls[call]!;
    calls[call] = function (...args) {
      for (const [place, known] of Object.entries(parameters)) {
        const at = Number(place);
        const options = withPresentNames(args[at], known);
        const wrong = wrongOption(options, known);
        if (wrong) return Promise.reject(wrong);
        if (at in args) args[at] = options;
      }
      return unchecked.apply(this, args);
    };
  }
}

function unknownOption(name: string, names: readonly string[]): GirthError {
  const [nearest] = names
    .map((known) => ({ known, edits: editsBetween(name, known) }))
    .filter(({ known, edits }) => edits <= Math.max(1, name.length / 3) && edits < known.length)
    .sort((a, b) => a.edits - b.edits);
  const hint = nearest ? `did you mean ${nearest.known}?` : `there are ${names.join(', ')}`;
  return failure('USAGE', `there is no option ${name}`, { hint });
}

/** The least number of letters to put in, leave out or change. */
function editsBetween(from: string, to: string): number {
  let row = Array.from({ length: to.length + 1 }, (_, i) => i);
  for (let i = 0; i < from.length; ++i) {
    const next = [i + 1];
    for (let k = 0; k < to.length; ++k) {
      const changed = row[k]! + (from[i] === to[k] ? 0 : 1);
      next.push(Math.min(changed, row[k + 1]! + 1, next[k]! + 1));
    }
    row = next;
  }
  return row[to.length]!;
}
