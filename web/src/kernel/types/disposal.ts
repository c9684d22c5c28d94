// The name of the method by which `using` disposes of something. Older browsers have no such symbol; code that is compiled
// for them brings one.

export const disposal: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');
