// The names by which links refer to headings: those that repository views give them.

/**
 * The anchor of a heading, as it stands in Markdown.
 * @param {string} heading
 */
function nameOf(heading) {
  return heading
    .replace(/\[([^\]]*)\]\([^)]*\)/g, '$1')
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\p{M}_ -]/gu, '')
    .replace(/ /g, '-');
}

/**
 * The anchors of all headings of a document, in order; the second one of a name is numbered.
 * @param {string[]} headings
 */
export function anchorsOf(headings) {
  /** @type {Set<string>} */
  const taken = new Set();
  for (const heading of headings) {
    const name = nameOf(heading);
    let anchor = name;
    for (let copy = 1; taken.has(anchor); ++copy) anchor = `${name}-${copy}`;
    taken.add(anchor);
  }
  return [...taken];
}
