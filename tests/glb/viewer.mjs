// In the browser: draws each NAME.glb of ?faces=NAME,NAME at rest and smiling, from where face-player looks
// at it, and compares that with what face-player drew.
import * as three from 'three';
import { GLTFLoader } from '/node_modules/three/examples/jsm/loaders/GLTFLoader.js';

const SIZE = 320;  // pixels, as the pictures of face-player
const CELLS = 20;  // across: coarse enough for another light
const AUS = [6, 12];
// portrait_viewpoint() in client/view, in its units.
const UNIT = 0.014;
const TARGET = new three.Vector3(0, 0.6, 2).multiplyScalar(UNIT);
const DISTANCE = 60 * UNIT;
const HALF_HEIGHT = 11 * UNIT;

const canvas = document.createElement('canvas');
document.body.append(canvas);
const renderer = new three.WebGLRenderer({ canvas, alpha: true, preserveDrawingBuffer: true });
renderer.setSize(SIZE, SIZE);
const scene = new three.Scene();
const camera = new three.PerspectiveCamera(
    2 * Math.atan(HALF_HEIGHT / DISTANCE) * three.MathUtils.RAD2DEG, 1, DISTANCE / 10, 2 * DISTANCE);
camera.position.copy(TARGET).add(new three.Vector3(0, 0, DISTANCE));
const key = new three.DirectionalLight(0xffffff, 2);
key.position.set(-1, 1, 2);  // from the subject's right and above
scene.add(key, new three.HemisphereLight(0xffffff, 0x808080, 1.5));

/// Draws the face with the weights that its file itself names for some Action Units. Returns how many of
/// them moved something.
function draw(face, numbers) {
  const weights = new Map();
  for (const { number, targets } of face.scene.userData.aucast.actionUnits) {
    if (!numbers.includes(number)) continue;
    for (const [name, weight] of Object.entries(targets)) {
      weights.set(name, Math.max(weight, weights.get(name) ?? 0));
    }
  }
  const found = new Set();
  face.scene.traverse(({ morphTargetDictionary: index, morphTargetInfluences: influences }) => {
    if (!index) return;
    influences.fill(0);
    for (const [name, weight] of weights) {
      if (!(name in index)) continue;
      influences[index[name]] = weight;
      found.add(name);
    }
  });
  renderer.render(scene, camera);
  return found.size;
}

/// Brightness of each cell, and the share of it that is covered.
function cells(picture) {
  const context = new OffscreenCanvas(SIZE, SIZE).getContext('2d');
  context.drawImage(picture, 0, 0);
  const { data } = context.getImageData(0, 0, SIZE, SIZE);
  const brightness = new Array(CELLS * CELLS).fill(0);
  const cover = new Array(CELLS * CELLS).fill(0);
  const part = (CELLS / SIZE) ** 2;
  for (let i = 0; i < SIZE * SIZE; ++i) {
    const cell = Math.floor(i / SIZE * CELLS / SIZE) * CELLS + Math.floor(i % SIZE * CELLS / SIZE);
    const [r, g, b, a] = data.subarray(4 * i, 4 * i + 4);
    brightness[cell] += part * (r + g + b) / 3 * a / 255;
    cover[cell] += part * a / 255;
  }
  return { brightness, cover };
}

function correlation(a, b) {
  const centred = list => list.map(x => x - sum(list) / list.length);
  const dot = (x, y) => sum(x.map((value, i) => value * y[i]));
  const [x, y] = [centred(a), centred(b)];
  return dot(x, y) / Math.sqrt(dot(x, x) * dot(y, y));
}

const image = async url => createImageBitmap(await (await fetch(url)).blob());
const difference = (a, b) => a.brightness.map((x, i) => Math.abs(x - b.brightness[i]));

const sum = list => list.reduce((total, x) => total + x, 0);

async function compared(name) {
  const face = await new GLTFLoader().loadAsync(`/${name}.glb`);
  scene.add(face.scene);
  const pictures = {};
  const drawn = (as, numbers) => {
    const targets = draw(face, numbers);
    pictures[as] = canvas.toDataURL();
    return { targets, ...cells(canvas) };
  };
  const rest = drawn('rest', []);
  const smile = drawn('smile', AUS);
  scene.remove(face.scene);
  const ours = { rest: cells(await image(`/${name}_rest.png`)), smile: cells(await image(`/${name}_smile.png`)) };
  const change = difference(smile, rest);
  return {
    pictures,
    found: {
      targets: smile.targets,
      cover: sum(smile.cover) / smile.cover.length,
      outline: sum(smile.cover.map((x, i) => Math.min(x, ours.smile.cover[i]))) /
               sum(smile.cover.map((x, i) => Math.max(x, ours.smile.cover[i]))),
      likeness: correlation(smile.brightness, ours.smile.brightness),
      change: Math.max(...change),
      changeLikeness: correlation(change, difference(ours.smile, ours.rest)),
    },
  };
}

const heads = {};
for (const name of new URLSearchParams(location.search).get('faces').split(',')) {
  heads[name] = await compared(name);
}
tell({ heads });
