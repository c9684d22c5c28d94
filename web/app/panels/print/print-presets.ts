// Limits of usual printers and materials, each with the public source of its numbers.
// A limit is the least diameter of a pin, or the least thickness of a wall that stands free.

export interface PrintPreset {
  /** The name of the preset in links. */
  key: string;
  name: string;
  /** Limits as a user types them: with their unit. */
  tubeDiameter: string;
  wallThickness: string;
  source: { title: string; address: string };
}

const arti90 = { title: 'Arti90, design clues', address: 'https://arti90.com/en/design-clues/' };

export const printPresets: readonly PrintPreset[] = [
  {
    key: 'fdm',
    name: 'Filament (FDM), plastic',
    tubeDiameter: '3 mm',
    wallThickness: '1 mm',
    source: arti90,
  },
  {
    key: 'sla',
    name: 'Resin (SLA, DLP)',
    tubeDiameter: '1.5 mm',
    wallThickness: '0.8 mm',
    source: {
      title: 'Layer One, design for 3D printing',
      address: 'https://layer-one.com.au/blog/design-for-3d-printing-guide',
    },
  },
  {
    key: 'sls',
    name: 'Nylon powder (SLS)',
    tubeDiameter: '1 mm',
    wallThickness: '0.7 mm',
    source: arti90,
  },
  {
    key: 'dmls',
    name: 'Metal powder (DMLS)',
    tubeDiameter: '1 mm',
    wallThickness: '1 mm',
    source: arti90,
  },
  {
    key: 'polyjet',
    name: 'Photopolymer (PolyJet)',
    tubeDiameter: '1 mm',
    wallThickness: '1 mm',
    source: {
      title: 'Forge Labs, design guidelines',
      address: 'https://forgelabs.ca/guidelines/',
    },
  },
];
