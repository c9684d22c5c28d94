// Written by `npm version` (web/scripts/version.mjs); a test compares it with package.json.

/** The version of the package: '1.0.0'. */
export const version: string = '1.0.0';
