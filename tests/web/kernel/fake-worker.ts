// A worker that answers at once or when told to, without a thread and without WebAssembly.

import type {
  FieldRequest,
  Reply,
  Report,
  Request,
} from '../../../web/src/kernel/types/protocol.js';
import type { WorkerLike } from '../../../web/src/kernel/page/worker-client.js';

/** The behaviour of a fake for a request: its answer, or a promise of it. A thrown error is answered too. */
export type Behaviour = (
  request: Request,
  report: (report: Report) => void,
) => object | Promise<object>;

export class FakeWorker implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  terminated = false;
  /** Requests in the order in which they arrived. */
  readonly requests: Request[] = [];
  readonly #behaviour: Behaviour;
  #last: Promise<void> = Promise.resolve();

  constructor(behaviour: Behaviour) {
    this.#behaviour = behaviour;
  }

  /** The operations of the requests. */
  get operations(): string[] {
    return this.requests.map(({ operation }) => operation);
  }

  postMessage(request: Request): void {
    this.requests.push(request);
    this.#last = this.#last.then(() => this.#serve(request));
  }

  terminate(): void {
    this.terminated = true;
  }

  crash(message: string): void {
    this.onerror?.({ message } as ErrorEvent);
  }

  async #serve(request: Request): Promise<void> {
    const { id } = request;
    const reply = (data: Reply) => this.onmessage?.({ data } as MessageEvent<Reply>);
    try {
      reply({ id, answer: await this.#behaviour(request, (report) => reply({ id, report })) });
    } catch (thrown) {
      const { code = 'INTERNAL', message = '' } = thrown as { code?: string; message?: string };
      reply({ id, error: { code, element: -1, message, hint: '' }, fatal: code === 'INTERNAL' });
    }
  }
}

/** I(v) of the fakes: any function that tells the vertices apart. */
export const fakeValue = (vertex: number) => Math.sqrt(vertex + 1);

/** The thickness of the fakes: the first vertex has none. */
export const fakeThickness = (vertex: number) => (vertex === 0 ? NaN : 1 / vertex);

/** A surface of `count` vertices as the fakes answer about it. */
export function fakeSurface(count: number): Behaviour {
  const opened = () => ({
    info: { name: '', vertexCount: count, faceCount: count, unit: 'metre' },
    arrays: { positions: new Float64Array(3 * count), indices: new Uint32Array(3) },
    origin: [0, 0, 0],
    drawn: new Float32Array(3 * count),
    boundary: new Uint32Array(0),
    vertexOfInput: new Uint32Array(count),
    inputOfVertex: new Uint32Array(count),
    content: {
      faceCount: count,
      inputOfFace: new Uint32Array(count),
      attributes: [],
      rowOfCorner: new Uint32Array(0),
      values: new Float64Array(0),
    },
  });
  return ({ operation, arguments: args }, report) => {
    switch (operation) {
      case 'order':
        // Even vertices first, then odd ones.
        return {
          order: Uint32Array.from({ length: count }, (_, i) =>
            2 * i < count ? 2 * i : 2 * (i - Math.ceil(count / 2)) + 1,
          ),
        };
      case 'values': {
        const { field, vertices } = args as { field: FieldRequest; vertices: Uint32Array };
        const isGirth = field.name === 'igf';
        return {
          values: Float64Array.from(vertices, isGirth ? fakeValue : fakeThickness),
          kinds: Uint8Array.from(isGirth ? vertices : [], (v) => v % 2),
          milliseconds: 1,
        };
      }
      case 'about': {
        const { field, withoutValue } = args as { field: FieldRequest; withoutValue: number };
        return {
          method: `${field.name} by fakes`,
          note: withoutValue > 0 ? 'some are missing' : '',
        };
      }
      case 'spectralField':
        report({ progress: 0.5 });
        return {
          values: Float64Array.from({ length: count }, (_, v) => fakeValue(v)),
          method: 'by fakes',
        };
      case 'carryBack': {
        const { values, kinds } = args as { values: Float64Array; kinds: Uint8Array };
        return { values, kinds };
      }
      case 'heatMaxima':
      case 'maxima':
        return { maxima: [{ vertex: 1, value: 2, persistence: 2, saddle: -1 }] };
      case 'parts':
        return { kinds: new Uint8Array(count), partOf: new Uint32Array(count), parts: [] };
      case 'path':
        return { length: 1, straight: 1, polyline: new Float32Array(6) };
      case 'printCheck':
        return { places: [], creases: [], failingShare: 0, passingScale: 0 };
      case 'tips':
        return { tips: [], arcs: [], crossedEdges: 0, linePoints: new Float64Array(0) };
      case 'writeFields':
      case 'writeFound':
        return { bytes: new Uint8Array(1) };
      case 'writeLoops':
        return { files: [new Uint8Array(1)] };
      case 'loop':
        return { length: 1, points: new Float64Array(8), polyline: new Float32Array(6) };
      case 'take':
      case 'read':
        return opened();
      case 'remesh':
        return { opened: opened() };
      default:
        return {};
    }
  };
}
