// SPDX-License-Identifier: MIT
// The same shader by WebGL 2 itself, three.js and Babylon.js; and the example of docs/portability.md beside a mesh.
import fromFile from "raytorus/raytorus.min.glsl";
import {raytorusMin} from "raytorus";
import {babylonPicture} from "./babylon.js";
import {examplePictures} from "./example.js";
import {plainPicture} from "./plain.js";
import {shader} from "./shader.js";
import {threePicture} from "./three_picture.js";

const size = 256;
const base64 = bytes => btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(""));

async function pictures() {
    const [example, mesh] = examplePictures(size);
    if (!shader.includes(raytorusMin)) throw new Error("the page has another library than the package");
    const imported = plainPicture(shader.replace(raytorusMin, () => fromFile), size);
    const drawn = {plain: plainPicture(shader, size), imported, three: threePicture(shader, size), babylon: await babylonPicture(shader, size),
                   example, mesh};
    const said = Object.fromEntries(Object.entries(drawn).map(([name, bytes]) => [name, base64(bytes)]));
    return {...said, fromFile};
}

pictures().then(result => { window.result = JSON.stringify(result); }, error => { window.result = JSON.stringify({error: String(error.stack)}); });
