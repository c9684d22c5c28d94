// Projects of the page: what it shows as one file, and such a file as what is to be shown. It is fetched when it is first
// needed.

import { type FileWithPath, GirthError, type MeshSource, readZip } from '../../src/kernel/index.js';
import { type GirthViewer, fieldNames } from '../../src/element/index.js';
import { type PageState, spectralIn } from '../state/address-state.js';
import type { ComputedFields } from './computed-fields.js';
import { type SavedProject, readProject, writeProject } from './project-file.js';
import type { Opened } from './session.js';

/** A project of what is shown: its model's files and all fields and loops that are there. */
export async function projectOf(
  viewer: GirthViewer,
  { source, model }: Opened,
  state: PageState,
  computed: ComputedFields,
): Promise<Uint8Array> {
  const name = state.file ?? viewer.info!.name;
  const names = fieldNames.filter((one) => computed.has(one));
  const [files, fields] = await Promise.all([
    filesOf(source, name),
    Promise.all(names.map((one) => viewer.fieldOf(one))),
  ]);
  const loops = viewer.pinned.map(({ loop }) => loop);
  return writeProject({ name, files, model, state }, viewer.geometry, { fields, loops });
}

/** A project that is to be shown. */
export interface OpenedProject extends Pick<SavedProject, 'name' | 'model' | 'state'> {
  source: File | FileWithPath[];
  /**
   * Hands what was computed to the surface that is shown, if it is that one: fields at once, loops when they are pinned.
   * Errors: MALFORMED_FILE, LIMIT_EXCEEDED.
   */
  adopt: (viewer: GirthViewer) => Promise<void>;
}

/** The project in a zip; undefined where there is none, and where the zip cannot be read. Errors: as of `readProject`. */
export async function projectIn(file: File | FileWithPath): Promise<OpenedProject | undefined> {
  const content = file instanceof File ? file : file.content;
  const project = readProject(new Uint8Array(await content.arrayBuffer()));
  if (!project) return undefined;
  return {
    ...project,
    source: sourceOf(project),
    adopt: async (viewer) => {
      const results = project.resultsFor(viewer.geometry);
      for (const field of results?.fields ?? [])
        viewer.adopt(field, spectralIn(project.state, field.name));
      for (const loop of results?.loops ?? []) await viewer.pin(loop);
    },
  };
}

/** A project's model, as it is opened. */
function sourceOf({ files }: SavedProject): File | FileWithPath[] {
  const [first] = files;
  if (files.length > 1 || !first) return [...files];
  return new File([first.content], first.path.slice(first.path.lastIndexOf('/') + 1));
}

/** The files that a model was read from: those in a zip one by one. */
async function filesOf(source: MeshSource, name: string): Promise<FileWithPath[]> {
  if (typeof source === 'string' || source instanceof URL) {
    const response = await fetch(source);
    const content = await response.blob();
    if (/"uri"\s*:\s*"(?!data:)/.test(/\.gltf$/i.test(name) ? await content.text() : '')) {
      throw new GirthError({
        ...{ code: 'MISSING_RESOURCE', element: -1 },
        message: 'the model has more files than its address names',
        hint: 'open these files here, and save the project then',
      });
    }
    return [{ path: shownPath(name), content }];
  }
  const given = (Array.isArray(source) ? source : [source]) as (File | FileWithPath)[];
  const files = given.map((file) =>
    file instanceof File
      ? { path: shownPath(file.webkitRelativePath || file.name), content: file }
      : { ...file, path: shownPath(file.path) },
  );
  const [first] = files;
  if (files.length > 1 || !first || !/\.zip$/i.test(first.path)) return files;
  const archive = new Uint8Array(await first.content.arrayBuffer());
  return readZip(archive).map((inner) => ({
    path: inner.path,
    content: new Blob([inner.bytes()]),
  }));
}

/** Names that begin with a full stop would be hidden in a zip. */
const shownPath = (path: string): string => path.replace(/(^|\/)\.+/g, '$1');
