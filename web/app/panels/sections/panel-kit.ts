// Parts of the page that the panel of sections is handed: if it imported them, they would be small files of their own.

import type { stemOf } from '../../export/save-file.js';
import type { Draft } from '../../widgets/draft.js';
import type { failureWords } from '../../widgets/failure-words.js';
import type { LengthInput } from '../../widgets/length-input.js';
import type { TableActions } from '../../widgets/table-actions.js';
import type { columnOf } from '../../widgets/table-text.js';

export interface PanelKit {
  Draft: typeof Draft;
  LengthInput: typeof LengthInput;
  TableActions: typeof TableActions;
  columnOf: typeof columnOf;
  failureWords: typeof failureWords;
  stemOf: typeof stemOf;
}
