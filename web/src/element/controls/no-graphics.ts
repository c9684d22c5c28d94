// Reasons why there is no picture, and remedies.

import { GirthError } from '../../kernel/types/errors.js';
import type { GirthErrorFields } from '../../kernel/types/types.js';
import type { Graphics } from '../../view/index.js';

export const noGraphics: Record<'lost' | 'missing', GirthErrorFields> = {
  missing: {
    code: 'NO_WEBGL',
    element: -1,
    message:
      'This browser gives no 3D graphics: WebGL 2 is switched off or missing. Computing, plots, lists and ' +
      'exports work without the picture',
    hint:
      'switch on hardware acceleration in the settings of the browser (Chrome, Edge: System; Firefox: ' +
      'Performance) and start it again, or use another browser',
  },
  lost: {
    code: 'NO_WEBGL',
    element: -1,
    message: 'The browser has taken the 3D graphics away. Everything else goes on',
    hint: 'wait a moment; if the picture does not come back, close other pages with 3D graphics and reload this one',
  },
};

/** Throws NO_WEBGL where there is no picture. */
export function requireGraphics(graphics: Graphics): void {
  if (graphics !== 'drawing') throw new GirthError(noGraphics[graphics]);
}
