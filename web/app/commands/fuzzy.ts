// How well words answer a search in which letters may be left out: 'mgm' finds 'magma'.

/**
 * The worth of a letter: at the beginning of a word, right behind the one before, and elsewhere.
 */
const atBeginning = 8;
const inRow = 6;
const elsewhere = 1;
/** The cost of each letter that is passed over; no gap costs more than `longestGap` letters. */
const perGap = 0.3;
const longestGap = 10;

/** The text without capitals and accents. */
function plain(text: string): string {
  return text.normalize('NFD').replace(/\p{M}/gu, '').toLowerCase();
}

/** The score of a searched word from a place on; undefined where its letters are not in order. */
function scoreFrom(word: string, text: string, start: number): number | undefined {
  let score = 0;
  let last = start - 1;
  for (const letter of word) {
    const place = text.indexOf(letter, last + 1);
    if (place < 0) return undefined;
    const gap = place - last - 1;
    const begins = place === 0 || !/[\p{L}\p{N}]/u.test(text[place - 1]!);
    if (begins) score += atBeginning;
    else score += gap === 0 && place > start ? inRow : elsewhere;
    score -= perGap * Math.min(gap, longestGap);
    last = place;
  }
  return score;
}

/**
 * How well a text answers a search: every searched word must be in it, letter by letter in their order. The more
 * the better; undefined where it does not answer; 0 for a search without letters.
 */
export function fuzzyScore(search: string, text: string): number | undefined {
  const searched = plain(text);
  let sum = 0;
  for (const word of plain(search).split(/\s+/).filter(Boolean)) {
    let best: number | undefined;
    for (let at = searched.indexOf(word[0]!); at >= 0; at = searched.indexOf(word[0]!, at + 1)) {
      const score = scoreFrom(word, searched, at);
      if (score === undefined) break;
      best = Math.max(best ?? -Infinity, score);
    }
    if (best === undefined) return undefined;
    sum += best;
  }
  return sum;
}
