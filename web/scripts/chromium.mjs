// The browser that pictures are made with, and that tests drive.

import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

/**
 * The program: what the environment variable CHROMIUM names; otherwise Debian's headless shell, which is Chromium's engine
 * without the browser around it, and takes three quarters of the time; or, where it is wanted or there is no other, all of Chromium.
 * @param {{ whole?: boolean }} [which] whole: with what is around a page, such as installing it. Default: false
 */
export function chromiumPath({ whole = false } = {}) {
  const shell = '/usr/bin/chromium-headless-shell';
  const usual = whole || !existsSync(shell) ? '/usr/bin/chromium' : shell;
  return process.env['CHROMIUM'] ?? usual;
}

/** Chromium without a window. */
export const launchChromium = () =>
  chromium.launch({ executablePath: chromiumPath(), args: ['--no-sandbox', '--disable-gpu'] });
