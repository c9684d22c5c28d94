// The browser that pictures are made with.

import { chromium } from 'playwright-core';

/** Chromium without a window: Debian's, or that of the environment variable CHROMIUM. */
export const launchChromium = () =>
  chromium.launch({
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu'],
  });
