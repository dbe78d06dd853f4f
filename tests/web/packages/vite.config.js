// SPDX-License-Identifier: MIT
import glsl from "vite-plugin-glsl";

export default {base: "./", plugins: [glsl()], build: {minify: false, chunkSizeWarningLimit: 1e5}};
