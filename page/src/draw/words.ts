// Words and sentences as the page and the window write them.

/** Words with a capital letter. */
export function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** A text with capital letter and full stop. */
export function sentence(text: string): string {
  const own = capital(text.trim());
  return !own || /[.!?]$/.test(own) ? own : `${own}.`;
}
