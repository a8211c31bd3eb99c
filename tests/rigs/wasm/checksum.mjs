// Prints the picture checksum of each compiled scene:
//   node checksum.mjs MODULE.wasm WIDTH HEIGHT SCENE.bin...
import { readFileSync } from "node:fs";

const [module, width, height, ...scenes] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(module));
const { memory, reserve, checksum } = instance.exports;
for (const path of scenes) {
  const scene = readFileSync(path);
  // `reserve` may grow the memory, which replaces `memory.buffer`: call it first.
  const start = reserve(scene.length);
  new Uint8Array(memory.buffer, start, scene.length).set(scene);
  const sum = checksum(Number(width), Number(height)) >>> 0;
  console.log(sum.toString(16).padStart(8, "0"));
}
