// The parts of three.js that a bundler cannot leave out by itself, though nothing that Girth draws uses them: shaders
// are found by name when a program is compiled, so that a bundle has those of every material.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const moduleOf = createRequire(import.meta.url).resolve;

/** A piece of GLSL: `var name = "...";`. */
const piece = /^((?:var|const) ([\w$]+) = )"((?:[^"\\]|\\.)*)";/gm;
/** Numbers for physically based materials. */
const table = /^const DATA = new Uint16Array\( \[[^\]]*\] \);/m;

/** @param {string} text */
const includesOf = (text) => [...text.matchAll(/#include <(\w+)>/g)].map(([, name]) => name ?? '');

/**
 * A plugin that empties the shaders of materials that are not used. `LineBasicMaterial` uses those called
 * `meshbasic`; a `LineMaterial` includes some by name; all others are written out in `web/src/view`.
 * @returns {import('vite').Plugin}
 */
export function leanThree() {
  const lines = readFileSync(moduleOf('three/addons/lines/LineMaterial.js'), 'utf8');
  return {
    name: 'lean-three',
    enforce: 'pre',
    transform: {
      filter: { id: /three\/build\/three\.module\.js$/ },
      handler(code) {
        // `meshbasic_vert: vertex$c`
        const chunks = /const ShaderChunk = \{([^}]*)\}/.exec(code)?.[1] ?? '';
        const variables = new Map(
          [...chunks.matchAll(/(\w+): ([\w$]+)/g)].map(([, name, variable]) => [name, variable]),
        );
        const texts = new Map(
          [...code.matchAll(piece)].map(([, , variable, text]) => [variable, text]),
        );
        const used = new Set();
        // The beginning of every program is named in the code: `ShaderChunk[ 'colorspace_pars_fragment' ]`.
        const always = [...code.matchAll(/ShaderChunk\[ '(\w+)' \]/g)].map(
          ([, name]) => name ?? '',
        );
        const wanted = ['meshbasic_vert', 'meshbasic_frag', ...includesOf(lines), ...always];
        for (let name = wanted.pop(); name !== undefined; name = wanted.pop()) {
          const variable = variables.get(name);
          if (variable === undefined || used.has(variable)) continue;
          used.add(variable);
          wanted.push(...includesOf(texts.get(variable) ?? ''));
        }
        const shaders = new Set(variables.values());
        if (used.size < 20 || shaders.size < 100 || !table.test(code)) {
          this.error('three.js has its shaders elsewhere now: see web/scripts/lean-three.mjs');
        }
        const lean = code
          .replace(piece, (all, begin, variable) =>
            shaders.has(variable) && !used.has(variable) ? `${begin}"";` : all,
          )
          .replace(table, 'const DATA = new Uint16Array( 0 );');
        return { code: lean, map: null };
      },
    },
  };
}
