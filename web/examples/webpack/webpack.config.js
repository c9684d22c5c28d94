export default {
  mode: 'production',
  entry: './main.js',
  // The policy by which a page that requires Trusted Types lets webpack fetch what it has made.
  output: { filename: 'app.js', trustedTypes: 'webpack' },
  // The kernel and three.js are larger than what webpack warns of.
  performance: { hints: false },
  // Modules of the package: what Vite and Emscripten would ask for elsewhere, and a thread's script, which its threads share.
  ignoreWarnings: [{ module: /girth/ }, /Circular dependency between chunks/],
};
