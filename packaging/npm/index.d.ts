// SPDX-License-Identifier: MIT
/** GLSL from 3.30 and GLSL ES from 3.00, with its documentation in comments: the text of raytorus.glsl. */
export const raytorus: string;
/** The same, stripped: the text of raytorus.min.glsl. */
export const raytorusMin: string;
/** The fast tier's nearest hit, as one function of GLSL: the text of raytorus_fast.glsl. */
export const raytorusFast: string;
/** WGSL, the exact tier: the text of raytorus.wgsl. */
export const raytorusWgsl: string;
/** WGSL, the fast tier: the text of raytorus_fast.wgsl. */
export const raytorusFastWgsl: string;
