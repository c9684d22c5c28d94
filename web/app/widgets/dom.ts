// Finding elements, and making things once.

/** The element of that id, which the page must have. */
export function byId<Type extends HTMLElement = HTMLElement>(id: string): Type {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no element #${id}`);
  return element as Type;
}

/** A function that makes something when it is first asked for, and anew where that failed. */
export function once<Type>(make: () => Promise<Type>): () => Promise<Type> {
  let made: Promise<Type> | undefined;
  return () =>
    (made ??= make().catch((error: unknown) => {
      made = undefined;
      throw error;
    }));
}

/** Sets an attribute, or removes it where there is nothing to set. */
export function setAttribute(element: Element, name: string, value: string | undefined): void {
  if (value === undefined || value === '') element.removeAttribute(name);
  else element.setAttribute(name, value);
}

/** Lets the browser do what else there is to do. */
export const nextTask = (): Promise<void> => new Promise((done) => setTimeout(done));
