/** The surroundings of a standing plant: its ground, and outdoors the sky. */
import type { PerspectiveCamera } from "three";
import type { Colour } from "../../plant/colour";
import type { Footing } from "../../plant/footing";
import type { Theme } from "../light";
import type { RendererStage } from "../model_renderer";
import { Meadow } from "./meadow";
import { outdoorRig, skyLook } from "./outdoor_light";
import { Sky } from "./sky";

export class Scenery {
	readonly #stage: RendererStage;
	readonly #ground: Meadow;
	/** Made when first needed. */
	#sky: Sky | undefined;
	/** The setting that the ground and the sky are set for. */
	#setFor: Theme | "paper" | undefined;

	readonly #hasPatch: boolean;

	/** @param options.patch whether there is a patch of ground on the paper: not for plants that bring their own */
	constructor(stage: RendererStage, { patch = true }: { patch?: boolean } = {}) {
		this.#stage = stage;
		this.#hasPatch = patch;
		this.#ground = new Meadow(stage.light.uniforms);
		stage.root.add(this.#ground.mesh);
	}

	/** Height of the ground, metres; undefined without a plant that stands on it. */
	get level(): number | undefined {
		return this.#ground.level;
	}

	/**
	 * Places the ground under a plant; undefined for none.
	 * @param own colour of ground that the plants bring
	 */
	show(footing: Footing | undefined, own?: Colour): void {
		this.#ground.show(footing, own);
	}

	/** Updates ground and sky for the next frame. */
	aim(camera: PerspectiveCamera): void {
		const { outdoors, bare, theme } = this.#stage.setting;
		this.#set(outdoors ? theme : "paper");
		this.#ground.aim(camera, !bare && (outdoors || this.#hasPatch));
		if (!this.#sky) return;
		this.#sky.mesh.visible = outdoors && !bare;
		if (this.#sky.mesh.visible) this.#sky.aim(camera);
	}

	/** Sets the colours of the paper's patch, or of the day or the evening outdoors. */
	#set(setting: Theme | "paper"): void {
		if (setting === this.#setFor) return;
		this.#setFor = setting;
		if (setting === "paper") {
			this.#ground.setOutdoors(undefined);
			return;
		}
		const look = skyLook(setting);
		this.#ground.setOutdoors({ grass: look.grass, haze: look.near });
		if (!this.#sky) {
			this.#sky = new Sky();
			this.#stage.root.add(this.#sky.mesh);
		}
		this.#sky.setLook(look, outdoorRig(setting).key.direction);
	}

	/** Removes ground and sky from the scene and releases their graphics memory. */
	dispose(): void {
		this.#ground.dispose();
		this.#sky?.mesh.removeFromParent();
		this.#sky?.dispose();
	}
}
