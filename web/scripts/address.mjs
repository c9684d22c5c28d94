// The project's address on the web: CITATION.cff has it as `repository-code`, once there is one, and nothing else does.

/**
 * The address that a citation names; undefined where it names none.
 * @param {string} citation text of CITATION.cff
 * @returns {string | undefined}
 */
export const addressIn = (citation) => /^repository-code: *'?([^'\s]+)/m.exec(citation)?.[1];

/**
 * A package's manifest with the addresses of repository, home page and bugs; without them where the citation names none.
 * @param {Record<string, unknown>} manifest
 * @param {string} citation text of CITATION.cff
 */
export function withAddress(manifest, citation) {
  const address = addressIn(citation);
  const others = Object.entries(manifest).filter(
    ([key]) => !['repository', 'homepage', 'bugs'].includes(key),
  );
  if (!address) return Object.fromEntries(others);
  const at = others.findIndex(([key]) => key === 'license');
  others.splice(
    at,
    0,
    ['repository', { type: 'git', url: `git+${address}.git` }],
    ['homepage', `${address}#readme`],
    ['bugs', `${address}/issues`],
  );
  return Object.fromEntries(others);
}
