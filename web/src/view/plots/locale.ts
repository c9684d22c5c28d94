// A language that formatters take. Under LANG=C some browsers name the user's language 'C', which is none:
// `new Intl.NumberFormat('C')` throws, and uPlot does that while it is loaded. Imported before uPlot, this
// module lets such a browser name English instead.

if (typeof navigator !== 'undefined') {
  try {
    new Intl.NumberFormat(navigator.language);
  } catch {
    Object.defineProperty(navigator, 'language', { value: 'en-US', configurable: true });
  }
}
