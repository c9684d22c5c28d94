// The package's types: of each entry one file with what the entry exports and what that refers to, and nothing
// else. Protected members stay inside, and with them the types of other packages that only they use.

import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import ts from 'typescript';
import { frameworkTypes } from './framework-types.mjs';
import { Complaint } from './run.mjs';

/**
 * @typedef {object} Entry
 * @property {string} from a declaration file that tsc has written
 * @property {string} to the file that is made of it
 * @property {{ folder: string, module: string }} [imported] what the entry takes from another entry: the folder of
 *   its declarations, and how it is imported
 */

/**
 * Writes the declarations of all entries.
 * @param {Entry[]} entries
 */
export function bundleTypes(entries) {
  const program = ts.createProgram({
    rootNames: entries.map(({ from }) => resolve(from)),
    // Only names have to be resolved, and only within the package.
    options: { noLib: true, types: [], module: ts.ModuleKind.NodeNext },
  });
  for (const entry of entries) {
    mkdirSync(dirname(entry.to), { recursive: true });
    writeFileSync(entry.to, bundled(program, entry));
  }
}

/**
 * @param {ts.Program} program
 * @param {Entry} entry
 */
function bundled(program, { from, imported }) {
  const checker = program.getTypeChecker();
  const file = program.getSourceFile(resolve(from));
  const module = file && checker.getSymbolAtLocation(file);
  if (!file || !module) throw new Complaint(`${from} exports no types`);

  /** @type {Map<string, ts.Statement>} what is written, by name */
  const chosen = new Map();
  /** @type {Set<string>} names that come from the other entry */
  const taken = new Set();

  /** @type {string[]} what leads to the declaration that is looked at */
  const trail = [];

  /** @param {ts.Symbol} symbol */
  const need = (symbol) => {
    for (const declaration of symbol.declarations ?? []) {
      const statement = statementOf(declaration);
      if (!statement || ts.isModuleDeclaration(statement)) continue;
      if (statement.getSourceFile().fileName.includes('/node_modules/')) {
        const way = [...trail, symbol.name].join(' → ');
        throw new Complaint(`a type of another package is public: ${way}`);
      }
      if (imported && isWithin(statement.getSourceFile().fileName, imported.folder)) {
        taken.add(symbol.name);
        continue;
      }
      const before = chosen.get(symbol.name);
      if (before === statement) continue;
      if (before) throw new Complaint(`two public types have the name ${symbol.name}`);
      chosen.set(symbol.name, statement);
      trail.push(symbol.name);
      visit(statement);
      trail.pop();
    }
  };

  /** @param {ts.Node} node */
  const visit = (node) => {
    if (isHidden(node)) return;
    if (ts.isImportTypeNode(node)) throw new Complaint(`${node.getText()}: import it by name`);
    if (ts.isIdentifier(node)) {
      const symbol = checker.getSymbolAtLocation(node);
      if (symbol) need(original(symbol, node.text));
    }
    ts.forEachChild(node, visit);
  };

  /**
   * The symbol that an imported or exported name stands for.
   * @param {ts.Symbol} symbol
   * @param {string} name
   */
  const original = (symbol, name) => {
    if (!(symbol.flags & ts.SymbolFlags.Alias)) return symbol;
    const found = checker.getAliasedSymbol(symbol);
    if (!found.declarations) throw new Complaint(`${from}: nothing is known of ${name}`);
    if (found.name !== name) throw new Complaint(`${from}: ${name} has another name inside`);
    return found;
  };

  const names = new Set();
  for (const symbol of checker.getExportsOfModule(module)) {
    names.add(symbol.name);
    need(original(symbol, symbol.name));
  }
  const globals = file.statements.filter(ts.isModuleDeclaration);
  globals.forEach(visit);

  const [documentation] = /^\/\*\*[^]*?\*\//.exec(file.text) ?? [''];
  const imports =
    imported && taken.size > 0
      ? [`import type { ${[...taken].sort().join(', ')} } from '${imported.module}';`]
      : [];
  const declarations = [...chosen].map(([name, statement]) => written(statement, names.has(name)));
  const augmentations = globals.map((statement) => statement.getText());
  // Projects whose libraries are of an older year do not know the symbol.
  const isDisposable = declarations.some((text) => text.includes('[Symbol.dispose]'));
  const libraries = isDisposable ? ['/// <reference lib="esnext.disposable" />'] : [];
  // Without the last line, all declarations would be exported.
  const parts = [
    ...libraries,
    documentation,
    ...imports,
    ...declarations,
    ...augmentations,
    'export {};',
  ];
  return `${parts.filter(Boolean).join('\n')}\n`;
}

/**
 * The statement of a file that declares something; undefined for members and parameters.
 * @param {ts.Declaration} declaration
 * @returns {ts.Statement | undefined}
 */
function statementOf(declaration) {
  const node = ts.isVariableDeclaration(declaration) ? declaration.parent.parent : declaration;
  return ts.isSourceFile(node.parent) ? /** @type {ts.Statement} */ (node) : undefined;
}

/** @param {ts.Node} node */
const isHidden = (node) =>
  ts.isClassElement(node) &&
  ts.canHaveModifiers(node) &&
  ts.getModifiers(node)?.some(({ kind }) => kind === ts.SyntaxKind.ProtectedKeyword);

/**
 * A statement with its documentation, without what is hidden in it.
 * @param {ts.Statement} statement
 * @param {boolean} isExported
 */
function written(statement, isExported) {
  const { text } = statement.getSourceFile();
  const comments = ts.getLeadingCommentRanges(text, statement.getFullStart()) ?? [];
  const last = comments.map(({ pos, end }) => text.slice(pos, end)).at(-1);
  const documentation = last?.startsWith('/**') ? `${last}\n` : '';
  let code = '';
  let at = statement.getStart();
  const hidden = ts.isClassDeclaration(statement) ? statement.members.filter(isHidden) : [];
  for (const member of hidden) {
    code += text.slice(at, member.getFullStart());
    at = member.end;
  }
  code += text.slice(at, statement.end);
  const bare = code.replace(/^export /, '').replace(/^declare /, '');
  const isType = ts.isInterfaceDeclaration(statement) || ts.isTypeAliasDeclaration(statement);
  return `${documentation}${isExported ? 'export ' : ''}${isType ? '' : 'declare '}${bare}`;
}

/**
 * @param {string} file
 * @param {string} folder
 */
const isWithin = (file, folder) => !relative(resolve(folder), file).startsWith('..');

/**
 * The declarations of the npm package, of what tsc has written below `from`.
 * @param {{ from: string, to: string }} folders
 */
export function bundlePackageTypes({ from, to }) {
  const kernel = { folder: join(from, 'kernel'), module: './kernel/index.js' };
  bundleTypes([
    { from: join(from, 'kernel/index.d.ts'), to: join(to, 'kernel/index.d.ts') },
    { from: join(from, 'element/index.d.ts'), to: join(to, 'element.d.ts'), imported: kernel },
    { from: join(from, 'element/plots.d.ts'), to: join(to, 'plots.d.ts'), imported: kernel },
  ]);
  writeFileSync(join(to, 'girth-kernel.d.ts'), `export * from './kernel/index.js';\n`);
  writeFileSync(join(to, 'girth-viewer.d.ts'), `export * from './element.js';\n`);
  for (const [name, text] of Object.entries(frameworkTypes)) {
    writeFileSync(join(to, `${name}.d.ts`), text);
    // There is nothing but types.
    writeFileSync(join(to, `${name}.js`), 'export {};\n');
  }
}
