// Behaviour of a page of the documentation, beyond being read.

import { startCopying } from './copy.js';
import { startFigures } from './figures.js';
import { keepSearch, startSearch } from './search.js';

startSearch();
startFigures();
startCopying();
addEventListener('load', keepSearch);
