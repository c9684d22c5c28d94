// Behaviour of a page of the documentation, beyond being read.

import { startFigures } from './figures.js';
import { keepSearch, startSearch } from './search.js';

startSearch();
startFigures();
addEventListener('load', keepSearch);
