// The documentation as a site, by Eleventy: every document of pages.mjs becomes a page, and their words an index that is
// searched in the reader's browser. `npm run build:docs` runs it from the top of the repository.

import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { repository } from '../../scripts/run.mjs';
import { commandPage } from './command-reference.mjs';
import { errorsPage } from './errors.mjs';
import { figures } from './figures.mjs';
import { amendMarkdown, sourceAddress } from './markdown.mjs';
import { makeModels } from './models.mjs';
import { pages, sections } from './pages.mjs';
import { pythonPage } from './python-reference.mjs';
import { joinReferences } from './references.mjs';
import { searchIndex } from './search-index.mjs';

const site = 'web/docs/site';
const output = 'build/page/docs';

/** Pages that are made, by the names that pages.mjs has for them. @type {Record<string, () => string>} */
const made = {
  errors: errorsPage,
  'command-reference': commandPage,
  'python-reference': pythonPage,
};

/** From a page to the top of the site. */
const rootOf = (/** @type {string} */ url) => '../'.repeat(url.split('/').length - 1) || './';

/**
 * A document without marks: the first heading's words.
 * @param {string} text
 */
function titleOf(text) {
  const [, heading = ''] = /^# (.*)$/m.exec(text) ?? [];
  return heading.replace(/[`*]/g, '');
}

/** @param {any} config Eleventy's */
export default function (config) {
  /** @type {Set<string>} */
  const sources = new Set();
  config.addGlobalData('layout', 'page.njk');
  config.amendLibrary('md', amendMarkdown);

  const documents = pages.map((page) => {
    const { file, url } = page;
    const text = made[file]?.() ?? readFileSync(join(repository, file), 'utf8');
    const title = titleOf(text);
    return { text, title, file, url, label: page.label ?? title };
  });
  documents.forEach(({ text, title, file, url, label }, i) => {
    const root = rootOf(url);
    config.addTemplate(`${url.replace(/html$/, 'md')}`, text, {
      ...{ title, root, address: url, permalink: url, templateEngineOverride: 'md' },
      place: { file, root, sources },
      // The list of pages, with the section and the page that this is.
      sections: sections.map((section) => ({
        title: section.title,
        pages: [
          ...section.pages.map((page) => {
            const { label } = documents.find((document) => document.url === page.url) ?? {};
            return { label, url: root + page.url, current: page.url === url };
          }),
          ...(section.others ?? []).map((other) => ({ ...other, url: root + other.url })),
        ],
      })),
      label,
      before: documents[i - 1] && { ...documents[i - 1], url: root + documents[i - 1]?.url },
      after: documents[i + 1] && { ...documents[i + 1], url: root + documents[i + 1]?.url },
    });
  });

  /** Headings of the second rank, for the list of what is on a page. */
  config.addFilter('parts', (/** @type {string} */ html) =>
    [...html.matchAll(/<h2 id="([^"]*)"[^>]*>(.*?)<\/h2>/gs)].map(([, anchor, heading = '']) => ({
      anchor,
      heading: heading.replace(/<[^>]*>/g, ''),
    })),
  );

  config.on(
    'eleventy.after',
    async (/** @type {{ results: { url: string, content: string }[] }} */ { results }) => {
      const built = results.map(({ url, content }) => ({ url: url.replace(/^\//, ''), content }));
      /** @type {(from: string, to: string) => void} */
      const copy = (from, to) => {
        mkdirSync(dirname(join(repository, output, to)), { recursive: true });
        cpSync(join(repository, from), join(repository, output, to), { recursive: true });
      };
      for (const file of sources) copy(file, sourceAddress(file));
      copy(`${site}/client`, 'site');
      copy('node_modules/minisearch/dist/es/index.js', 'site/minisearch.js');
      copy('web/app/icon.svg', 'site/icon.svg');
      copy('web/docs/images', 'images');
      copy('build/reference', 'reference');
      const models = new Set(Object.values(figures).map(({ model }) => model));
      mkdirSync(join(repository, output, 'models'), { recursive: true });
      const generated = await makeModels();
      for (const model of models) {
        const to = `models/${model}.glb`;
        if (model in generated) writeFileSync(join(repository, output, to), generated[model] ?? '');
        else copy(`web/app/public/examples/${model}.glb`, to);
      }
      for (const part of ['girth-viewer.js', 'girth-kernel.js', 'assets', 'kernel/wasm']) {
        copy(posix.join('dist', part), posix.join('girth/dist', part));
      }
      const references = joinReferences(join(repository, output, 'reference'));
      writeFileSync(join(repository, output, 'site/search.json'), searchIndex(built, references));
    },
  );

  return {
    dir: { input: `${site}/layout`, includes: '.', output },
    markdownTemplateEngine: false,
    // Layouts are no pages.
    templateFormats: ['md'],
  };
}
