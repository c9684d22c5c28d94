// A glTF document of one surface that Draco has packed.

/** So many bytes of packed data in the first buffer, which unpack to so many points and corners of faces. */
export const dracoDocument = (length: number, points: number, corners: number) => ({
  asset: { version: '2.0' },
  buffers: [{ byteLength: length }],
  bufferViews: [{ buffer: 0, byteLength: length }],
  accessors: [
    { componentType: 5126, count: points, type: 'VEC3' },
    { componentType: 5125, count: corners, type: 'SCALAR' },
  ],
  meshes: [
    {
      primitives: [
        {
          attributes: { POSITION: 0 },
          indices: 1,
          extensions: {
            KHR_draco_mesh_compression: { bufferView: 0, attributes: { POSITION: 0 } },
          },
        },
      ],
    },
  ],
});
