// Actions for a table: to the clipboard in one click, or a CSV file.

import { make } from '../../src/element/index.js';
import { copyText } from './clipboard.js';
import { Draft } from './draft.js';
import { saveFile } from '../export/save-file.js';
import { type Table, csvOf, tsvOf } from './table-text.js';

export interface TableSource {
  table(): Table;
  /** The name of the CSV file. */
  fileName(): string;
}

/** 'Copy table' and 'CSV'; where the clipboard is denied, the text, selected, to be copied by hand. */
export class TableActions {
  readonly element: HTMLElement;
  readonly #said = make('span', { class: 'hint', role: 'status' });
  readonly #text = make('textarea', { readonly: '', rows: '4', 'aria-label': 'Table to copy' });
  readonly #shown = new Draft(this.#text);
  readonly #source: TableSource;

  constructor(source: TableSource) {
    this.#source = source;
    const copy = make('button', { type: 'button', class: 'plain' }, 'Copy table');
    copy.addEventListener('click', () => void this.#copy());
    const csv = make('button', { type: 'button', class: 'plain' }, 'CSV');
    csv.addEventListener('click', () => saveFile(csvOf(source.table()), source.fileName()));
    this.#text.hidden = true;
    const buttons = make('p', { class: 'buttons' }, copy, csv, this.#said);
    this.element = make('div', { class: 'table-actions' }, buttons, this.#text);
  }

  /** Forgets the message about an older table. */
  forget(): void {
    this.#said.textContent = '';
    this.#text.hidden = true;
  }

  async #copy(): Promise<void> {
    this.forget();
    const table = this.#source.table();
    const text = tsvOf(table);
    if (await copyText(text)) {
      const rows = table.length - 1;
      this.#said.textContent = `Copied: ${rows === 1 ? 'one row' : `${rows} rows`}.`;
    } else {
      this.#shown.show(text);
      this.#text.hidden = false;
      this.#text.focus();
      this.#text.select();
      this.#said.textContent = 'This browser does not let pages copy: copy the text below.';
    }
  }
}
