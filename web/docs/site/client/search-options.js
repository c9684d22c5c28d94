// Options with which the index of words is made and read.

/** For MiniSearch: a document is a piece of a page, under one heading; `id` is its address. */
export const searchOptions = {
  fields: ['page', 'heading', 'text'],
  storeFields: ['page', 'heading', 'text'],
  searchOptions: {
    prefix: true,
    // One letter in five may be wrong.
    fuzzy: 0.2,
    boost: { heading: 3, page: 2 },
    combineWith: /** @type {const} */ ('AND'),
  },
};
