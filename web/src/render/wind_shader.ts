/** Wind on the stage: the shader code that moves points as plant/point_sway.ts does, and the clock of the wind. */
import { Vector2, Vector3, Vector4 } from "three";
import { BRANCH, FLUTTER, LEAF_ANGLE, PERIOD, PHASE_LAGS, type Sway, TOP_AMPLITUDE } from "../plant/sway";
import { float } from "./glsl";

/** Rate at which the wind rises and falls, per second. */
const RISE = 1.5;

/**
 * For vertex shaders: `vec3 blown(vec3 point, vec3 held)` returns the position of a point of a part attached at
 * `held`; without wind exactly `point`. `swung` does the same for any base point, form (as `windForm`) and beat, for
 * many plants.
 */
export const WIND_CHUNK = /* glsl */ `
uniform vec3 windFoot;
uniform vec4 windForm;
uniform vec2 windBeat;
vec3 swung(vec3 point, vec3 held, vec3 foot, vec4 form, vec2 beat) {
	vec3 d = held - foot;
	float h = clamp(form.x * d.y / form.y, 0.0, 1.0);
	float r = clamp(length(d.xz) / form.z, 0.0, 1.0);
	float bend = ${float(TOP_AMPLITUDE)} * form.y * h * h * (1.5 - 0.5 * h);
	float bob = ${float(BRANCH)} * form.z * r * r * h * (2.0 - h);
	float late = ${float(PHASE_LAGS)} * dot(vec3(0.8, 0.5, 0.6), d) / form.w;
	float c = bob * cos(late), s = bob * sin(late);
	float own = ${float(FLUTTER)} * dot(vec3(1.0, 1.7, 2.3), held) / form.w;
	vec3 o = point - held;
	vec3 turn = ${float(LEAF_ANGLE)} * min(1.0, 8.0 * h) * vec3(-0.8 * o.y, 0.8 * o.x + 0.6 * o.z, -0.6 * o.y);
	float along = bend + c, across = 0.4 * bend + 0.5 * c;
	vec3 sine = vec3(0.8 * along - 0.3 * s, 0.6 * c, 0.6 * along + 0.4 * s) + cos(own) * turn;
	vec3 cosine = vec3(-0.8 * s - 0.6 * across, -0.6 * s, -0.6 * s + 0.8 * across) - sin(own) * turn;
	return point + beat.x * sine + beat.y * cosine;
}
vec3 blown(vec3 point, vec3 held) {
	return windBeat == vec2(0.0) ? point : swung(point, held, windFoot, windForm, windBeat);
}
`;

/** Returns the wind's uniforms, in calm. */
export function windUniforms() {
	return {
		windFoot: { value: new Vector3() },
		/** Direction of growth (1 up, −1 down), height, reach, and the larger of both. */
		windForm: { value: new Vector4(1, 1, 1, 1) },
		/** Sine and cosine of the phase, scaled by the strength; 0 in calm. */
		windBeat: { value: new Vector2() },
	};
}

export type WindUniforms = ReturnType<typeof windUniforms>;

/** The wind on a stage. */
export class Wind {
	/** One object for all materials. */
	readonly uniforms = windUniforms();
	#sway: Sway | undefined;
	#strength = 0;
	#before: number | undefined;
	/** Whether the wind blows, or begins to. */
	blowing = false;

	/** Sets the plant that the wind moves, by its base, growth direction, height and reach; undefined for none. */
	fit(sway: Sway | undefined): void {
		this.#sway = sway;
		if (!sway) return;
		const { foot, up, height, reach } = sway;
		this.uniforms.windFoot.value.fromArray(foot);
		this.uniforms.windForm.value.set(up, height, reach, Math.max(height, reach));
	}

	/** Runs a callback without wind: pictures show plants at rest. */
	calm<Done>(work: () => Done): Done {
		const { value } = this.uniforms.windBeat;
		const beat = value.toArray();
		value.set(0, 0);
		try {
			return work();
		} finally {
			value.fromArray(beat);
		}
	}

	/**
	 * Advances the wind to a time: its strength rises or falls steadily, and its phase turns once per `PERIOD`.
	 * @param now milliseconds
	 * @returns whether anything moves
	 */
	blow(now: number): boolean {
		const seconds = Math.min(0.1, (now - (this.#before ?? now)) / 1000);
		const wanted = this.blowing && this.#sway ? 1 : 0;
		const moves = wanted > 0 || this.#strength > 0;
		this.#before = moves ? now : undefined;
		const step = RISE * seconds;
		this.#strength = Math.max(0, this.#strength + Math.min(step, Math.max(-step, wanted - this.#strength)));
		const angle = (2 * Math.PI * now) / (1000 * PERIOD);
		const eased = this.#strength * this.#strength * (3 - 2 * this.#strength);
		this.uniforms.windBeat.value.set(eased * Math.sin(angle), eased * Math.cos(angle));
		return moves;
	}
}
