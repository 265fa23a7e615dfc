/** Fading between levels of detail: each instance shows only a share of its pixels, and the next level the others. */

/** For vertex shaders. Positive: the share of the pixels that are shown; negative: all but that share. */
export const FADE_DECLARATIONS = /* glsl */ `
attribute float instanceFade;
varying float vFade;
`;

export const FADE_VERTEX = "\nvFade = instanceFade;\n";

/** For fragment shaders, at the beginning of `main`: interleaved gradient noise (Jimenez 2014). */
export const FADE_FRAGMENT = /* glsl */ `
float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
if (vFade >= 0.0 ? grain >= vFade : grain < -vFade) discard;
`;
