// Properties that have the name of an attribute but are something else, such as the method `loop`. Frameworks set
// properties where an element has one of the name: what they set is meant for the attribute.

import { type AttributeName, attributeNames } from './attributes.js';

/** Whatever is no object, set to a property of an attribute's name, sets the attribute from now on. */
export function takeTexts(prototype: HTMLElement): void {
  for (const name of attributeNames) {
    const key = name.replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase());
    const own = descriptorOf(prototype, key);
    if (own) Object.defineProperty(prototype, key, taking(name, own));
  }
}

function descriptorOf(prototype: object, key: string): PropertyDescriptor | undefined {
  for (let one: object | null = prototype; one; one = Object.getPrototypeOf(one) as object | null) {
    const own = Object.getOwnPropertyDescriptor(one, key);
    if (own) return own;
  }
  return undefined;
}

function taking(name: AttributeName, own: PropertyDescriptor): PropertyDescriptor {
  return {
    configurable: true,
    enumerable: own.enumerable ?? false,
    get(this: HTMLElement): unknown {
      return own.get ? (own.get.call(this) as unknown) : own.value;
    },
    set(this: HTMLElement, value: string | number | boolean | object | null | undefined) {
      if (typeof value === 'object' && value !== null) own.set?.call(this, value);
      else if (value === undefined || value === null || value === false) this.removeAttribute(name);
      else this.setAttribute(name, value === true ? '' : String(value));
    },
  };
}
