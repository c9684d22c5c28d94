// Failures in one or two sentences for a line of a panel.

/** The message, and the remedy where the failure has one; without a full stop at the end. */
export function failureWords(error: unknown): string {
  if (!(error instanceof Error)) return String(error);
  const hint = 'hint' in error && typeof error.hint === 'string' ? error.hint : '';
  return hint === '' ? error.message : `${error.message}; what helps: ${hint}`;
}
