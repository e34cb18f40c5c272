// Which emotion two networks see in pictures.
//   emotions.mjs WIDTH HEIGHT < rgb24 > CSV: picture,network,score,neutral,happiness,...
// A picture in which a network finds no face has no row of it.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const need = createRequire(import.meta.url);
const modules = path.join(import.meta.dirname, 'node_modules');
const wasmFiles = path.join(modules, '@tensorflow/tfjs-backend-wasm/dist/');
const [width, height] = process.argv.slice(2).map(Number);

// How the networks call what the six emotions and rest are called here.
const EMOTIONS = {
  neutral: ['neutral'],
  happiness: ['happy'],
  sadness: ['sad'],
  anger: ['angry'],
  fear: ['fearful', 'fear'],
  disgust: ['disgusted', 'disgust'],
  surprise: ['surprised', 'surprise'],
};

/// face-api: {score, of(word)}, or null without a face.
async function faceApi() {
  need('@tensorflow/tfjs');
  need('@tensorflow/tfjs-backend-wasm').setWasmPaths(wasmFiles);
  const api = need('@vladmandic/face-api/dist/face-api.node-wasm.js');
  await api.tf.setBackend('wasm');
  await api.tf.ready();
  const models = path.join(modules, '@vladmandic/face-api/model');
  for (const net of ['ssdMobilenetv1', 'faceLandmark68Net', 'faceExpressionNet']) {
    await api.nets[net].loadFromDisk(models);
  }
  const options = new api.SsdMobilenetv1Options({ minConfidence: 0.1, maxResults: 1 });
  return async rgb => {
    const tensor = api.tf.tensor3d(rgb, [height, width, 3], 'int32');
    const found = await api.detectSingleFace(tensor, options).withFaceLandmarks().withFaceExpressions();
    tensor.dispose();
    return found && { score: found.detection.score, of: word => found.expressions[word] };
  };
}

async function human() {
  // Its build for Node reads its models by fetch, which knows no files.
  const fetched = globalThis.fetch;
  globalThis.fetch = async (url, options) =>
    String(url).startsWith('file://') ? new Response(readFileSync(new URL(url))) : fetched(url, options);
  const off = { enabled: false };
  const always = { skipFrames: 0, skipTime: 0 };
  const { Human } = need(path.join(modules, '@vladmandic/human/dist/human.node-wasm.js'));
  const net = new Human({
    backend: 'wasm', debug: false, cacheSensitivity: 0, validateModels: false, wasmPath: wasmFiles,
    modelBasePath: `file://${path.join(modules, '@vladmandic/human/models/')}`,
    filter: off, gesture: off, body: off, hand: off, object: off, segmentation: off,
    face: {
      enabled: true,
      detector: { enabled: true, rotation: false, maxDetected: 1, minConfidence: 0.1, ...always },
      mesh: { enabled: true }, iris: off, description: off, antispoof: off, liveness: off,
      emotion: { enabled: true, minConfidence: 0, ...always },
    },
  });
  await net.load();
  return async rgb => {
    const tensor = net.tf.tensor4d(rgb, [1, height, width, 3], 'float32');
    const [face] = (await net.detect(tensor)).face;
    net.tf.dispose(tensor);
    if (!face?.emotion) return null;
    return { score: face.boxScore ?? face.score,
             of: word => face.emotion.find(one => one.emotion === word)?.score };
  };
}

/// Pieces of a stream as whole pictures.
async function* pictures(stream) {
  const size = width * height * 3;
  let kept = [];
  let length = 0;
  for await (let piece of stream) {
    while (length + piece.length >= size) {
      const rest = size - length;
      yield new Uint8Array(Buffer.concat([...kept, piece.subarray(0, rest)]));
      piece = piece.subarray(rest);
      kept = [];
      length = 0;
    }
    kept.push(piece);
    length += piece.length;
  }
  if (length > 0) throw new Error(`the last picture is cut off: ${length} bytes of ${size}`);
}

const networks = { 'face-api': await faceApi(), human: await human() };
console.log(['picture', 'network', 'score', ...Object.keys(EMOTIONS)].join());
let picture = 0;
for await (const rgb of pictures(process.stdin)) {
  for (const [name, look] of Object.entries(networks)) {
    const seen = await look(rgb);
    if (!seen) continue;
    const sure = Object.values(EMOTIONS).map(words => words.map(seen.of).find(p => p !== undefined) ?? 0);
    console.log([picture, name, seen.score.toFixed(3), ...sure.map(p => p.toFixed(4))].join());
  }
  ++picture;
}
