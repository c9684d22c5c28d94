// A surface coloured by a scalar per vertex.

import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
  LinearFilter,
  Mesh,
  NoColorSpace,
  Ray,
  ShaderMaterial,
  type Sphere,
  Vector2,
  Vector3,
} from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { FacePoint, SurfacePoint } from '../kernel/types.js';
import type { Adjacency } from './adjacency.js';
import { weightsIn } from './barycentric.js';
import { type ColormapName, colormapSize, colormapTable } from './colormaps.js';
import type { CreasedSurface } from './creases.js';

/** Faces from which the hierarchy for picking is built in a worker: more would hold up the page. */
const manyFaces = 4000;

const vertexShader = /* glsl */ `
  attribute vec2 scalar;
  varying vec2 vScalar;
  varying vec3 vNormal;
  varying vec3 vView;

  void main() {
    vScalar = scalar;
    vNormal = normalMatrix * normal;
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    vView = -seen.xyz;
    gl_Position = projectionMatrix * seen;
  }
`;

// Colours stay sRGB from the table to the canvas. Light only scales them, by a factor between
// 0.70 and 1.04, the same for the three channels, so that hue and order of the map survive.
const fragmentShader = /* glsl */ `
  uniform sampler2D colormap;
  uniform vec2 range;
  uniform vec3 plain;
  varying vec2 vScalar;
  varying vec3 vNormal;
  varying vec3 vView;

  void main() {
    vec3 normal = normalize(vNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 view = normalize(vView);

    float known = clamp(vScalar.y, 0.0, 1.0);
    float value = vScalar.x / max(vScalar.y, 1e-6);
    float place = clamp((value - range.x) / max(range.y - range.x, 1e-30), 0.0, 1.0);
    float texel = (0.5 + place * ${(colormapSize - 1).toFixed(1)}) / ${colormapSize.toFixed(1)};
    vec3 colour = mix(plain, texture2D(colormap, vec2(texel, 0.5)).rgb, known);

    float key = 0.5 + 0.5 * dot(normal, normalize(vec3(-0.35, 0.75, 0.65)));
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float rim = 1.0 - facing;
    float light = mix(0.78, 1.04, smoothstep(0.05, 0.95, key)) - 0.08 * rim * rim * rim;
    gl_FragColor = vec4(colour * light, 1.0);
  }
`;

const hierarchyOptions = { indirect: true, targetLeafSize: 8 };

/** How strongly a vertex shows its colour: its own value, or one borrowed from a neighbour. */
export const computedWeight = 1;
export const borrowedWeight = 0.88;

export class Surface {
  /** What to add to a scene. */
  readonly object = new Group();
  readonly bounds: Sphere;

  private readonly drawn: BufferGeometry;
  private readonly picked: BufferGeometry;
  private readonly material: ShaderMaterial;
  private readonly scalar: BufferAttribute;
  private readonly firstCopy: Int32Array;
  private readonly nextCopy: Int32Array;
  private readonly texture: DataTexture;
  private edges: LineSegments<BufferGeometry, LineBasicMaterial> | undefined;
  private readonly walls: LineSegments<BufferGeometry, LineBasicMaterial> | undefined;
  private hierarchy: MeshBVH | undefined;
  private disposed = false;

