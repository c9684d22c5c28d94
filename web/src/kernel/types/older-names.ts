// Older names of options and members. They work until 2.0, with a warning; web/docs/stable.md lists them.

const warned = new Set<string>();

/** Warns of an older name, once for each. */
export function warnOfOlder(name: string, now: string): void {
  if (warned.has(name)) return;
  warned.add(name);
  console.warn(`${name} is the older name of ${now}, until 2.0`);
}

/** Lets members be read by older names, too. Copies and listings of the object leave these out. */
export function alsoNamed<Found extends object>(
  found: Found,
  older: Readonly<Record<string, keyof Found & string>>,
): Found {
  for (const [name, now] of Object.entries(older)) {
    Object.defineProperty(found, name, {
      get: () => {
        warnOfOlder(name, now);
        return found[now];
      },
    });
  }
  return found;
}

/** The object with the present name of a member that was given by the older one. */
export function withPresentName<Given extends object>(
  given: Given,
  older: string,
  now: keyof Given & string,
): Given {
  if (now in given || !(older in given)) return given;
  warnOfOlder(older, now);
  return { ...given, [now]: (given as Record<string, unknown>)[older] };
}
