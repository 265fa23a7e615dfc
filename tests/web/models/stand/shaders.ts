/**
 * Helpers for tests of a stand's shaders: a material's shader program as three receives it, and evaluation of its
 * arithmetic.
 */
import { type MeshStandardMaterial, ShaderLib, type WebGLProgramParametersWithUniforms } from "three";

export interface Program {
	readonly vertexShader: string;
	readonly fragmentShader: string;
	readonly uniforms: Record<string, { value: unknown }>;
}

export function programOf(material: MeshStandardMaterial): Program {
	const { vertexShader, fragmentShader } = ShaderLib.standard;
	const shader = { vertexShader, fragmentShader, uniforms: {} };
	material.onBeforeCompile(shader as unknown as WebGLProgramParametersWithUniforms, undefined as never);
	return shader;
}

/** The part of a shader from one text, inclusive, to another. */
export function piece(shader: string, from: string, to: string): string {
	const start = shader.indexOf(from);
	const end = shader.indexOf(to, start);
	if (start < 0 || end < 0 || shader.indexOf(from, start + 1) >= 0) throw new Error(`There is not one ${from} … ${to}`);
	return shader.slice(start, end);
}

const clamp = (value: number, low: number, high: number) => Math.min(high, Math.max(low, value));
/** Built-in functions in one dimension, where vectors and matrices are numbers. */
const BUILT_IN = {
	...{ clamp, min: Math.min, max: Math.max, length: Math.abs },
	dot: (a: number, b: number) => a * b,
	mat3: (of: number | readonly { xyz: number }[]) => (typeof of === "number" ? of : of[0].xyz),
	smoothstep: (low: number, high: number, value: number) => {
		const t = clamp((value - low) / (high - low), 0, 1);
		return t * t * (3 - 2 * t);
	},
};

/** Runs a part of a shader as a script without types; it may change its inputs. */
export function run(text: string, given: Record<string, unknown>): void {
	const script = text.replace(/\b(float|vec3) (\w+) =/g, "let $2 =");
	const all = { ...BUILT_IN, ...given };
	new Function(...Object.keys(all), script)(...Object.values(all));
}
