/** The sky outdoors, with clouds and hills at the horizon. */
import { Matrix3, type Mesh, type PerspectiveCamera, Vector2, Vector3 } from "three";
import { linear } from "../../plant/colour";
import { NOISE_CHUNK } from "../../plant/noise";
import { FullScreen } from "../full_screen";
import type { SkyLook } from "./outdoor_light";

/**
 * Colour of a direction: the horizon's colour fades towards the zenith, with a glow about the sun, clouds in a plane
 * over the viewer, and two chains of hills, of which the far one is paler (haze).
 */
const FRAGMENT = /* glsl */ `
varying vec2 place;
uniform vec2 sight;
uniform mat3 toWorld;
uniform vec3 sun;
uniform vec3 horizon;
uniform vec3 zenith;
uniform vec3 glow;
uniform vec3 cloud;
uniform vec3 farHills;
uniform vec3 nearHills;
${NOISE_CHUNK}
// Height of a chain of hills over the horizon in an azimuth, as a tangent; x runs around the viewer.
float hills(float turn, float high, float seed) {
	float broad = noise(vec3(7.0 * turn, seed, 0.0)) - 0.3;
	float fine = noise(vec3(90.0 * turn, seed, 3.0)) + 0.5 * noise(vec3(260.0 * turn, seed, 5.0));
	return high * (broad + 0.10 * fine);
}
void main() {
	vec3 d = normalize(toWorld * vec3(sight * place, -1.0));
	float up = max(d.y, 0.0);
	vec3 colour = mix(zenith, horizon, exp(-4.0 * up));
	float facing = max(0.0, dot(d, sun));
	colour += glow * (0.12 * pow(facing, 6.0) + 0.35 * pow(facing, 90.0));
	if (d.y > 0.02) {
		vec2 over = d.xz / (d.y + 0.2);
		float thick = 0.5 * noise(vec3(1.3 * over, 1.0)) + 0.25 * noise(vec3(3.1 * over.yx, 2.0)) + 0.15 * noise(vec3(7.3 * over, 3.0)) + 0.10 * noise(vec3(17.0 * over.yx, 4.0));
		float share = smoothstep(0.5, 0.78, thick) * smoothstep(0.02, 0.2, d.y);
		colour = mix(colour, cloud, 0.7 * share);
	}
	float turn = atan(d.x, d.z);
	float rise = d.y / length(d.xz);
	// One pixel of the silhouette's edge is mixed, so that it is not jagged.
	float pixel = max(fwidth(rise), 1e-5);
	float distant = hills(turn, 0.030, 11.0), close = hills(turn + 0.4, 0.016, 23.0);
	colour = mix(colour, mix(horizon, farHills, 0.75), clamp((distant - rise) / pixel + 0.5, 0.0, 1.0));
	colour = mix(colour, nearHills, clamp((close - rise) / pixel + 0.5, 0.0, 1.0));
	gl_FragColor = vec4(colour, 1.0);
	#include <colorspace_fragment>
}
`;

/** The picture of the sky behind everything; not tone-mapped, like the paper. */
export class Sky {
	readonly #screen = new FullScreen({
		name: "sky",
		fragmentShader: FRAGMENT,
		uniforms: {
			sight: { value: new Vector2(1, 1) },
			toWorld: { value: new Matrix3() },
			sun: { value: new Vector3(0, 1, 0) },
			horizon: { value: new Vector3() },
			zenith: { value: new Vector3() },
			glow: { value: new Vector3() },
			cloud: { value: new Vector3() },
			farHills: { value: new Vector3() },
			nearHills: { value: new Vector3() },
		},
		behind: true,
	});

	constructor() {
		// Drawn after the plant, so that the depth test skips covered pixels; before transparent ground.
		this.mesh.renderOrder = 2;
	}

	/** The triangle behind the plant. */
	get mesh(): Mesh {
		return this.#screen.mesh;
	}

	/** Sets the colours and the direction towards the sun. */
	setLook(look: SkyLook, sun: Vector3): void {
		const { uniforms } = this.#screen;
		uniforms.sun.value.copy(sun);
		const colours = { ...look, farHills: look.far, nearHills: look.near };
		for (const name of ["horizon", "zenith", "glow", "cloud", "farHills", "nearHills"] as const)
			uniforms[name].value.fromArray(linear(colours[name]));
	}

	/** Shows the sky as a camera sees it. */
	aim({ fov, aspect, matrixWorld }: PerspectiveCamera): void {
		const { sight, toWorld } = this.#screen.uniforms;
		const up = Math.tan((fov * Math.PI) / 360);
		sight.value.set(up * aspect, up);
		toWorld.value.setFromMatrix4(matrixWorld);
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.#screen.dispose();
	}
}
