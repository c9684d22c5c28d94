export default {
  mode: 'production',
  entry: './main.js',
  output: { filename: 'app.js' },
  // The kernel and three.js are larger than what webpack warns of.
  performance: { hints: false },
  // Of the package: what Vite and Emscripten would ask for elsewhere, and a thread's script, which its threads share.
  ignoreWarnings: [{ module: /girth/ }, /Circular dependency between chunks/],
};
