import {
	BufferAttribute,
	BufferGeometry,
	Camera,
	type IUniform,
	Mesh,
	Scene,
	ShaderMaterial,
	type WebGLRenderer,
} from "three";

const VERTEX = /* glsl */ `
varying vec2 place;
void main() {
	place = position.xy;
	gl_Position = vec4(position.xy, 1.0, 1.0);
}
`;

export interface FullScreenOptions {
	name: string;
	/** GLSL; `varying vec2 place` is the position, from (−1, −1) at the lower left to (1, 1). */
	fragmentShader: string;
	uniforms: Record<string, IUniform>;
	/** Whether the triangle is drawn behind earlier drawings, else over them. */
	behind?: boolean;
}

/** A triangle that covers the whole target, independent of the camera. */
export class FullScreen {
	readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
	readonly #camera = new Camera();
	#scene: Scene | undefined;

	/** Makes one triangle that covers the view in clip coordinates; it casts no shadow and is never culled. */
	constructor({ name, fragmentShader, uniforms, behind = false }: FullScreenOptions) {
		const geometry = new BufferGeometry();
		geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
		const material = new ShaderMaterial({
			name,
			vertexShader: VERTEX,
			fragmentShader,
			uniforms,
			depthTest: behind,
			depthWrite: false,
			toneMapped: false,
		});
		this.mesh = new Mesh(geometry, material);
		this.mesh.frustumCulled = false;
	}

	/** Uniforms of the fragment shader, by name. */
	get uniforms(): Record<string, IUniform> {
		return this.mesh.material.uniforms;
	}

	/** Draws the triangle alone, over the target's content. */
	draw(renderer: WebGLRenderer): void {
		this.#scene ??= new Scene().add(this.mesh);
		renderer.render(this.#scene, this.#camera);
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.mesh.geometry.dispose();
		this.mesh.material.dispose();
	}
}
