// Colour maps of d3-scale-chromatic, whose licence holds for them: made by web/scripts/colormap-tables.mjs.

import type { ColormapName } from './colormap-names.js';

/** The first value of a channel, and a sign for each step to the next: m for none, n for one more, l for one less. */
type Channel = readonly [first: number, steps: string];

/** Red, green and blue of 256 colours, lowest value first. */
export const colormapChannels: Record<ColormapName, readonly [Channel, Channel, Channel]> = {
  viridis: [
    [
      68,
      'mnmnmmmnmmmmnmmmmmmmmmmmmmmmmlmmmmlmmmlmmlmmlmlmmlmlmlmlmmlmlmlmlmlmlmlmlmlmlmlmlmlmmlmlmlmmlmlmmlmlmmlmmlmlmmlmmlmmlmlmmlmmlmmmlmmlmmmmmmlmmnmmmmmnmnmnmnnnmnnnnnonnnononononoonoooooooooooooooopooopoopoopopopopopopoppopoppoppoppoppoppoppoppopoppopopopoopo',
    ],
    [
      1,
      'nonononononononnonnnonnonnnonnonnnnonnnonnnnonnnnnonnnnnnonnnnnnnnnnonnnnnnnnnnnnnnnnnnnnnnnnnmnnnnnnnnnnnnnnnnnmnnnnnnnnnnnnnnnnmnnnnnnnnnnnnnnnmnnnnnnnnnnnnmnnnnnnnnnmnnnnnnmnnnnnmnnnnmnnnmnnnmnnmnnnmnmnnmnnmnmnmnmnmnmnmnmnmnmmnmmnmnmmnmmnmmnmmnmmmnmmnm',
    ],
    [
      84,
      'onononnononnonnnonnnnnonnnnnnnmnnnnmnnnmnnmnmnmnmnmnmmnmmnmmmnmmmnmmmmmnmmmmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmmlmmmmlmmmlmmlmmlmmlmlmlmmllmlmlmllmlllmlllmllllllllllllllllllklllkllkllkllklklklkklklkklkklkklkkklkkklklkkllkllllmlmmnmnnnnnonoo',
    ],
  ],
  cividis: [
    [
      0,
      'mmmmmmmmmmmmmmmnnnnnmnnnnonnnnnonnnonnnonnononnonnononnonnononnonnonnnonnonnnnonnnnonnnnnnnnonnnnnnnnnnnnnmnnnnnnnnnmnnnnnmnnnnnmnnnnnmnnnnmnnnnnmnnnnnmnnnnnnnnmnnnnnnnnnnnnnnnnnnnnnonnnnnnonnnnnonnnnonnnonnnonnnonnnonnnonnnnonnnnnnnnonmnnnnnnnmnnmnmnmnmm',
    ],
    [
      32,
      'nnnmnnmnnmnnmnnmnnmnnnmnnmnnmnnnmnnmnnmnnnmnnmnnnmnnmnnnmnnmnnnmnnmnnnmnnmnnnmnnmnnnmnnmnnnmnnnmnnmnnnmnnnmnnnmnnmnnnmnnnmnnnmnnnmnnnmnnnnmnnnmnnnmnnnnmnnnnmnnnnmnnnnmnnnnmnnnnnmnnnnnmnnnnnnmnnnnnnnmnnnnnnnmnnnnnnnnnnmnnnnnnnnnnnnnnmnnnnnnnnnnnnnnnnnnnnnn',
    ],
    [
      81,
      'oononnonnnnnnnnnmnnmnnmnmmnmmnmmnmmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmmmmnmmmmmmmmmmmmmmmnmmmmmmnmmmmmnmmmmmnmmmmnmmmnmmmmnmmmmnmmmmmnmmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmlmmmlmmlmmlmlmmlmlmlmllmlmllmllmllmlllmlllmllllmllllmlllllmlllmlllmllmllmlmllmml',
    ],
  ],
  plasma: [
    [
      13,
      'ppppoopooooooonoooonooonoonoononoonoonononoononononoonononononononononnononnononnonnonnonnnonnnonnnnonnnnnnnnonnnnnnnnnnnnnnnnnnmnnnnnnnnnmnnnnnmnnnnmnnnnmnnnmnnmnnmnnmnnmnnmnmnmnnmnmnmnmnmmnmnmmnmmnmmnmmmmnmmmmmmmnmmmmmmlmmmmmmlmmmlmmlmlmlmlmlmlmllmllmlm',
    ],
    [
      8,
      'lmmlmmmmmlmmmmmmmlmmmmmmmlmmmmmlmmmmmlmmmmmmlmmmmmmmmmmnmmmmnmnmnmnmnnnnnnnnnnnnonnnnnnnnonnnnnnnonnnnnnonnnnnnnonnnnnnnonnnnnnnonnnnnnonnnnnnnonnnnnonnnnnonnnnonnnnonnnonnnonnnonnonnonnonnonnononnononnonononononononononoononoononoonoonoonoonooonoonooonoo',
    ],
    [
      135,
      'nnnonnnnnmnnnnnnmnnnmnnmnnmnmnnmnmnmnmmnmnmmnmmmnmmmmmmmmmmmmmmmmlmmlmmlmmlmlmllmllmllmlllmllllllmllllllllllllmllllllllllllllmlllllllllmlllllllmlllllllmllllllmllllllmllllllmllllllmlllllllmllllllmllllllmlllllmllllmlllmllmlmllmmlmlmmmlmmmmmnmmmmnmmnmmmmlllj',
    ],
  ],
  magma: [
    [
      0,
      'nmmnmmnmnnnmnnnnnnnnonnnnnnonnonnonnonoononooonoonooonoonoonoononoononononoononononoononononoononoononoononoononoonoonoononoonoonoononoononoonononononononnonnnonnnnnnnnnnnmnnmnnmnmnmnmmnmmnmmnmmmmnmmmmmnmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmlmmmmmmmmmlmmmmmmmmm',
    ],
    [
      0,
      'mnmmnmnmnmnmnnmnnmnnmnnmnmnmnmmnmmmmnmmlmmmmmlmmmlmmmmmmnmmmnmnmnmnnmnmnnmnnmnnmnmnnmnnmnmnmnnmnmnmnnmnmnmnmnmnmnmnmnmnnmnmnmnmnmnnmnmnnmnnmnnmnnnnnmnnnnnonnnnonnonnonoonoonooonoooooonoooooooonoooooooonooooooonoooooonooooonooooonooooonooooonoooonooooonooo',
    ],
    [
      4,
      'nnonooopoooooooooopoooopoopoopopoopopopoopoooooonoonnonnnnmnnnmnmnmnmmnmmnmmmmnmmmmmmmmmmnmmmmlmmmmmmmmmmlmmmmlmmmlmmlmmlmlmmlmlmlmlmllmllmllmllmlllmllllmllllmllmllmllmmlmlmmmmmmmmmmnmmnmnmnnmnnnnnnnnnnnnnnonnnonnonnononononoononoonoonooonoooonooooooonooo',
    ],
  ],
  turbo: [
    [
      35,
      'qqqpqpopooonnonmnmnmmmmlmlmlllllmkllllllklllllklllllllllmllmlmlmmlmmmmmmnmmnmnnmnnnnnonnonoonoooooooopoopoppoppoppppppppppppppppppppqpppppppppoppppoppopoopooopoonooonononnmmmmmmmmmmmmmmmmmmmmmmmmmmmklklklkkkkkkkkkkjkjkjkjkjkjjkjjkjkjkjkkjkkkkklkklllllmlmm',
    ],
    [
      23,
      'pooopoopopopoppoppoppoppopppoppppopppopppoppoppoppopopopopopoopoooopooooooooonooonononononnonnnnnnnnmnnnmnmnmnmmmmnmmmmlmmmlmlmlmllmlllllllllkllkllkklklkkkkklkkkjkkkkjkkjkkjkjkjkjjkjkjjjkjjjkjjjkjjjjkjjjkjjkjjkjjkjkjkjkkjkkkjkkklkkkklkllkllllllmllmmmlnmmm',
    ],
    [
      27,
      'zxyxwxvwvuuuutstssrrrrqqqpqpopoooononnmnnmmmmlmlmllllkllklkkklkkkjkkkjkkjkkjkjkjjkjkjkjjkjkjkjkjkjkjkkjkkjkkkjkkkkkkkkkklkkklkklklklkllklllklllllllllllllmlllmlllmlmllmlmlmlmlmlmlmlmlmmlmlmlmlmmlmlmlmlmlmmllmlmlmlmlmllmlmllmllmllmllmllmlmllmllmmmmmmmmmmmmm',
    ],
  ],
  rdbu: [
    [
      5,
      'nnnnnonnnnnnnonnnnnnonnnnonnnonnonnonononooonooooopooopopopppopppoppppppoppppopppopoppopoopopoooopooooooonooonoonononnonnnnnnnnnnnmnnmnmnmnmmnmmmmmmnmmmmlmmmmmmlmmlmmlmlmlmlmllmllllmllllllllllklllllklllkllkllkllklklklkklkkklkkkkkjkkkjkjkjjkjjkjjjjjkjjjjjj',
    ],
    [
      48,
      'oooopoooooooooopooooooooonoooooooonooooonooooonoooooonooooooonooooonoooonoononononononnonnonnnnnnonnnnnnnmnnnnmnnmnmnmnmmmnmmmlmmmlmlmlllmlllllklllklklklkklkkkklkkkkkkjkkkkjkkjkkjkjkjkjkjkjjkjjkjjkjjkjjjjkjjjkjjjkjjkjkjkjkkjkkkkkkklkklklklllklllllllllllll',
    ],
    [
      97,
      'ppppppoppppoppopopopooooooooonononnonnnonnnnnnnnnnnnnnnnnnnnnnnnnnnnnnmnnnnnnnnnmnnnmnnnmnnmnnmnnmnmnmnmnmmnmmnmmmmmmmmmlmmlmlllmllklllklklkkkklkkkkjkkkkjkjkkjkjkjkjkjkjkjkjkjkjkjkkjkkkjkkkkkkkkkkkkkkklkkklklkklkllkllklllklllllllllmllllmllmlmllmlmlmlmlmlm',
    ],
  ],
};
