// A surface coloured by a scalar per vertex.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  DoubleSide,
  Group,
  LinearFilter,
  LineBasicMaterial,
  LineSegments,
  Matrix3,
  Matrix4,
  Mesh,
  NoColorSpace,
  Quaternion,
  Ray,
  ShaderMaterial,
  Sphere,
  Vector2,
  Vector3,
} from 'three';
import type { MeshBVH } from 'three-mesh-bvh';
import type { FacePoint, SurfacePoint } from '../kernel/types/types.js';
import type { Adjacency } from './adjacency.js';
import { weightsIn } from './barycentric.js';
import type { Category } from './categories.js';
import type { ColormapName } from './colormap-names.js';
import { colormapSize, colormapTable } from './colormaps.js';
import type { CreasedSurface } from './creases.js';
import { DrawnVertices } from './drawn-vertices.js';
import { longWay } from './long-way.js';
import type { Look } from './look.js';
import type { SectionPlane } from './section-plane.js';
import type { Silhouette } from './silhouette.js';
import {
  type ShadingMode,
  fragmentShader,
  mostCategories,
  shadingModes,
  vertexShader,
} from './surface-shader.js';
import type { Rotation } from './up-axis.js';

/** Faces from which the hierarchy for picking is built in a worker: more would hold up the page. */
const manyFaces = 4000;

const hierarchyOptions = { indirect: true, targetLeafSize: 8 };

/** How strongly a vertex shows its colour: its own value, or one borrowed from a neighbour. */
export const computedWeight = 1;
export const borrowedWeight = 0.88;

export class Surface {
  /** The object to add to a scene. */
  readonly object = new Group();
  readonly bounds: Sphere;
  /** A plane: parts in front of it are not picked, and hide nothing. */
  section: SectionPlane | undefined;

  readonly #drawn: BufferGeometry;
  readonly #picked: BufferGeometry;
  readonly #material: ShaderMaterial;
  readonly #vertices: DrawnVertices;
  readonly #scalar: BufferAttribute;
  readonly #flags: BufferAttribute;
  readonly #texture: DataTexture;
  #edges: LineSegments<BufferGeometry, LineBasicMaterial> | undefined;
  readonly #boundary: LineSegments<BufferGeometry, LineBasicMaterial> | undefined;
  #hierarchy: MeshBVH | undefined;
  #steepest = 0;
  #disposed = false;
  readonly #positions: Float32Array;
  readonly #indices: Uint32Array;
  readonly #adjacency: Adjacency;

