// Rules of this repository, for the linter (.oxlintrc.json).

/**
 * @typedef {object} Node of the syntax tree of ESTree, as far as the rules look at it
 * @property {string} type
 * @property {string} [accessibility] of a member
 * @property {Node} [left] of an assignment
 * @property {Node} [property] of an access to a member
 * @property {string} [name] of an identifier
 *
 * @typedef {object} Context
 * @property {(found: { node: Node, message: string }) => void} report
 */

/** Private members are those of the language. */
const privateMembers = {
  /** @param {Context} context */
  create(context) {
    /** @param {Node} node */
    const member = (node) => {
      if (node.accessibility === 'private') context.report({ node, message: 'Write #name.' });
    };
    return {
      PropertyDefinition: member,
      MethodDefinition: member,
      /** @param {Node} node */
      TSParameterProperty: (node) =>
        context.report({ node, message: 'Declare the field and assign it.' }),
    };
  },
};

/** The value that a control shows is written in one place. */
const shownText = {
  /** @param {Context} context */
  create: (context) => ({
    /** @param {Node} node */
    AssignmentExpression(node) {
      if (node.left?.property?.name !== 'value') return;
      const message =
        'Only draft.ts writes what a control shows: it knows whether that is being edited.';
      context.report({ node, message });
    },
  }),
};

export default {
  meta: { name: 'girth' },
  rules: { 'private-members': privateMembers, 'shown-text': shownText },
};
