import {
	CustomBlending,
	DoubleSide,
	InstancedMesh,
	Mesh,
	MinEquation,
	OneFactor,
	ShaderMaterial,
	Vector2,
	Vector4,
} from "three";
import type { PaperShadow } from "./paper_shadow";

/** Places on the lamp's disc from which the shadow is thrown, one for each channel of the target. */
const SAMPLES = [
	[0.5, 0.2],
	[-0.2, 0.5],
	[-0.5, -0.2],
	[0.2, -0.5],
] as const;

const VERTEX = /* glsl */ `
uniform float paper;
uniform vec3 lamp;
uniform float spread;
uniform vec2 place;
void main() {
	vec4 point = vec4(position, 1.0);
	#ifdef USE_INSTANCING
		point = instanceMatrix * point;
	#endif
	vec3 from = (modelViewMatrix * point).xyz;
	vec3 towards = lamp + spread * vec3(place, 0.0);
	vec2 landing = from.xy - towards.xy * (max(0.0, from.z - paper) / towards.z);
	gl_Position = projectionMatrix * vec4(landing, paper, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
uniform vec4 left;
void main() {
	gl_FragColor = left;
}
`;

/** The shadow of any meshes: thrown flat on the paper from four places of the lamp, which soften it as it comes far. */
export class MeshShadow {
	readonly #materials: ShaderMaterial[];
	readonly #cast: Mesh[] = [];
	readonly #shadow: PaperShadow;

	constructor(shadow: PaperShadow) {
		this.#shadow = shadow;
		this.#materials = SAMPLES.map(
			([x, y], channel) =>
				new ShaderMaterial({
					name: "mesh-shadow",
					vertexShader: VERTEX,
					fragmentShader: FRAGMENT,
					uniforms: {
						...shadow.uniforms,
						place: { value: new Vector2(x, y) },
						left: { value: new Vector4(1, 1, 1, 1).setComponent(channel, 0) },
					},
					side: DoubleSide,
					blending: CustomBlending,
					blendEquation: MinEquation,
					blendSrc: OneFactor,
					blendDst: OneFactor,
					depthTest: false,
					depthWrite: false,
					toneMapped: false,
				}),
		);
	}

	/** What casts, in place of the last; the meshes stay whose they are. */
	lay(meshes: readonly (Mesh | InstancedMesh)[]): void {
		this.#clear();
		for (const mesh of meshes) {
			for (const material of this.#materials) {
				const cast = sharing(mesh, material);
				cast.frustumCulled = false;
				this.#shadow.root.add(cast);
				this.#cast.push(cast);
			}
		}
	}

	dispose(): void {
		this.#clear();
		for (const material of this.#materials) material.dispose();
	}

	#clear(): void {
		for (const cast of this.#cast) cast.removeFromParent();
		this.#cast.length = 0;
	}
}

/** The same geometry at the same places, of another material. */
function sharing(mesh: Mesh | InstancedMesh, material: ShaderMaterial): Mesh {
	if (!(mesh instanceof InstancedMesh)) return new Mesh(mesh.geometry, material);
	const shared = new InstancedMesh(mesh.geometry, material, 0);
	shared.instanceMatrix = mesh.instanceMatrix;
	shared.count = mesh.count;
	shared.boundingSphere = mesh.boundingSphere;
	return shared;
}
