// Parts of the page that panels which are fetched later are handed: imported, they would be small files of their own.

import type { ProfilePlot } from '../../src/element/plots.js';
import type { stemOf } from '../export/save-file.js';
import type { axisNumber } from './axis-number.js';
import type { Draft } from './draft.js';
import type { failureWords } from './failure-words.js';
import type { LengthInput } from './length-input.js';
import type { PanelSearch } from './panel-search.js';
import type { PlaceList } from './place-list.js';
import type { TableActions } from './table-actions.js';
import type { columnOf } from './table-text.js';

export interface PanelKit {
  Draft: typeof Draft;
  LengthInput: typeof LengthInput;
  PanelSearch: typeof PanelSearch;
  PlaceList: typeof PlaceList;
  ProfilePlot: typeof ProfilePlot;
  TableActions: typeof TableActions;
  axisNumber: typeof axisNumber;
  columnOf: typeof columnOf;
  failureWords: typeof failureWords;
  stemOf: typeof stemOf;
}
