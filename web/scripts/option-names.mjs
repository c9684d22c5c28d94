// The names of options that calls of the kernel take, from the types of their parameters.

import { join, relative } from 'node:path';
import ts from 'typescript';
import { repository } from './run.mjs';

/** Types of parameters whose members are options. */
const ofOptions = /\b\w*(Options|Limits|PrintFields)\b/;

/** The options of a type, those within others after a dot. @param {ts.TypeChecker} checker @param {ts.Type} type @returns {string[]} */
function namesOf(checker, type) {
  return checker.getPropertiesOfType(type).flatMap((member) => {
    const [declared] = member.declarations ?? [];
    const node = declared && ts.isPropertySignature(declared) ? declared.type : undefined;
    if (!node || !ofOptions.test(node.getText())) return [member.name];
    const inner = namesOf(checker, checker.getTypeFromTypeNode(node));
    return [member.name, ...inner.map((name) => `${member.name}.${name}`)];
  });
}

/** The options of each parameter of a call that takes some, by its place. @param {ts.TypeChecker} checker @param {ts.Signature[]} overloads */
function parametersOf(checker, overloads) {
  /** @type {Record<number, string[]>} */
  const found = {};
  for (const { parameters } of overloads) {
    parameters.forEach(({ valueDeclaration }, at) => {
      const node = valueDeclaration && ts.isParameter(valueDeclaration) && valueDeclaration.type;
      if (!node || !ofOptions.test(node.getText())) return;
      const names = namesOf(checker, checker.getTypeFromTypeNode(node));
      found[at] = [...new Set([...(found[at] ?? []), ...names])];
    });
  }
  return found;
}

/** Interfaces whose calls check their options. */
const interfaces = ['Kernel', 'Mesh', 'RemeshedMesh'];

/**
 * The source of `option-names.ts`.
 * @param {Record<string, string>} made The texts of sources that are about to be written, by their paths.
 */
export function optionNamesText(made) {
  const path = join(repository, 'web/src/kernel/types/types.ts');
  const settings = { target: ts.ScriptTarget.ES2022, types: [] };
  const host = ts.createCompilerHost(settings);
  host.readFile = (file) => made[relative(repository, file)] ?? ts.sys.readFile(file);
  const program = ts.createProgram([path], settings, host);
  const checker = program.getTypeChecker();
  const file = program.getSourceFile(path);
  const declared = (/** @type {string} */ name) => {
    const node = file?.statements.find(
      (statement) => ts.isInterfaceDeclaration(statement) && statement.name.text === name,
    );
    if (!node) throw new Error(`${path} has no interface ${name}`);
    return /** @type {ts.InterfaceDeclaration} */ (node);
  };
  const tables = interfaces.map((name) => {
    // The names of the options of analyses are checked where they are read.
    const own = declared(name).members.filter(ts.isMethodSignature);
    const names = new Set(own.map((method) => method.name.getText()));
    const calls = [...names].flatMap((call) => {
      const overloads = own
        .filter((method) => method.name.getText() === call)
        .flatMap((method) => checker.getSignatureFromDeclaration(method) ?? []);
      const taken = parametersOf(checker, overloads);
      return Object.keys(taken).length > 0 ? [`${call}: ${JSON.stringify(taken)}`] : [];
    });
    return `${name}: { ${calls.join(', ')} }`;
  });
  const kernelOptions = namesOf(checker, checker.getTypeAtLocation(declared('KernelOptions')));
  return `// Made of types.ts by \`npm run build:tables\`: not to be edited.

/** The names of the options of each parameter that has some, by the call and the parameter's place. */
export type CallOptionNames = Readonly<Record<string, Readonly<Record<number, readonly string[]>>>>;

/** Options of \`createKernel\`. */
export const kernelOptionNames: readonly string[] = ${JSON.stringify(kernelOptions)};

/** Options of the calls of each interface. */
export const callOptionNames: Readonly<Record<'${interfaces.join("' | '")}', CallOptionNames>> = { ${tables.join(', ')} };
`;
}
