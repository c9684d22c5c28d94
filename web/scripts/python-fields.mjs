// Python's call for fields, of the parameters in `fields.def`.

import { inPython, sentences, wrapped } from './results.mjs';

/** Annotations of arguments and their words in the manual, by the kind of a parameter. */
const passed = /** @type {Record<string, [annotation: string, words: string]>} */ ({
  Count: ['Optional[int]', 'int, optional'],
  Degrees: ['Optional[float]', 'float, in degrees, optional'],
  Length: ['Optional[float]', 'float, optional'],
  Method: ['bool', 'bool, optional'],
  Points: ['Any', 'point or sequence of points, optional'],
});

/**
 * The name of a parameter: `from` is a word of Python.
 * @param {string} keyword
 */
const nameOf = (keyword) => (keyword === 'from' ? 'from_' : keyword);

/**
 * The method `field` of a mesh.
 * @param {{ keyword: string, fields: string[], kind: string, comment: string, words: string }[]} parameters
 */
export function pythonFields(parameters) {
  const own = parameters.filter(({ kind }) => kind !== 'Persistence');
  const signature = own.map(({ keyword, kind }) => {
    const [annotation = ''] = passed[kind] ?? [];
    return `        ${nameOf(keyword)}: ${annotation} = ${kind === 'Method' ? 'False' : 'None'},\n`;
  });
  const manual = own.map(({ keyword, fields, kind, comment, words }) => {
    const of = fields.map((one) => `\`\`'${one}'\`\``).join(' and ');
    // The member of C++ has another form: an enumeration, or radians.
    const isOther = kind === 'Method' || kind === 'Degrees';
    const manual = isOther ? `${words}.` : inPython(sentences(comment));
    return `        ${nameOf(keyword)} : ${passed[kind]?.[1]}\n${wrapped(`For ${of}: ${manual}`, ' '.repeat(12))}`;
  });
  const given = own.map(({ keyword, kind }) => {
    const value = kind === 'Method' ? `${nameOf(keyword)} or None` : nameOf(keyword);
    return `            "${keyword}": ${value},\n`;
  });
  return `"""The fields of a mesh. Made of cpp/include/girth/fields.def by \`npm run build:tables\`: not to be edited."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from pygirth._arguments import Progress
from pygirth.results import Field


class Fields:
    def _field(
        self,
        name: str,
        given: dict[str, Any],
        pairs: Optional[int],
        times: Optional[Sequence[float]],
        threads: Optional[int],
        progress: Progress,
    ) -> Field:
        raise NotImplementedError

    def field(
        self,
        name: str,
        *,
${signature.join('')}        pairs: Optional[int] = None,
        times: Optional[Sequence[float]] = None,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Field:
        """A function with one value for each vertex, or several.

        Parameters
        ----------
        name : str
            One of \`FIELDS\`; the documentation of the outputs states what each is.
${manual.join('')}        pairs : int, optional
            For \`\`'hks'\`\`, \`\`'sihks'\`\` and \`\`'wks'\`\`: eigenpairs, 2 to 100,000.
        times : sequence of float, optional
            For \`\`'hks'\`\`: diffusion times as shares of the area.
        threads, progress
            As of \`igf\`; signatures and distances use one thread.

        Returns
        -------
        Field
            Its values have the shape (n,), of signatures (n, d).
        """
        given = {
${given.join('')}        }
        return self._field(name, given, pairs, times, threads, progress)
`;
}
