// The manifest of `<girth-viewer>` for editors and catalogues: its attributes, properties, methods, events, slots, parts
// and custom properties, read from the element's own sources, in the two forms that are in use.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';
import { Complaint, repository } from './run.mjs';

const sources = 'web/src/element';
const tag = 'girth-viewer';

/** @param {string} name */
const textOf = (name) => readFileSync(join(repository, sources, name), 'utf8');

/** @param {string} name */
const parsed = (name) =>
  ts.createSourceFile(name, textOf(name), ts.ScriptTarget.Latest, true, ts.ScriptKind.TS);

/** @param {string} text */
const oneLine = (text) => text.replace(/\s+/g, ' ').trim();

/** @param {ts.Node} node */
function commentOf(node) {
  const comments = ts.getJSDocCommentsAndTags(node).filter(ts.isJSDoc);
  return oneLine(ts.getTextOfJSDocComment(comments.at(-1)?.comment) ?? '');
}

/**
 * @param {string} file
 * @param {string} name
 */
function classIn(file, name) {
  const found = parsed(file).statements.find(
    (statement) => ts.isClassDeclaration(statement) && statement.name?.text === name,
  );
  if (!found || !ts.isClassDeclaration(found)) throw new Complaint(`${file}: no class ${name}`);
  return found;
}

/** The attributes with their manual: the comments of their rules. */
export function attributes() {
  const rules = parsed('attributes/attributes.ts')
    .statements.filter(ts.isVariableStatement)
    .flatMap(({ declarationList }) => [...declarationList.declarations])
    .find(({ name }) => name.getText() === 'rules')?.initializer;
  if (!rules || !ts.isObjectLiteralExpression(rules))
    throw new Complaint('attributes.ts: no rules');
  return rules.properties.map((rule) => {
    const name = rule.name && ts.isStringLiteral(rule.name) ? rule.name.text : rule.name?.getText();
    const description = commentOf(rule);
    if (!name || !description) throw new Complaint(`attributes.ts: ${name} has no comment`);
    return { name, description, type: { text: 'string' } };
  });
}

/** @param {ts.ClassElement} member */
function isPublic(member) {
  const flags = ts.getCombinedModifierFlags(member);
  const hidden = ts.ModifierFlags.Private | ts.ModifierFlags.Protected | ts.ModifierFlags.Static;
  return !(flags & hidden) && member.name !== undefined && ts.isIdentifier(member.name);
}

/** Members that browsers call, or that every element has. */
const notForPages = /Callback$|^(add|remove)EventListener$/;

/** @param {ts.ClassDeclaration} declaration */
function membersOf(declaration) {
  /** @type {Map<string, Record<string, unknown>>} */
  const members = new Map();
  for (const member of declaration.members.filter(isPublic)) {
    const name = member.name?.getText() ?? '';
    if (notForPages.test(name)) continue;
    const description = commentOf(member);
    if (ts.isMethodDeclaration(member)) {
      const returned = { type: { text: member.type?.getText() ?? 'void' } };
      const parameters = member.parameters.map((one) => ({
        name: one.name.getText(),
        ...(one.type && { type: { text: oneLine(one.type.getText()) } }),
        ...((one.questionToken || one.initializer) && { optional: true }),
      }));
      members.set(name, { kind: 'method', name, description, parameters, return: returned });
    } else if (ts.isGetAccessor(member)) {
      const type = { text: oneLine(member.type?.getText() ?? 'unknown') };
      members.set(name, { kind: 'field', name, description, type, readonly: true });
    } else if (ts.isSetAccessor(member)) {
      const read = { ...(members.get(name) ?? { kind: 'field', name, description }) };
      delete read['readonly'];
      members.set(name, read);
    }
  }
  return [...members.values()];
}

/** The events, of an interface with one member for each. */
function events() {
  const found = parsed('events.ts').statements.find(
    (statement) =>
      ts.isInterfaceDeclaration(statement) && statement.name.text === 'GirthViewerEvents',
  );
  if (!found || !ts.isInterfaceDeclaration(found)) throw new Complaint('events.ts: no events');
  return found.members.filter(ts.isPropertySignature).map((member) => ({
    name: member.name.getText(),
    description: commentOf(member),
    type: { text: member.type?.getText() ?? 'CustomEvent' },
  }));
}

/** Custom elements manifest, schema 1.0.0. */
export function elementManifest() {
  const classes = [
    classIn('viewer-shell.ts', 'ViewerShell'),
    classIn('mesh-calls.ts', 'MeshCalls'),
    classIn('viewer-element.ts', 'GirthViewer'),
  ];
  const style = textOf('controls/shell-style.ts');
  const properties = new Set(
    [...style.matchAll(/^\s*(--girth-[a-z-]+):/gm)].map(([, name]) => name),
  );
  const read = textOf('viewer-core.ts').matchAll(/'(--girth-[a-z-]+)'/g);
  for (const [, name] of read) properties.add(name);
  const inShell = textOf('viewer-shell.ts');
  const slots = [...inShell.matchAll(/make\('slot', \{ name: '([a-z]+)' \}/g)].map(
    ([, name]) => name,
  );
  const parts = [...inShell.matchAll(/part: '([a-z]+)'/g)].map(([, name]) => name);
  const named = (/** @type {Iterable<string | undefined>} */ names) =>
    [...names].map((name) => ({ name: name ?? '' }));
  return {
    schemaVersion: '1.0.0',
    readme: 'README.md',
    modules: [
      {
        kind: 'javascript-module',
        path: 'dist/element.js',
        declarations: [
          {
            kind: 'class',
            customElement: true,
            name: 'GirthViewer',
            tagName: tag,
            description: 'A surface, its girth as colours, and the loop under the pointer.',
            attributes: attributes(),
            members: classes.flatMap(membersOf),
            events: events(),
            slots: named(slots),
            cssParts: named(parts),
            cssProperties: named(properties),
          },
        ],
        exports: [
          {
            kind: 'custom-element-definition',
            name: tag,
            declaration: { name: 'GirthViewer', module: 'dist/element.js' },
          },
        ],
      },
    ],
  };
}

/**
 * The manifest for the editors of JetBrains.
 * @param {ReturnType<typeof elementManifest>} manifest
 */
export function webTypes(manifest) {
  const { name, version } = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8'));
  const [declaration] = manifest.modules[0]?.declarations ?? [];
  if (!declaration) throw new Complaint('the manifest has no element');
  const { description, attributes, events, slots, cssParts, cssProperties } = declaration;
  return {
    $schema: 'https://raw.githubusercontent.com/JetBrains/web-types/master/schema/web-types.json',
    name,
    version,
    'description-markup': 'markdown',
    contributions: {
      html: {
        elements: [
          {
            name: tag,
            description,
            attributes: attributes.map(({ name, description }) => ({ name, description })),
            slots,
            js: { events: events.map(({ name, description }) => ({ name, description })) },
            css: { properties: cssProperties, parts: cssParts },
          },
        ],
      },
    },
  };
}
