// One linter for the whole repository. The layers' arrows are checked here as well as by the
// separate tsconfigs: kernel ◄─ view ◄─ element ◄─ app, and kernel ◄─ node.

import eslint from '@eslint/js';
import { defineConfig } from 'eslint/config';
import tseslint from 'typescript-eslint';

const layers = ['kernel', 'node', 'view', 'element', 'app', 'examples', 'tests', 'scripts'];

/** The modules that a layer must not import, with the reason. */
function forbid(files, ...patterns) {
  return {
    files,
    rules: { '@typescript-eslint/no-restricted-imports': ['error', { patterns }] },
  };
}

const three = { regex: '^three', message: 'Only the view knows three.js.' };

/** Private members are those of the language: `#name`. */
const privateMembers = [
  {
    selector: ':matches(PropertyDefinition, MethodDefinition)[accessibility="private"]',
    message: 'Write #name.',
  },
  { selector: 'TSParameterProperty', message: 'Declare the field and assign it.' },
];

const shownText = {
  selector: 'AssignmentExpression[left.property.name="value"]',
  message: 'Only draft.ts writes what a control shows: it knows whether that is being edited.',
};

export default defineConfig(
  { ignores: ['build*/', 'dist/', 'web/src/kernel/wasm/', 'web/app/public/', 'web/examples/'] },
  eslint.configs.recommended,
  {
    files: ['**/*.ts'],
    extends: [tseslint.configs.recommendedTypeChecked],
    languageOptions: {
      parserOptions: {
        project: layers.map((layer) => `./tsconfig.${layer}.json`),
        tsconfigRootDir: import.meta.dirname,
      },
    },
    rules: {
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_' }],
      '@typescript-eslint/consistent-type-imports': 'error',
    },
  },
  {
    files: ['**/*.mjs', '**/*.js'],
    languageOptions: {
      globals: {
        console: 'readonly',
        performance: 'readonly',
        process: 'readonly',
        URL: 'readonly',
      },
    },
  },
  {
    files: ['web/docs/site/client/*.js'],
    languageOptions: {
      globals: {
        addEventListener: 'readonly',
        caches: 'readonly',
        document: 'readonly',
        fetch: 'readonly',
        IntersectionObserver: 'readonly',
        navigator: 'readonly',
      },
    },
  },
  { plugins: { '@typescript-eslint': tseslint.plugin } },
  forbid(['web/src/kernel/**'], three, {
    regex: '^node:|/(node|view|element|app)/',
    message: 'The kernel knows neither Node.js, view, element nor page.',
  }),
  forbid(['web/src/node/**'], three, {
    regex: '/(view|element|app)/',
    message: 'The kernel in Node.js knows neither view, element nor page.',
  }),
  forbid(
    ['web/src/view/**'],
    {
      regex: '/kernel/(?!types\\.js$)',
      message: 'The view knows only the types of the kernel.',
    },
    { regex: '/kernel/', allowTypeImports: true, message: 'The view knows only the types.' },
    { regex: '/(element|app)/', message: 'The view knows neither element nor page.' },
  ),
  forbid(['web/src/element/**'], three, {
    regex: '/app/',
    message: 'The element does not know the page.',
  }),
  {
    files: ['web/app/**/*.ts', 'web/src/**/*.ts'],
    rules: { 'no-restricted-syntax': ['error', ...privateMembers] },
  },
  {
    files: ['web/app/*.ts'],
    ignores: ['web/app/draft.ts'],
    rules: { 'no-restricted-syntax': ['error', ...privateMembers, shownText] },
  },
  forbid(['web/app/**'], three, {
    regex: '/src/(?!(kernel/(index|types)|element/(index|plots))\\.(js|ts)$)',
    message: 'The page uses public exports only.',
  }),
);
