import {
	type BufferGeometry,
	CustomBlending,
	DoubleSide,
	InstancedMesh,
	type Material,
	MaxEquation,
	Mesh,
	OneFactor,
	ShaderMaterial,
} from "three";
import type { PaperShadow } from "./paper_shadow";
import { WIND_CHUNK, type WindUniforms, windUniforms } from "./wind_shader";

const VERTEX = /* glsl */ `
uniform float paper;
uniform vec3 lamp;
varying float way;
${WIND_CHUNK}
void main() {
	vec4 point = vec4(position, 1.0);
	vec3 held = position;
	#ifdef USE_INSTANCING
		point = instanceMatrix * point;
		held = instanceMatrix[3].xyz;
	#endif
	vec3 from = (modelViewMatrix * vec4(blown(point.xyz, held), 1.0)).xyz;
	way = max(0.0, from.z - paper) / lamp.z;
	gl_Position = projectionMatrix * vec4(from.xy - lamp.xy * way, paper, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
uniform float paper;
varying float way;
void main() {
	gl_FragColor = vec4(1.0, min(1.0, -2.0 * way / paper), 0.0, 1.0);
}
`;

/** Hard shadow of meshes on the paper, as from a point light; `PaperShadow` softens it. */
export class MeshShadow {
	readonly #cast: Mesh[] = [];
	readonly #shadow: PaperShadow;
	readonly #blown: ShaderMaterial;
	readonly #still: ShaderMaterial;

	constructor(shadow: PaperShadow, wind: WindUniforms) {
		this.#shadow = shadow;
		this.#blown = castingMaterial(shadow, wind);
		this.#still = castingMaterial(shadow, windUniforms());
	}

	/**
	 * Replaces the meshes that cast the shadow. The caller still owns the meshes.
	 * @param blown returns whether wind moves parts of a material
	 */
	set(meshes: readonly Mesh<BufferGeometry, Material>[], blown: (material: Material) => boolean = () => true): void {
		this.#clear();
		for (const mesh of meshes) {
			const cast = shadowMesh(mesh, blown(mesh.material) ? this.#blown : this.#still);
			cast.frustumCulled = false;
			this.#shadow.hard.add(cast);
			this.#cast.push(cast);
		}
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.#clear();
		this.#blown.dispose();
		this.#still.dispose();
	}

	/** Removes all casting meshes from the scene of the shadow. */
	#clear(): void {
		for (const cast of this.#cast) cast.removeFromParent();
		this.#cast.length = 0;
	}
}

/** Creates the material that draws meshes into the shadow texture: the greatest value wins where meshes overlap. */
function castingMaterial(shadow: PaperShadow, wind: WindUniforms): ShaderMaterial {
	return new ShaderMaterial({
		name: "mesh-shadow",
		vertexShader: VERTEX,
		fragmentShader: FRAGMENT,
		uniforms: { ...shadow.uniforms, ...wind },
		side: DoubleSide,
		blending: CustomBlending,
		blendEquation: MaxEquation,
		blendSrc: OneFactor,
		blendDst: OneFactor,
		depthTest: false,
		depthWrite: false,
		toneMapped: false,
	});
}

/** Returns a mesh with the same geometry and instances, and another material. */
function shadowMesh(mesh: Mesh | InstancedMesh, material: ShaderMaterial): Mesh {
	if (!(mesh instanceof InstancedMesh)) return new Mesh(mesh.geometry, material);
	const shared = new InstancedMesh(mesh.geometry, material, 0);
	shared.instanceMatrix = mesh.instanceMatrix;
	shared.count = mesh.count;
	shared.boundingSphere = mesh.boundingSphere;
	return shared;
}
