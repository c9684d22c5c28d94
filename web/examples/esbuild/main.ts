// The element, and the kernel beside it, from one bundle. The kernel's workers come from the copied folder.

import { createKernel, unitSymbol } from 'girth';
import { useKernel } from 'girth/element';

const kernel = createKernel({ base: 'girth/' });
useKernel(kernel);

const mesh = await (await kernel).load('chair.glb');
const { range, unit } = await mesh.field('igf');
const least = document.querySelector<HTMLOutputElement>('#least')!;
least.value = `${range[0].toFixed(3)} ${unitSymbol(unit)}`;
