// Made of types.ts by `npm run build:tables`: not to be edited.

/** The names of the options of each parameter that has some, by the call and the parameter's place. */
export type CallOptionNames = Readonly<Record<string, Readonly<Record<number, readonly string[]>>>>;

/** Options of `createKernel`. */
export const kernelOptionNames: readonly string[] = ['threads', 'mode', 'base'];

/** Options of the calls of each interface. */
export const callOptionNames: Readonly<
  Record<'Kernel' | 'Mesh' | 'RemeshedMesh', CallOptionNames>
> = {
  Kernel: {
    compare: { '1': ['descriptors', 'faces', 'smooth', 'onProgress', 'signal'] },
    load: {
      '1': [
        'model',
        'prepare',
        'prepare.scale',
        'prepare.weldDistance',
        'prepare.closeHoles',
        'prepare.components',
        'prepare.minComponent',
        'onProgress',
        'signal',
      ],
    },
  },
  Mesh: {
    field: {
      '1': [
        'onPartial',
        'spectral',
        'spectral.pairs',
        'spectral.time',
        'spectral.component',
        'urgent',
        'onProgress',
        'signal',
        'persistence',
        'distances',
        'sdf',
        'sdf.rays',
        'sdf.coneRadians',
        'thickness',
        'thickness.sharpRadians',
        'distance',
        'distance.from',
        'distance.radius',
      ],
    },
    refinedGirth: { '0': ['coarseFaces', 'audit', 'seed', 'onProgress', 'signal'] },
    loop: { '1': ['persistence', 'signal'] },
    barcode: { '1': ['maxPersistence', 'maxSaddles', 'loops', 'signal'] },
    barcodes: { '0': ['maxPersistence', 'onProgress', 'signal'] },
    path: { '2': ['signal'] },
    exportModel: { '1': ['unit', 'signal'] },
    exportField: { '2': ['unit', 'signal'] },
    exportFields: { '2': ['unit', 'signal'] },
    exportLoops: { '2': ['unit', 'signal', 'persistence'] },
    vertexAreas: { '0': ['signal'] },
    tips: { '1': ['signal'] },
    limbs: { '1': ['stations', 'onProgress', 'signal'] },
    necks: { '1': ['minProminence', 'onProgress', 'signal'] },
    bottleneck: { '3': ['onProgress', 'signal'] },
    profile: { '1': ['samples', 'crossings', 'onProgress', 'signal'] },
    axis: { '1': ['onProgress', 'signal'] },
    exportProfile: { '2': ['unit', 'signal', 'samples', 'crossings', 'onProgress'] },
    handles: { '0': ['basePoints', 'onProgress', 'signal'] },
    removeHandles: { '1': ['basePoints', 'onProgress', 'signal'] },
    levelCurves: { '2': ['signal'] },
    cut: { '1': ['cap', 'signal'] },
    exportCut: { '2': ['unit', 'signal', 'cap'] },
    segments: {
      '2': ['minProminence', 'onProgress', 'signal', 'smoothing', 'girth', 'shapeDiameter'],
    },
    exportSegments: {
      '3': ['unit', 'signal', 'minProminence', 'onProgress', 'smoothing', 'girth', 'shapeDiameter'],
    },
    suggestedThresholds: { '2': ['signal'] },
    parts: { '2': ['smoothing', 'girth', 'shapeDiameter'], '3': ['signal'] },
    printCheck: {
      '0': ['igf', 'thickness'],
      '1': ['tubeDiameter', 'wallThickness', 'gap'],
      '2': ['onProgress', 'signal'],
    },
    maxima: { '1': ['minima', 'signal'] },
    heatMaxima: { '0': ['onProgress', 'signal', 'pairs', 'time', 'component'] },
    write: { '2': ['profiles', 'unit', 'signal'] },
    exportTips: { '2': ['unit', 'signal'] },
    exportLimbs: { '2': ['unit', 'signal', 'stations', 'onProgress'] },
    exportParts: { '2': ['smoothing', 'girth', 'shapeDiameter'], '4': ['unit', 'signal'] },
    exportWeakPlaces: {
      '0': ['igf', 'thickness'],
      '1': ['tubeDiameter', 'wallThickness', 'gap'],
      '3': ['unit', 'signal'],
    },
    remesh: { '1': ['even', 'onProgress', 'signal'] },
    smooth: { '1': ['onProgress', 'signal'] },
    difference: { '3': ['signal'] },
  },
  RemeshedMesh: { carryBack: { '1': ['signal'] }, carryField: { '1': ['signal'] } },
};
