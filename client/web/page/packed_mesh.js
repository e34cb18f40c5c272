// A mesh as it was, out of what scripts/web_page.py made of it for the way: the same numbers in an order
// that gzip makes a third of.

/// Each byte was written as its difference from the one before.
function undoDifferences(bytes) {
  for (let at = 1; at < bytes.length; ++at) bytes[at] += bytes[at - 1];
}

/// The file's bytes, out of: five numbers; its head; byte 0 of all vertices, byte 1, ...; how many corners
/// each face has; byte 0 of all corners' steps, byte 1, ...
export function unpackMesh(packed) {
  const [headSize, vertices, stride, faces, corners] =
      new Uint32Array(packed.slice(0, 20).buffer);
  let from = 20;
  const take = count => packed.slice(from, from += count);
  const mesh = new Uint8Array(headSize + vertices * stride + faces + 4 * corners);
  mesh.set(take(headSize));
  let to = headSize;
  for (let column = 0; column < stride; ++column) {
    const plane = take(vertices);
    undoDifferences(plane);
    for (let row = 0, at = to + column; row < vertices; ++row, at += stride) mesh[at] = plane[row];
  }
  to += vertices * stride;
  const sizes = take(faces);
  const planes = [0, 1, 2, 3].map(() => take(corners));
  let vertex = 0;
  let corner = 0;
  for (const size of sizes) {
    mesh[to++] = size;
    for (const last = corner + size; corner < last; ++corner) {
      for (let byte = 0; byte < 4; ++byte) vertex += planes[byte][corner] << (8 * byte);
      for (let byte = 0; byte < 4; ++byte) mesh[to++] = vertex >> (8 * byte);
      vertex |= 0;
    }
  }
  return mesh;
}
