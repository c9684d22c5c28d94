// Lines and dots that lie on a surface, of a width in CSS pixels.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  GreaterDepth,
  LessEqualDepth,
  NotEqualStencilFunc,
  type Object3D,
  Points,
  ReplaceStencilOp,
  ShaderMaterial,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';

/** Something on the surface that a stage draws. */
export interface Overlay {
  readonly object: Object3D;
  /** The screen's pixels for each CSS pixel. */
  setPixelRatio(ratio: number): void;
  /** Lets go of its memory and of the stage. */
  dispose(): void;
}

/**
 * How much nearer to the eye than it is a line is drawn, as a share of its distance: along the line
 * of sight, so that it does not move on the screen, and in proportion to the size of a pixel.
 */
export const lift = 0.002;

export interface Stroke {
  /** CSS colour. */
  colour: string;
  /** CSS pixels. */
  width: number;
  opacity: number;
  /** Drawn where the surface hides the line, instead of where it does not. */
  hidden: boolean;
  dashed: boolean;
  /** A number of its own makes the stroke cover each pixel once, so that its parts do not add up. */
  once?: number;
}

/** The material that a line is drawn with; the caller disposes of it. */
export function strokeMaterial(stroke: Stroke): LineMaterial {
  const { colour, width, opacity, hidden, dashed, once } = stroke;
  const material = new LineMaterial({
    color: colour,
    linewidth: width,
    transparent: true,
    opacity,
    depthWrite: false,
    depthFunc: hidden ? GreaterDepth : LessEqualDepth,
    dashed,
  });
  if (once !== undefined) {
    material.stencilWrite = true;
    material.stencilRef = once;
    material.stencilFunc = NotEqualStencilFunc;
    material.stencilZPass = ReplaceStencilOp;
  }
  if (!hidden) liftLine(material);
  return material;
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

export type Dots = Points<BufferGeometry, ShaderMaterial>;

export interface Dot {
  place: ArrayLike<number>;
  /** CSS pixels across. */
  size: number;
}

/** Round dots or diamonds of one colour with a dark rim, in front of what is drawn up to `order`. */
export function makeDots(
  dots: readonly Dot[],
  colour: string,
  order: number,
  shape: 'round' | 'diamond' = 'round',
): Dots {
  const geometry = new BufferGeometry();
  const places = dots.flatMap(({ place }) => [place[0]!, place[1]!, place[2]!]);
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(places), 3));
  geometry.setAttribute(
    'size',
    new BufferAttribute(
      Float32Array.from(dots, (d) => d.size),
      1,
    ),
  );
  const material = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    clipping: true,
    uniforms: { pixelRatio: { value: 1 }, colour: { value: srgb(colour) } },
    vertexShader: /* glsl */ `
      attribute float size;
      uniform float pixelRatio;
      varying float vSize;
      #include <clipping_planes_pars_vertex>
      void main() {
        vSize = size * pixelRatio;
        vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
        #include <clipping_planes_vertex>
        gl_Position = projectionMatrix * vec4(mvPosition.xyz * ${(1 - 2 * lift).toFixed(4)}, 1.0);
        gl_PointSize = vSize + 2.0;
      }
    `,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      uniform float pixelRatio;
      varying float vSize;
      #include <clipping_planes_pars_fragment>
      void main() {
        #include <clipping_planes_fragment>
        vec2 away = abs(gl_PointCoord - 0.5) * (vSize + 2.0);
        float radius = ${shape === 'round' ? 'length(away)' : 'away.x + away.y'};
        float outer = 0.5 * vSize;
        float alpha = 1.0 - smoothstep(outer - 0.7, outer + 0.7, radius);
        if (alpha <= 0.0) discard;
        float inner = outer - 2.2 * pixelRatio;
        vec3 shown = mix(colour, vec3(0.03, 0.04, 0.06), smoothstep(inner - 0.7, inner + 0.7, radius));
        gl_FragColor = vec4(shown, alpha);
      }
    `,
  });
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  points.renderOrder = order;
  return points;
}

/** The colour's sRGB components, for shaders that write them to the canvas as they are. */
export function srgb(css: string): Color {
  return new Color(css).convertLinearToSRGB();
}
