// How a surface is coloured: by a scalar, by categories, or by where two scalars lie from two thresholds.
// Colours stay sRGB from the tables to the canvas. Each way is a program of its own, since every quantity
// that is not needed would cost time at every pixel: SHADING is one of the modes; LINES is defined where
// there are lines of equal value, LOGARITHMIC where the colour map is,
// DOUBTFUL where jumps are striped, FLAGS where there are marks or tips, FLAT where each face has one light.
// Where three.js has a clipping plane, what lies in front of it is not drawn, the cut has a dark line, and the inside is plain.

import { colormapSize } from './colormaps.js';

/** Ways to colour the surface: the values of the shader's SHADING, but for a plain surface. */
export const shadingModes = { scalar: 1, categories: 2, thresholds: 3 } as const;
export type ShadingMode = keyof typeof shadingModes | 'plain';

/** As many categories as there are components in an attribute. */
export const mostCategories = 4;

/**
 * Attributes of a vertex beside its position and normal. `scalar`: the value times its weight, and the
 * weight. `pair`: the same of two values with one weight. `category`: 1 at the number of its category.
 * `flags`: 1 where it is marked, where it belongs to a tip, where that tip is selected, and 0.
 */
export const vertexShader = /* glsl */ `
  #if SHADING == ${shadingModes.scalar}
    attribute vec2 scalar;
    varying vec2 vScalar;
  #elif SHADING == ${shadingModes.categories}
    attribute vec4 category;
    varying vec4 vCategory;
  #else
    attribute vec3 pair;
    varying vec3 vPair;
  #endif
  #ifdef FLAGS
    attribute vec4 flags;
    varying vec3 vFlags;
  #endif
  uniform mat3 upright;
  varying vec3 vNormal;
  varying vec3 vView;

  void main() {
    #if SHADING == ${shadingModes.scalar}
      vScalar = scalar;
    #elif SHADING == ${shadingModes.categories}
      vCategory = category;
    #else
      vPair = pair;
    #endif
    #ifdef FLAGS
      vFlags = flags.xyz;
    #endif
    // Not the model's matrix: of the largest and smallest surfaces its numbers have no squares.
    vNormal = mat3(viewMatrix) * (upright * normal);
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    vView = -seen.xyz;
    gl_Position = projectionMatrix * seen;
  }
`;

const common = /* glsl */ `
  uniform vec3 plain;
  uniform float opacity;
  varying vec3 vNormal;
  varying vec3 vView;

  // 0 below 0, 1 above, with an edge of one pixel.
  float above(float quantity) {
    return clamp(0.5 + quantity / max(fwidth(quantity), 1e-37), 0.0, 1.0);
  }

  float brightness(vec3 colour) {
    return dot(colour, vec3(0.2126, 0.7152, 0.0722));
  }
`;

const byScalar = /* glsl */ `
  uniform sampler2D colormap;
  uniform vec2 range;
  uniform float coloured;
  varying vec2 vScalar;

  #if defined(LINES) || defined(DOUBTFUL)
    uniform float steepest;
    uniform float pixelRatio;

    // How fast a quantity changes along the surface, for each radius of it.
    float steepness(float quantity) {
      vec3 right = dFdx(vView);
      vec3 up = dFdy(vView);
      vec3 normal = cross(right, up);
      vec3 gradient = dFdx(quantity) * cross(up, normal) + dFdy(quantity) * cross(normal, right);
      return length(gradient) / max(dot(normal, normal), 1e-30);
    }

    // 1 where the values jump, 0 elsewhere.
    float jumpAt(float value) {
      return above(steepness((value - range.x) / max(range.y - range.x, 1e-37)) - steepest);
    }
  #endif

  #ifdef LINES
    uniform float isolines;

    // How strongly a line of equal value is drawn at a place in the range; they lie at whole levels from 1 on.
    float lineAt(float place, float value) {
      float level = place * (isolines + 1.0);
      float perPixel = max(fwidth(level), 1e-6);
      float away = abs(level - clamp(floor(level + 0.5), 1.0, isolines)) / (perPixel * pixelRatio);
      // Too close together they would only be a dark smear; and where the value jumps there are none.
      float line = (1.0 - smoothstep(0.3, 1.1, away)) * (1.0 - smoothstep(0.2, 0.5, perPixel));
      return line * (1.0 - jumpAt(value));
    }
  #endif

  vec3 surfaceColour() {
    // Neighbours' values that a vertex shows until it has its own weigh 0.88: a little paler.
    float known = above(vScalar.y - 0.5) * mix(0.88, 1.0, smoothstep(0.88, 1.0, vScalar.y));
    float value = vScalar.x / max(vScalar.y, 1e-6);
    #ifdef LOGARITHMIC
      float place = log(max(value, 1e-37) / range.x) / log(range.y / range.x);
    #else
      float place = (value - range.x) / max(range.y - range.x, 1e-37);
    #endif
    float texel =
      (0.5 + clamp(place, 0.0, 1.0) * ${(colormapSize - 1).toFixed(1)}) / ${colormapSize.toFixed(1)};
    vec3 colour = texture2D(colormap, vec2(texel, 0.5)).rgb;
    #ifdef LINES
      float contrast = step(brightness(colour), 0.3);
      colour = mix(colour, vec3(contrast), 0.6 * lineAt(place, value));
    #endif
    #ifdef DOUBTFUL
      float across = (gl_FragCoord.x + gl_FragCoord.y) / (7.0 * pixelRatio);
      float stripe = smoothstep(0.0, 0.16, abs(fract(across) - 0.5) - 0.25);
      colour = mix(colour, plain, 0.75 * stripe * jumpAt(value));
    #endif
    return mix(plain, colour, coloured * known);
  }
`;

