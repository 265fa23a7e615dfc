/** Formats numbers for shaders. */

/** Formats a number as a GLSL float literal: `2` is `2.0`. */
export function float(value: number): string {
	return Number.isInteger(value) ? value.toFixed(1) : String(value);
}

/** Formats three numbers as a GLSL `vec3`. */
export function vec3(values: readonly number[]): string {
	return `vec3(${values.map(float).join(", ")})`;
}

/** Returns the GLSL expression of a smoothstep between two edges; `value` is a GLSL expression. */
export function step(edges: readonly [number, number], value: string): string {
	return `smoothstep(${float(edges[0])}, ${float(edges[1])}, ${value})`;
}
