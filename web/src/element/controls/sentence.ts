// Messages as sentences: failures state theirs without a capital letter and a full stop.

/** The first letter large, a full stop at the end; '' stays ''. */
export function sentence(text: string): string {
  const trimmed = text.trim();
  if (!trimmed) return '';
  return trimmed[0]!.toUpperCase() + trimmed.slice(1) + (/[.!?]$/.test(trimmed) ? '' : '.');
}