const palette = /* glsl */ `
  uniform vec3 palette[${mostCategories}];
  uniform float hatched[${mostCategories}];
  uniform float pixelRatio;

  // Slanting stripes of the screen, for what must not be distinguished by its colour alone.
  vec3 categoryColour(int number) {
    float across = (gl_FragCoord.x + gl_FragCoord.y) / (7.0 * pixelRatio);
    float stripe = smoothstep(0.0, 0.16, abs(fract(across) - 0.5) - 0.25);
    return palette[number] * (1.0 - 0.28 * hatched[number] * stripe);
  }
`;

const byCategory = /* glsl */ `
  varying vec4 vCategory;

  vec3 surfaceColour() {
    int first = 0;
    int second = 1;
    if (vCategory[1] > vCategory[0]) { first = 1; second = 0; }
    for (int i = 2; i < ${mostCategories}; ++i) {
      if (vCategory[i] > vCategory[first]) { second = first; first = i; }
      else if (vCategory[i] > vCategory[second]) { second = i; }
    }
    float lead = vCategory[first] - vCategory[second];
    float share = clamp(0.5 + lead / max(fwidth(lead), 1e-6), 0.5, 1.0);
    return mix(categoryColour(second), categoryColour(first), share);
  }
`;

const byThresholds = /* glsl */ `
  uniform vec2 thresholds;
  varying vec3 vPair;

  // Body, tube, plate and unknown, in this order.
  vec3 surfaceColour() {
    vec2 values = vPair.xy / max(vPair.z, 1e-6);
    float thin = above(thresholds.y - values.y);
    float wide = above(values.x - thresholds.x);
    vec3 part = mix(categoryColour(1), categoryColour(2), wide);
    vec3 colour = mix(categoryColour(0), part, thin);
    return mix(categoryColour(3), colour, above(vPair.z - 0.5));
  }
`;

// Where a quantity passes a limit is found in the triangle, so that such lines are a pixel sharp however
// coarse the mesh is. Light only scales colours, by a factor between 0.70 and 1.04, the same for the three
// channels, so that hue and order of a map survive.
export const fragmentShader = /* glsl */ `
  ${common}
  #if SHADING == ${shadingModes.scalar}
    ${byScalar}
  #else
    ${palette}
    #if SHADING == ${shadingModes.categories}
      ${byCategory}
    #else
      ${byThresholds}
    #endif
  #endif

  #ifdef FLAGS
    uniform float marking;
    uniform float tinting;
    uniform vec3 tint;
    varying vec3 vFlags;

    vec3 flagged(vec3 colour) {
      float inTip = above(vFlags.y - 0.5);
      float inSelected = above(vFlags.z - 0.5);
      colour = mix(colour, tint, tinting * max(0.3 * inTip, 0.68 * inSelected));
      vec3 faded = mix(plain, vec3(brightness(colour)), 0.15);
      return mix(colour, faded, marking * (1.0 - above(vFlags.x - 0.5)));
    }
  #endif

  #if NUM_CLIPPING_PLANES > 0
    uniform vec4 clippingPlanes[NUM_CLIPPING_PLANES];
  #endif

  void main() {
    #if NUM_CLIPPING_PLANES > 0
      float left = clippingPlanes[0].w - dot(vView, clippingPlanes[0].xyz);
      float perPixel = max(fwidth(left), 1e-37);
      if (left < 0.0) discard;
    #endif
    vec3 colour = surfaceColour();
    #ifdef FLAGS
      colour = flagged(colour);
    #endif
    #ifdef FLAT
      vec3 normal = normalize(cross(dFdx(vView), dFdy(vView)));
    #else
      vec3 normal = normalize(vNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    #endif
    vec3 view = normalize(vView);
    float key = 0.5 + 0.5 * dot(normal, normalize(vec3(-0.35, 0.75, 0.65)));
    float rim = 1.0 - clamp(dot(normal, view), 0.0, 1.0);
    float light = mix(0.78, 1.04, smoothstep(0.05, 0.95, key)) - 0.08 * rim * rim * rim;
    #if NUM_CLIPPING_PLANES > 0
      if (!gl_FrontFacing) colour = 0.82 * plain;
      colour *= mix(0.25, 1.0, smoothstep(0.8, 1.8, left / perPixel));
    #endif
    gl_FragColor = vec4(colour * light, opacity);
  }
`;
