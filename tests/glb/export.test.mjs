import { test } from 'node:test';
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import validator from 'gltf-validator';

const root = path.resolve(import.meta.dirname, '../..');
const player = path.join(process.env.AUCAST_BIN ?? path.join(root, 'build/release/bin'), 'face-player');
const talk = path.join(root, 'data/streams/talk.txt');
const MB = 1e6;
const JSON_BEGINS = 20;  // after the header of the file and that of the chunk, whose length is at 12

function documentOf(bytes) {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  return JSON.parse(new TextDecoder().decode(bytes.subarray(JSON_BEGINS, JSON_BEGINS + length)));
}

const cases = [
  { name: 'a face and its animation', options: [talk] },
  { name: 'the other face alone', options: ['--face', 'marek'], size: 3.5 * MB },
  { name: 'a face alone', options: [], size: 3.5 * MB },
  { name: 'Action Units with their animation', options: [talk, '--basis', 'aus', '--idle', '1'] },
];

for (const { name, options, size } of cases) {
  test(name, async () => {
    const folder = mkdtempSync(path.join(os.tmpdir(), 'aucast-glb-'));
    try {
      const file = path.join(folder, 'face.glb');
      execFileSync(player, ['export', ...options, file], { stdio: 'pipe' });
      const bytes = new Uint8Array(readFileSync(file));
      const report = await validator.validateBytes(bytes);
      const { numErrors, numWarnings, messages } = report.issues;
      const said = JSON.stringify(messages.filter(one => one.severity < 2).slice(0, 5), null, 1);
      assert.equal(numErrors, 0, said);
      assert.equal(numWarnings, 0, said);
      assert.equal(report.info.version, '2.0');
      if (size) assert.ok(bytes.length <= size, `${bytes.length} bytes`);
      const { meshes, accessors } = documentOf(bytes);
      for (const lit of ['skin', 'mouth']) {
        const { targets } = meshes.find(mesh => mesh.name === lit).primitives[0];
        const turned = targets.filter(({ NORMAL }) => accessors[NORMAL].sparse);
        assert.ok(turned.length > targets.length / 4, `${lit}: light follows ${turned.length} targets`);
      }
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
}
