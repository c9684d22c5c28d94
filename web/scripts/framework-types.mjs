// Types of `<girth-viewer>` for templates of frameworks: declarations that add it to a framework's own.
// Each is an entry of the package of its own, since it can be compiled only where the framework is.

/** @type {Record<'react' | 'vue', string>} declaration files beside `element.d.ts` */
export const frameworkTypes = {
  react: `/**
 * \`<girth-viewer>\` in JSX of React 19, by \`import type {} from 'girth/react';\`.
 * @module girth/react
 */
import type { GirthViewer, GirthViewerAttributes, GirthViewerEvents } from './element.js';

/** Listeners of the element's events: \`onfield\`, \`onpick\` and so on. */
type Listeners = {
  [Name in keyof GirthViewerEvents as \`on\${Name}\`]?: (event: GirthViewerEvents[Name]) => void;
};
/** Whatever the framework gives to every element, unless the element's own has that name. */
type Own<All> = Omit<All, keyof GirthViewerAttributes | keyof Listeners>;

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      /** A surface, its girth as colours, and the loop under the pointer. */
      'girth-viewer': Own<DetailedHTMLProps<HTMLAttributes<GirthViewer>, GirthViewer>> &
        GirthViewerAttributes &
        Listeners;
    }
  }
}
export {};
`,
  vue: `/**
 * \`<girth-viewer>\` in templates of Vue 3, by \`import type {} from 'girth/vue';\`.
 * @module girth/vue
 */
import type { GirthViewer, GirthViewerAttributes, GirthViewerEvents } from './element.js';

/** Listeners of the element's events: \`@field\`, \`@pick\` and so on. */
type Listeners = {
  [Name in keyof GirthViewerEvents as \`on\${Capitalize<Name>}\`]?: (
    event: GirthViewerEvents[Name],
  ) => void;
};

declare module 'vue' {
  interface GlobalComponents {
    /** A surface, its girth as colours, and the loop under the pointer. */
    'girth-viewer': new () => GirthViewer & {
      /** Properties that a template can set. */
      $props: Omit<HTMLAttributes, keyof GirthViewerAttributes | keyof Listeners> &
        GirthViewerAttributes &
        Listeners;
    };
  }
}
export {};
`,
};