  /**
   * `positions`, `indices` and `walls` are the mesh's own and stay unchanged; `creased` is the same
   * surface made ready to draw.
   */
  constructor(
    private readonly positions: Float32Array,
    private readonly indices: Uint32Array,
    walls: Uint32Array,
    private readonly adjacency: Adjacency,
    creased: CreasedSurface,
  ) {
    const vertexCount = positions.length / 3;
    const drawnCount = creased.positions.length / 3;
    this.firstCopy = new Int32Array(vertexCount).fill(-1);
    this.nextCopy = new Int32Array(creased.copyOf.length).fill(-1);
    creased.copyOf.forEach((vertex, copy) => {
      this.nextCopy[copy] = this.firstCopy[vertex]!;
      this.firstCopy[vertex] = copy;
    });

    this.scalar = new BufferAttribute(new Float32Array(2 * drawnCount), 2);
    this.scalar.setUsage(DynamicDrawUsage);
    this.drawn = new BufferGeometry();
    this.drawn.setAttribute('position', new BufferAttribute(creased.positions, 3));
    this.drawn.setAttribute('normal', new BufferAttribute(creased.normals, 3));
    this.drawn.setAttribute('scalar', this.scalar);
    this.drawn.setIndex(new BufferAttribute(creased.indices, 1));
    this.drawn.computeBoundingSphere();
    this.bounds = boundsOf(positions);

    this.picked = new BufferGeometry();
    this.picked.setAttribute('position', new BufferAttribute(positions, 3));
    this.picked.setIndex(new BufferAttribute(indices, 1));

    this.texture = new DataTexture(new Uint8Array(4 * colormapSize), colormapSize, 1);
    this.texture.colorSpace = NoColorSpace;
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    this.material = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      side: DoubleSide,
      uniforms: {
        colormap: { value: this.texture },
        range: { value: new Vector2(0, 1) },
        plain: { value: new Vector3(0.72, 0.72, 0.73) },
      },
      // Leaves room in depth for loops and edges drawn on the surface.
      polygonOffset: true,
      polygonOffsetFactor: 1.5,
      polygonOffsetUnits: 2,
    });
    this.object.add(new Mesh(this.drawn, this.material));
    if (walls.length > 0) this.walls = this.addLines(walls, 0.62);
    this.setColormap('viridis');
  }

  setColormap(name: ColormapName): void {
    (this.texture.image.data as Uint8Array).set(colormapTable(name));
    this.texture.needsUpdate = true;
  }

  /** The values at the two ends of the colour map. */
  setRange(low: number, high: number): void {
    (this.material.uniforms['range']!.value as Vector2).set(low, high);
  }

  /** The value of one vertex and how strongly it shows; weight 0 is plain grey. */
  setScalar(vertex: number, value: number, weight: number): void {
    const data = this.scalar.array;
    // Stored times its weight, so that values are averaged by weight across a face.
    const weighted = weight > 0 ? value * weight : 0;
    data[2 * vertex] = weighted;
    data[2 * vertex + 1] = weight;
    const vertexCount = this.firstCopy.length;
    for (let copy = this.firstCopy[vertex]!; copy >= 0; copy = this.nextCopy[copy]!) {
      data[2 * (vertexCount + copy)] = weighted;
      data[2 * (vertexCount + copy) + 1] = weight;
    }
  }

  /** Sends what `setScalar` changed with the next frame. */
  uploadScalars(): void {
    this.scalar.needsUpdate = true;
  }

  /** All vertices grey. */
  clearScalars(): void {
    this.scalar.array.fill(0);
    this.uploadScalars();
  }

  /** Draws every edge of the mesh as a hairline, or none. */
  showEdges(shown: boolean): void {
    if (shown && !this.edges) {
      const { first, neighbours } = this.adjacency;
      const pairs: number[] = [];
      for (let v = 0; v + 1 < first.length; ++v) {
        for (let k = first[v]!; k < first[v + 1]!; ++k) {
          if (neighbours[k]! > v) pairs.push(v, neighbours[k]!);
        }
      }
      this.edges = this.addLines(Uint32Array.from(pairs), 0.22);
    }
    if (this.edges) this.edges.visible = shown;
  }

  /** Hairlines between pairs of vertices. */
  private addLines(pairs: Uint32Array, opacity: number) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.picked.getAttribute('position'));
    geometry.setIndex(new BufferAttribute(pairs, 1));
    const material = new LineBasicMaterial({ color: 0x000000, transparent: true, opacity });
    const lines = new LineSegments(geometry, material);
    lines.renderOrder = 1;
    this.object.add(lines);
    return lines;
  }

  /**
   * Builds the hierarchy that picking needs; until then nothing is picked. Where there are many
   * faces a worker builds it, unless the page allows none.
   */
  async prepareToPick(): Promise<void> {
    const built =
      this.indices.length / 3 > manyFaces
        ? await this.buildInWorker().catch(() => undefined)
        : undefined;
    if (!this.disposed) this.hierarchy = built ?? new MeshBVH(this.picked, hierarchyOptions);
  }

  private async buildInWorker(): Promise<MeshBVH> {
    const { GenerateMeshBVHWorker } = await import('three-mesh-bvh/worker');
    const worker = new GenerateMeshBVHWorker();
    try {
      // The worker takes the arrays it is given away from this page: hand it copies.
      const copy = new BufferGeometry();
      copy.setAttribute('position', new BufferAttribute(this.positions.slice(), 3));
      copy.setIndex(new BufferAttribute(this.indices.slice(), 1));
      const built = MeshBVH.serialize(await worker.generate(copy, hierarchyOptions), {
        cloneBuffers: false,
      });
      return MeshBVH.deserialize(built, this.picked, { setIndex: false });
    } finally {
      worker.dispose();
    }
  }

  /** Where a ray first meets the surface; undefined where it passes by. */
  pick(ray: Ray): FacePoint | undefined {
    const hit = this.hierarchy?.raycastFirst(ray, DoubleSide);
    // The hierarchy leaves the faces in their order: their numbers are the mesh's own.
    if (!hit || typeof hit.faceIndex !== 'number') return undefined;
    const [a, b, c] = this.cornersOf(hit.faceIndex).map((vertex) => this.positionOf(vertex));
    return { face: hit.faceIndex, weights: weightsIn(a!, b!, c!, hit.point) };
  }

  /** The corner of a point's face that is nearest to it; the vertex itself where it is one. */
  nearestVertex(point: SurfacePoint): number {
    if (typeof point === 'number') return point;
    const place = this.positionOf(point);
    let nearest = -1;
    let shortest = Infinity;
    for (const vertex of this.cornersOf(point.face)) {
      const distance = this.positionOf(vertex).distanceToSquared(place);
      if (distance < shortest) [nearest, shortest] = [vertex, distance];
    }
    return nearest;
  }

  /**
   * True where the surface hides a point from the eye, and as long as that is not known; points on
   * the surface's near side are not hidden.
   */
  hides(point: Vector3, eye: Vector3): boolean {
    if (!this.hierarchy) return true;
    const ray = new Ray(eye, point.clone().sub(eye));
    const distance = ray.direction.length();
    ray.direction.divideScalar(distance);
    const hit = this.hierarchy.raycastFirst(ray, DoubleSide);
    return !!hit && hit.distance < distance - 0.01 * this.bounds.radius;
  }

  positionOf(point: SurfacePoint): Vector3 {
    if (typeof point === 'number') return new Vector3().fromArray(this.positions, 3 * point);
    const position = new Vector3();
    this.cornersOf(point.face).forEach((vertex, k) => {
      position.addScaledVector(this.positionOf(vertex), point.weights[k]!);
    });
    return position;
  }

  /** The vertices that share an edge with one. */
  neighboursOf(vertex: number): Uint32Array {
    const { first, neighbours } = this.adjacency;
    return neighbours.subarray(first[vertex], first[vertex + 1]);
  }

  private cornersOf(face: number): number[] {
    return Array.from(this.indices.subarray(3 * face, 3 * face + 3));
  }

  dispose(): void {
    this.disposed = true;
    this.drawn.dispose();
    this.picked.dispose();
    this.material.dispose();
    this.texture.dispose();
    for (const lines of [this.edges, this.walls]) {
      lines?.geometry.dispose();
      lines?.material.dispose();
    }
    this.hierarchy = undefined;
    this.object.removeFromParent();
  }
}

/** The ball round the middle of the bounding box. */
function boundsOf(positions: Float32Array): Sphere {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.computeBoundingSphere();
  return geometry.boundingSphere!;
}
