// Undo and redo of a text. Letters typed one after another are one step.

export interface State {
  text: string;
  /** Selection in the text box, or null if the change came from elsewhere. */
  caret: [number, number] | null;
}

/** Milliseconds between letters that are one step. */
const TOGETHER = 900;
const MOST = 300;

export class History {
  private past: State[] = [];
  private future: State[] = [];
  private last = 0;
  private tag = '';

  constructor(private now: State = { text: '', caret: null }) {}

  get text(): string {
    return this.now.text;
  }
  get can_undo(): boolean {
    return this.past.length > 0;
  }
  get can_redo(): boolean {
    return this.future.length > 0;
  }

  /** Takes a new text. Changes of one tag that follow each other quickly are one step; an empty tag joins none. */
  push(text: string, tag = '', caret: State['caret'] = null, time = Date.now()): void {
    if (text === this.now.text) return;
    const joins = tag !== '' && tag === this.tag && time - this.last < TOGETHER && this.past.length > 0;
    if (!joins) {
      this.past.push(this.now);
      if (this.past.length > MOST) this.past.shift();
    }
    this.now = { text, caret };
    this.future = [];
    this.last = time;
    this.tag = tag;
  }

  undo(): State {
    const before = this.past.pop();
    if (before) {
      this.future.push(this.now);
      this.now = before;
    }
    this.tag = '';
    return this.now;
  }

  redo(): State {
    const after = this.future.pop();
    if (after) {
      this.past.push(this.now);
      this.now = after;
    }
    this.tag = '';
    return this.now;
  }
}
