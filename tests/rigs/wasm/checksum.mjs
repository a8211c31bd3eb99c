// node checksum.mjs MODULE.wasm WIDTH HEIGHT SCENE.bin...: the checksum of each.
import { readFileSync } from "node:fs";

const [module, width, height, ...scenes] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(module));
const { memory, room, checksum } = instance.exports;
for (const path of scenes) {
  const scene = readFileSync(path);
  // Memory may grow by this, and is another buffer then.
  const start = room(scene.length);
  new Uint8Array(memory.buffer, start, scene.length).set(scene);
  const sum = checksum(Number(width), Number(height)) >>> 0;
  console.log(sum.toString(16).padStart(8, "0"));
}
