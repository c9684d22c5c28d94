import { chair } from './chair.ts';
import { cup } from './cup.ts';
import { dumbbell } from './dumbbell.ts';
import { handles } from './handles.ts';
import { hook } from './hook.ts';
import type { Model } from './model.ts';
import { octopus } from './octopus.ts';
import { spine } from './spine.ts';
import { vessel } from './vessel.ts';

/** All examples in the order in which the page offers them. */
export const models: readonly Model[] = [
  chair,
  octopus,
  handles,
  dumbbell,
  cup,
  vessel,
  spine,
  hook,
];
