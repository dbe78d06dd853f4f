// SPDX-License-Identifier: MIT
import {raytorus, raytorusFast, raytorusFastWgsl, raytorusMin, raytorusWgsl} from "raytorus";

export const texts: string[] = [raytorus, raytorusMin, raytorusFast, raytorusWgsl, raytorusFastWgsl];
// @ts-expect-error There is no other.
import {raytorusSlow} from "raytorus";
// @ts-expect-error Strings are no numbers.
export const length: number = raytorus;
