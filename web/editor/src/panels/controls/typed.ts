// Letters that are typed one soon after the other, as one word.

/** Milliseconds. */
const PAUSE = 600;
let word = "";
let last = -Infinity;

/** The word so far with this key, or null where the key is no letter or figure. */
export function typedWord(event: KeyboardEvent): string | null {
  const isLetter = event.key.length === 1 && /\p{L}|\p{N}/u.test(event.key);
  if (!isLetter || event.ctrlKey || event.metaKey || event.altKey) return null;
  word =
    event.timeStamp - last < PAUSE
      ? word + event.key.toLocaleLowerCase()
      : event.key.toLocaleLowerCase();
  last = event.timeStamp;
  return word;
}

/** Which of some names begins with a word, going round from the present one; -1: none. */
export function nextBeginning(names: readonly string[], from: number, wanted: string): number {
  // One letter goes on to the next; more of them stay where they fit.
  const start = wanted.length > 1 ? Math.max(from, 0) : from + 1;
  for (let step = 0; step < names.length; step += 1) {
    const index = (start + step) % names.length;
    if (names[index].toLocaleLowerCase().startsWith(wanted)) return index;
  }
  return -1;
}
