/** Formats numbers for shaders. */

/** A float: `2` is `2.0`. */
export function float(value: number): string {
	return Number.isInteger(value) ? value.toFixed(1) : String(value);
}

export function vec3(values: readonly number[]): string {
	return `vec3(${values.map(float).join(", ")})`;
}

/** GLSL's smoothstep between two edges. */
export function step(edges: readonly [number, number], value: string): string {
	return `smoothstep(${float(edges[0])}, ${float(edges[1])}, ${value})`;
}
