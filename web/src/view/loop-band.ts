// A loop on the surface: a bright band with a soft shadow, its midpoint a dot.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  GreaterDepth,
  Group,
  LessEqualDepth,
  NotEqualStencilFunc,
  Points,
  ReplaceStencilOp,
  ShaderMaterial,
} from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { Loop } from '../kernel/types.js';

/**
 * How much nearer to the eye than it is a line is drawn, as a share of its distance: along the line
 * of sight, so that it does not move on the screen, and in proportion to the size of a pixel.
 */
const lift = 0.002;

/** The strokes of a band from the bottom up; widths in CSS pixels. */
const strokes = [
  { part: 'hidden', width: 3, opacity: 0.22 },
  { part: 'shadow', width: 16, opacity: 0.05 },
  { part: 'shadow', width: 13.5, opacity: 0.07 },
  { part: 'shadow', width: 11, opacity: 0.1 },
  { part: 'shadow', width: 8.5, opacity: 0.16 },
  { part: 'shadow', width: 6, opacity: 0.3 },
  { part: 'band', width: 3.6, opacity: 1 },
] as const;

export interface BandStyle {
  /** CSS colour of the band. */
  colour: string;
  /** Multiplies the widths. */
  weight: number;
}

export class LoopBand {
  readonly object = new Group();

  private readonly line: LineGeometry;
  private readonly materials: LineMaterial[];
  private readonly dots: Points<BufferGeometry, ShaderMaterial>;

  constructor(loop: Loop, style: BandStyle) {
    const antipodal = loop.kind === 'antipodal';
    // Of a loop that was not found there is only the base.
    const known = loop.polyline.length > 0;
    this.line = new LineGeometry();
    if (known) this.line.setPositions(loop.polyline);
    this.materials = (known ? strokes : []).map(({ part, width, opacity }, order) => {
      const dashed = antipodal && part !== 'shadow';
      const material = new LineMaterial({
        color: part === 'shadow' ? '#05060a' : style.colour,
        linewidth: width * style.weight,
        transparent: true,
        opacity: antipodal && part === 'shadow' ? 0.6 * opacity : opacity,
        depthWrite: false,
        depthFunc: part === 'hidden' ? GreaterDepth : LessEqualDepth,
        dashed,
      });
      // A stroke covers each pixel once, so that its overlapping segments do not add up.
      if (part !== 'band') {
        material.stencilWrite = true;
        material.stencilRef = order + 1;
        material.stencilFunc = NotEqualStencilFunc;
        material.stencilZPass = ReplaceStencilOp;
      }
      if (dashed) {
        // Out and back may be one path: dashes symmetric about both its ends fall on each other.
        const dashes = 2 * Math.max(4, Math.round(strokesPerLoop / 2));
        material.dashScale = dashes / lengthOf(loop.polyline);
        material.dashSize = 0.6;
        material.gapSize = 0.4;
        material.dashOffset = 0.3;
      }
      if (part !== 'hidden') liftLine(material);
      const object = new Line2(this.line, material);
      if (dashed) object.computeLineDistances();
      object.renderOrder = 2 + order;
      object.frustumCulled = false;
      this.object.add(object);
      return material;
    });
    this.dots = makeDots(loop, style);
    this.object.add(this.dots);
  }

  setPixelRatio(ratio: number): void {
    this.dots.material.uniforms['pixelRatio']!.value = ratio;
  }

  dispose(): void {
    this.line.dispose();
    for (const material of this.materials) material.dispose();
    this.dots.geometry.dispose();
    this.dots.material.dispose();
    this.object.removeFromParent();
  }
}

/** Dashes of a there-and-back path. */
const strokesPerLoop = 72;

function lengthOf(polyline: Float32Array): number {
  let length = 0;
  for (let i = 3; i < polyline.length; i += 3) {
    length += Math.hypot(
      polyline[i]! - polyline[i - 3]!,
      polyline[i + 1]! - polyline[i - 2]!,
      polyline[i + 2]! - polyline[i - 1]!,
    );
  }
  return length || 1;
}

/** Moves a line towards the eye, so that the surface it lies on does not cut it. */
function liftLine(material: LineMaterial): void {
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace(
      'float aspect =',
      `float lift = ${(1 - lift).toFixed(4)};\n float aspect =`,
    );
    for (const end of ['Start', 'End']) {
      shader.vertexShader = shader.vertexShader.replace(
        `modelViewMatrix * vec4( instance${end}, 1.0 );`,
        `modelViewMatrix * vec4( instance${end}, 1.0 ); ${end.toLowerCase()}.xyz *= lift;`,
      );
    }
  };
  material.customProgramCacheKey = () => 'lifted';
}

/** The base point as a small dot, the midpoint as a larger one with a dark ring. */
function makeDots(loop: Loop, style: BandStyle): Points<BufferGeometry, ShaderMaterial> {
  const geometry = new BufferGeometry();
  const base = loop.polyline.length > 0 ? loop.polyline.subarray(0, 3) : loop.midpoint;
  geometry.setAttribute(
    'position',
    new BufferAttribute(Float32Array.from([...base, ...loop.midpoint]), 3),
  );
  geometry.setAttribute(
    'size',
    new BufferAttribute(Float32Array.from([8 * style.weight, 15 * style.weight]), 1),
  );
  const material = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    uniforms: { pixelRatio: { value: 1 }, colour: { value: srgb(style.colour) } },
    vertexShader: /* glsl */ `
      attribute float size;
      uniform float pixelRatio;
      varying float vSize;
      void main() {
        vSize = size * pixelRatio;
        vec4 seen = modelViewMatrix * vec4(position, 1.0);
        gl_Position = projectionMatrix * vec4(seen.xyz * ${(1 - 2 * lift).toFixed(4)}, 1.0);
        gl_PointSize = vSize + 2.0;
      }
    `,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      uniform float pixelRatio;
      varying float vSize;
      void main() {
        float radius = length(gl_PointCoord - 0.5) * (vSize + 2.0);
        float outer = 0.5 * vSize;
        float alpha = 1.0 - smoothstep(outer - 0.7, outer + 0.7, radius);
        if (alpha <= 0.0) discard;
        float inner = outer - 2.2 * pixelRatio;
        vec3 shown = mix(colour, vec3(0.03, 0.04, 0.06), smoothstep(inner - 0.7, inner + 0.7, radius));
        gl_FragColor = vec4(shown, alpha);
      }
    `,
  });
  const dots = new Points(geometry, material);
  dots.frustumCulled = false;
  dots.renderOrder = 2 + strokes.length;
  return dots;
}

/** The colour's sRGB components, for shaders that write them to the canvas as they are. */
function srgb(css: string): Color {
  return new Color(css).convertLinearToSRGB();
}
