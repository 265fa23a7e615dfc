/** A leaf on the stage: its parts as any plant's, and on the faces of its blade the veins, down to the finest. */
import { BufferAttribute, Color, Mesh, type MeshStandardMaterial, type PerspectiveCamera, type Texture } from "three";
import type { Bodies } from "../../../../scene/camera_fit";
import type { Figure, FigureMaker, FigureStage, Ray } from "../../../../scene/figure";
import { PartFigure } from "../../../../scene/part_figure";
import type { Leaf } from "../grown";
import { ribColour } from "../parts/blade_colour";
import { FACES, leafParts } from "../parts/leaf_parts";
import type { LeafSpecimen } from "../specimen";
import { veinTexture } from "./vein_texture";

/** Height between the texture's black and white, in thicknesses of the blade: grooves above, ridges below. */
const RELIEF: Readonly<Record<string, number>> = { upper: -0.9, lower: 1.6 };

/** The colour between veins is that of the vertices. */
const VEINED = "diffuseColor.rgb = mix(diffuseColor.rgb, veinColour, 0.72 * texture2D(map, vMapUv).r);";

class LeafFigure implements Figure<LeafSpecimen, Leaf> {
	readonly modes = ["whole"];
	readonly #stage: FigureStage;
	readonly #parts: PartFigure<LeafSpecimen, Leaf>;
	#texture: Texture | undefined;
	/** What the texture shows. */
	#drawn: Leaf | undefined;

	constructor(stage: FigureStage) {
		this.#stage = stage;
		this.#parts = new PartFigure(stage, (grown, { look }) => leafParts(grown, { look }, { veins: false }));
	}

	show(grown: Leaf, specimen: LeafSpecimen): void {
		this.#parts.show(grown, specimen);
		// Other colours leave the veins where they are.
		if (grown !== this.#drawn) {
			this.#texture?.dispose();
			this.#texture = veinTexture(grown, specimen.parameters.length);
			this.#drawn = grown;
		}
		for (const mesh of grown.meshes) {
			const title = FACES[mesh.name]?.title;
			const face = title && this.#stage.root.getObjectByName(title);
			if (face instanceof Mesh && this.#texture) this.#lay(face, mesh.uvs, this.#texture, mesh.name, specimen);
		}
	}

	bounds(): Bodies {
		return this.#parts.bounds();
	}

	prepare(camera: PerspectiveCamera): void {
		this.#parts.prepare(camera);
	}

	pick(ray: Ray): number | undefined {
		return this.#parts.pick(ray);
	}

	mark(picked: number | undefined): void {
		this.#parts.mark(picked);
	}

	setMode(): void {}

	dispose(): void {
		this.#texture?.dispose();
		this.#parts.dispose();
	}

	#lay(face: Mesh, uvs: Float32Array, texture: Texture, name: string, { look, parameters }: LeafSpecimen): void {
		const material = face.material as MeshStandardMaterial;
		face.geometry.setAttribute("uv", new BufferAttribute(uvs, 2));
		material.map = texture;
		const veins = { value: new Color(...ribColour(look)) };
		const lit = material.onBeforeCompile;
		material.onBeforeCompile = (shader, renderer) => {
			lit.call(material, shader, renderer);
			shader.uniforms.veinColour = veins;
			shader.fragmentShader = shader.fragmentShader
				.replace("#include <common>", "#include <common>\nuniform vec3 veinColour;")
				.replace("#include <map_fragment>", "")
				.replace("#include <color_fragment>", `#include <color_fragment>\n${VEINED}`);
		};
		const key = material.customProgramCacheKey();
		material.customProgramCacheKey = () => `${key} veined`;
		material.bumpMap = texture;
		material.bumpScale = (RELIEF[name] * parameters.relief * parameters.thickness) / 1000;
	}
}

export const leafFigure: FigureMaker<LeafSpecimen, Leaf> = (stage) => new LeafFigure(stage);