  /**
   * `positions`, `indices` and `boundary` are the mesh's own and stay unchanged; `creased` is the same
   * surface made ready to draw.
   */
  constructor(
    positions: Float32Array,
    indices: Uint32Array,
    boundary: Uint32Array,
    adjacency: Adjacency,
    creased: CreasedSurface,
  ) {
    this.#positions = positions;
    this.#indices = indices;
    this.#adjacency = adjacency;
    this.#vertices = new DrawnVertices(positions.length / 3, creased.copyOf);
    this.#scalar = this.#vertices.attribute(2, 'floats');
    this.#flags = this.#vertices.attribute(4, 'shares');
    this.#drawn = new BufferGeometry();
    this.#drawn.setAttribute('position', new BufferAttribute(creased.positions, 3));
    this.#drawn.setAttribute('normal', new BufferAttribute(creased.normals, 3));
    this.#drawn.setAttribute('scalar', this.#scalar);
    this.#drawn.setAttribute('flags', this.#flags);
    this.#drawn.setIndex(new BufferAttribute(creased.indices, 1));
    this.bounds = boundsOf(positions);
    // The copies of vertices lie where these do.
    this.#drawn.boundingSphere = this.bounds.clone();

    this.#picked = new BufferGeometry();
    this.#picked.setAttribute('position', new BufferAttribute(positions, 3));
    this.#picked.setIndex(new BufferAttribute(indices, 1));

    this.#texture = new DataTexture(new Uint8Array(4 * colormapSize), colormapSize, 1);
    this.#texture.colorSpace = NoColorSpace;
    this.#texture.minFilter = this.#texture.magFilter = LinearFilter;
    this.#material = new ShaderMaterial({
      vertexShader,
      fragmentShader,
      side: DoubleSide,
      clipping: true,
      defines: { SHADING: shadingModes.scalar },
      uniforms: {
        upright: { value: new Matrix3() },
        opacity: { value: 1 },
        coloured: { value: 0 },
        colormap: { value: this.#texture },
        range: { value: new Vector2(0, 1) },
        isolines: { value: 0 },
        steepest: { value: 0 },
        pixelRatio: { value: 1 },
        plain: { value: new Vector3(0.72, 0.72, 0.73) },
        palette: { value: Array.from({ length: mostCategories }, () => new Vector3()) },
        hatched: { value: new Array<number>(mostCategories).fill(0) },
        thresholds: { value: new Vector2() },
        marking: { value: 0 },
        tinting: { value: 0 },
        tint: { value: new Vector3(1, 0.48, 0.27) },
      },
      // Leaves room in depth for loops and edges drawn on the surface.
      polygonOffset: true,
      polygonOffsetFactor: 1.5,
      polygonOffsetUnits: 2,
    });
    // Until they are first needed; the two cost much memory.
    Object.assign(this.#material.defaultAttributeValues, {
      pair: [0, 0, 0],
      category: [0, 0, 0, 0],
    });
    this.object.add(new Mesh(this.#drawn, this.#material));
    if (boundary.length > 0) this.#boundary = this.#addLines(boundary, 0.62);
    this.setColormap('viridis');
  }

  setColormap(name: ColormapName): void {
    (this.#texture.image.data as Uint8Array).set(colormapTable(name));
    this.#texture.needsUpdate = true;
  }

  /** The values at the two ends of the colour map. */
  setRange(low: number, high: number): void {
    this.#vector2('range').set(low, high);
    this.#updateSteepest();
  }

  /** Whether equal factors are equally far apart in the colour map; both ends of the range are above 0. */
  setLog(log: boolean): void {
    this.#define('LOGARITHMIC', log ? '' : undefined);
  }

  /**
   * So many lines of equal value, evenly spaced between the ends of the range; 0: none. Where the value
   * changes by more than `steepest` for each unit of length it jumps, and has no lines; stripes where `isDoubtful`: the
   * place of a jump is not known.
   */
  setIsolines(count: number, steepest: number, isDoubtful = false): void {
    this.#define('LINES', count > 0 ? '' : undefined);
    this.#define('DOUBTFUL', isDoubtful ? '' : undefined);
    this.#material.uniforms['isolines']!.value = count;
    this.#steepest = steepest;
    this.#updateSteepest();
  }

  /** The shader's counts in ranges for each radius: numbers of the same size on every surface. */
  #updateSteepest(): void {
    const { x: low, y: high } = this.#vector2('range');
    const steepest = (this.#steepest * this.bounds.radius) / (high - low);
    this.#material.uniforms['steepest']!.value = Math.min(Math.abs(steepest), 1e30) || 0;
  }

  /** Smooth, flat or transparent. */
  setLook(look: Look): void {
    const material = this.#material;
    const isTransparent = look === 'transparent';
    this.#define('FLAT', look === 'flat' ? '' : undefined);
    material.uniforms['opacity']!.value = isTransparent ? 0.45 : 1;
    if (material.transparent === isTransparent) return;
    material.transparent = isTransparent;
    // Nothing hides what is behind; the far side is drawn first, then the near one.
    material.depthWrite = !isTransparent;
    material.forceSinglePass = !isTransparent;
    material.needsUpdate = true;
  }

  /** How the surface is turned in the scene: light falls from above. */
  setUpright(rotation: Rotation): void {
    const matrix = new Matrix4().makeRotationFromQuaternion(new Quaternion().copy(rotation));
    (this.#material.uniforms['upright']!.value as Matrix3).setFromMatrix4(matrix);
  }

  /** The screen's pixels for each CSS pixel. */
  setPixelRatio(ratio: number): void {
    this.#material.uniforms['pixelRatio']!.value = ratio;
  }

  /** Chooses the colouring among those that were set before. */
  shadeBy(mode: ShadingMode): void {
    this.#material.uniforms['coloured']!.value = mode === 'plain' ? 0 : 1;
    this.#define('SHADING', shadingModes[mode === 'plain' ? 'scalar' : mode]);
  }

  /** The value of one vertex and how strongly it shows; weight 0 is plain grey. */
  setScalar(vertex: number, value: number, weight: number): void {
    // Stored times its weight, so that values are averaged by weight across a face.
    this.#vertices.set(this.#scalar, vertex, weight > 0 ? value * weight : 0, weight);
  }

  /** Sends what `setScalar` changed with the next frame. */
  uploadScalars(): void {
    this.#scalar.needsUpdate = true;
  }

  /** Sorts the vertices: a number below `categories.length` for each. */
  setCategories(numbers: ArrayLike<number>, categories: readonly Category[]): void {
    const attribute = this.#ensure('category', 4, 'shares');
    const data = attribute.array.fill(0);
    for (let vertex = 0; vertex < numbers.length; ++vertex) {
      data[4 * vertex + numbers[vertex]!] = 255;
    }
    this.#vertices.upload(attribute);
    this.#setPalette(categories);
  }

  /** Two values for each vertex, NaN where there is none, which thresholds divide. */
  setPair(girth: Float64Array, diameter: Float64Array): void {
    const attribute = this.#ensure('pair', 3, 'floats');
    const data = attribute.array;
    for (let vertex = 0; vertex < girth.length; ++vertex) {
      const known = !Number.isNaN(girth[vertex]! + diameter[vertex]!);
      data[3 * vertex] = known ? girth[vertex]! : 0;
      data[3 * vertex + 1] = known ? diameter[vertex]! : 0;
      data[3 * vertex + 2] = known ? 1 : 0;
    }
    this.#vertices.upload(attribute);
  }

  /**
   * Where the two values of `setPair` divide the surface, and the four categories, in this order: body,
   * where the second value is not below its threshold; of the rest tube, where the first value is below its
   * own threshold, and plate, where it is not; and places without values.
   */
  setThresholds(girth: number, diameter: number, categories: readonly Category[]): void {
    this.#vector2('thresholds').set(Math.min(girth, 1e30), Math.min(diameter, 1e30));
    this.#setPalette(categories);
  }

  /** Shows these vertices as they are and fades the others; undefined: all as they are. */
  mark(vertices: ArrayLike<number> | undefined): void {
    if (!vertices && this.#material.uniforms['marking']!.value === 0) return;
    this.#setFlags('marking', vertices !== undefined);
    this.#setFlag(0, vertices ? [vertices] : []);
  }

  /** Tints regions, one of them strongly. */
  tint(regions: readonly ArrayLike<number>[], selected: ArrayLike<number> | undefined): void {
    this.#setFlags('tinting', regions.length > 0 || selected !== undefined);
    this.#setFlag(1, regions);
    this.#setFlag(2, selected ? [selected] : []);
  }

  #setFlags(use: 'marking' | 'tinting', used: boolean): void {
    const { uniforms } = this.#material;
    uniforms[use]!.value = used ? 1 : 0;
    const isUsed = uniforms['marking']!.value === 1 || uniforms['tinting']!.value === 1;
    this.#define('FLAGS', isUsed ? '' : undefined);
  }

  /** Chooses the program: one that is new to the page is compiled with the next frame. */
  #define(name: string, value: unknown): void {
    const { defines } = this.#material;
    if (defines[name] === value) return;
    if (value === undefined) delete defines[name];
    else defines[name] = value;
    this.#material.needsUpdate = true;
  }

  #setFlag(component: number, regions: readonly ArrayLike<number>[]): void {
    const data = this.#flags.array;
    for (let i = component; i < data.length; i += 4) data[i] = 0;
    for (const vertices of regions) {
      for (let i = 0; i < vertices.length; ++i) data[4 * vertices[i]! + component] = 255;
    }
    this.#vertices.upload(this.#flags);
  }

  #setPalette(categories: readonly Category[]): void {
    const { palette, hatched } = this.#material.uniforms;
    categories.forEach(({ colour, hatched: striped }, i) => {
      const { r, g, b } = new Color(colour).convertLinearToSRGB();
      (palette!.value as Vector3[])[i]!.set(r, g, b);
      (hatched!.value as number[])[i] = striped ? 1 : 0;
    });
  }

  /** An attribute of the drawn surface, made when it is first asked for. */
  #ensure(name: string, size: number, kind: 'floats' | 'shares'): BufferAttribute {
    const there = this.#drawn.getAttribute(name) as BufferAttribute | undefined;
    if (there) return there;
    const made = this.#vertices.attribute(size, kind);
    this.#drawn.setAttribute(name, made);
    return made;
  }

  #vector2(uniform: string): Vector2 {
    return this.#material.uniforms[uniform]!.value as Vector2;
  }

  /** Draws every edge of the mesh as a hairline, or none. */
  showEdges(shown: boolean): void {
    if (shown && !this.#edges) {
      const { first, neighbours } = this.#adjacency;
      const pairs: number[] = [];
      for (let v = 0; v + 1 < first.length; ++v) {
        for (let k = first[v]!; k < first[v + 1]!; ++k) {
          if (neighbours[k]! > v) pairs.push(v, neighbours[k]!);
        }
      }
      this.#edges = this.#addLines(Uint32Array.from(pairs), 0.22);
    }
    if (this.#edges) this.#edges.visible = shown;
  }

  /** Hairlines between pairs of vertices. */
  #addLines(pairs: Uint32Array, opacity: number) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.#picked.getAttribute('position'));
    geometry.setIndex(new BufferAttribute(pairs, 1));
    const material = new LineBasicMaterial({ color: 0x000000, transparent: true, opacity });
    const lines = new LineSegments(geometry, material);
    lines.renderOrder = 1;
    this.object.add(lines);
    return lines;
  }

  /**
   * Builds the hierarchy that picking needs; until then nothing is picked. Where there are many
   * faces a worker builds it, unless the page allows none. `opening`: calls what makes that worker.
   */
  async prepareToPick(opening: <Made>(make: () => Made) => Made = (make) => make()): Promise<void> {
    const built =
      this.#indices.length / 3 > manyFaces
        ? await this.#buildInWorker(opening).catch(() => undefined)
        : undefined;
    const { MeshBVH } = await import('three-mesh-bvh');
    if (!this.#disposed) this.#hierarchy = built ?? new MeshBVH(this.#picked, hierarchyOptions);
  }

  async #buildInWorker(opening: <Made>(make: () => Made) => Made): Promise<MeshBVH> {
    const [{ MeshBVH }, { GenerateMeshBVHWorker }] = await Promise.all([
      import('three-mesh-bvh'),
      import('three-mesh-bvh/worker'),
    ]);
    const worker = opening(() => new GenerateMeshBVHWorker());
    try {
      // The worker takes the arrays it is given away from this page: hand it copies.
      const copy = new BufferGeometry();
      copy.setAttribute('position', new BufferAttribute(this.#positions.slice(), 3));
      copy.setIndex(new BufferAttribute(this.#indices.slice(), 1));
      const built = MeshBVH.serialize(await worker.generate(copy, hierarchyOptions), {
        cloneBuffers: false,
      });
      return MeshBVH.deserialize(built, this.#picked, { setIndex: false });
    } finally {
      worker.dispose();
    }
  }

  /** Whether what picking needs is there. */
  get canPick(): boolean {
    return this.#hierarchy !== undefined;
  }

  /** Where a ray first meets the surface; undefined where it passes by. */
  pick(ray: Ray): FacePoint | undefined {
    const hit = this.#firstHit(ray);
    // The hierarchy leaves the faces in their order: their numbers are the mesh's own.
    if (!hit || typeof hit.faceIndex !== 'number') return undefined;
    const [a, b, c] = this.#cornersOf(hit.faceIndex).map((vertex) => this.positionOf(vertex));
    return { face: hit.faceIndex, weights: weightsIn(a!, b!, c!, hit.point) };
  }

  /** The corner of a point's face that is nearest to it; the vertex itself where it is one. */
  nearestVertex(point: SurfacePoint): number {
    if (typeof point === 'number') return point;
    const place = this.positionOf(point);
    let nearest = -1;
    let shortest = Infinity;
    for (const vertex of this.#cornersOf(point.face)) {
      const distance = this.positionOf(vertex).distanceToSquared(place);
      if (distance < shortest) [nearest, shortest] = [vertex, distance];
    }
    return nearest;
  }

  /**
   * True where the surface hides a point from the eye, where that is cut away, and as long as it is not known; points on
   * the surface's near side are not hidden. Faces in front of the point by less than `slack` do not count.
   */
  hides(point: Vector3, eye: Vector3, slack = 0.01 * this.bounds.radius): boolean {
    if (!this.#hierarchy || this.section?.cuts(point)) return true;
    const ray = new Ray(eye, point.clone().sub(eye));
    const distance = ray.direction.length();
    ray.direction.divideScalar(distance);
    const hit = this.#firstHit(ray);
    return !!hit && hit.distance < distance - slack;
  }

  #firstHit(ray: Ray) {
    const [near, far] = this.section?.reach(ray) ?? [0, Infinity];
    return this.#hierarchy?.raycastFirst(ray, DoubleSide, near, far);
  }

  /** Touches the cells that the surface covers; `matrix` brings its points into clip space. */
  castOn(silhouette: Silhouette, matrix: ArrayLike<number>, width: number, height: number): void {
    const [positions, indices] = [this.#positions, this.#indices];
    silhouette.cast({ positions, indices, matrix }, width, height);
  }

  /** Calls back with the place of each vertex. */
  eachPosition(see: (x: number, y: number, z: number) => void, about = Infinity): void {
    const positions = this.#positions;
    const step = 3 * Math.max(1, Math.floor(positions.length / 3 / about));
    for (let i = 0; i < positions.length; i += step) {
      see(positions[i]!, positions[i + 1]!, positions[i + 2]!);
    }
  }

  positionOf(point: SurfacePoint): Vector3 {
    if (typeof point === 'number') return new Vector3().fromArray(this.#positions, 3 * point);
    const position = new Vector3();
    this.#cornersOf(point.face).forEach((vertex, k) => {
      position.addScaledVector(this.positionOf(vertex), point.weights[k]!);
    });
    return position;
  }

  /** Away from the inside, at a vertex; at a crease, on one side of it. */
  normalOf(vertex: number): Vector3 {
    return new Vector3().fromBufferAttribute(this.#drawn.getAttribute('normal'), vertex);
  }

  /** Vertices along a way from end to end. */
  longWay(): number[] {
    return longWay(this.#adjacency);
  }

  /** The vertices that share an edge with one. */
  neighboursOf(vertex: number): Uint32Array {
    const { first, neighbours } = this.#adjacency;
    return neighbours.subarray(first[vertex], first[vertex + 1]);
  }

  #cornersOf(face: number): number[] {
    return Array.from(this.#indices.subarray(3 * face, 3 * face + 3));
  }

  dispose(): void {
    this.#disposed = true;
    this.#drawn.dispose();
    this.#picked.dispose();
    this.#material.dispose();
    this.#texture.dispose();
    for (const lines of [this.#edges, this.#boundary]) {
      lines?.geometry.dispose();
      lines?.material.dispose();
    }
    this.#hierarchy = undefined;
    this.object.removeFromParent();
  }
}

/** The ball round the middle of the bounding box. */
function boundsOf(positions: Float32Array): Sphere {
  const middle = new Vector3();
  for (let k = 0; k < 3; ++k) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < positions.length; i += 3) {
      const x = positions[i]!;
      if (x < low) low = x;
      if (x > high) high = x;
    }
    middle.setComponent(k, (low + high) / 2);
  }
  const { x, y, z } = middle;
  let most = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [a, b, c] = [positions[i]! - x, positions[i + 1]! - y, positions[i + 2]! - z];
    const squared = a * a + b * b + c * c;
    if (squared > most) most = squared;
  }
  return new Sphere(middle, Math.sqrt(most));
}
