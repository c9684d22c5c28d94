// The element, and the kernel that it computes with, from one bundle. Webpack carries the kernel's workers and
// WebAssembly modules along by itself.

import { createKernel, unitSymbol } from 'girth';
import { useKernel } from 'girth/element';

const kernel = createKernel();
useKernel(kernel);

const mesh = await (await kernel).load('chair.glb');
const { range, unit } = await mesh.field('igf');
document.querySelector('#least').value = `${range[0].toFixed(3)} ${unitSymbol(unit)}`;
