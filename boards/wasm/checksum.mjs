// node checksum.mjs MODULE.wasm WIDTH HEIGHT SCENE.bin...: the checksum of each.
import { readFileSync } from "node:fs";

const [module, width, height, ...scenes] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(module));
const { memory, room, checksum } = instance.exports;
for (const path of scenes) {
  const scene = readFileSync(path);
  new Uint8Array(memory.buffer, room(scene.length), scene.length).set(scene);
  const sum = checksum(Number(width), Number(height)) >>> 0;
  console.log(sum.toString(16).padStart(8, "0"));
}
