/** Renderer of plants that stand on the ground, on the paper or outdoors. */
import type { PerspectiveCamera } from "three";
import { type Crown, crownOf } from "../../plant/crown";
import type { Footing } from "../../plant/footing";
import type { Part } from "../../plant/part";
import type { Plant } from "../../plant/plant";
import type { Sway } from "../../plant/sway";
import type { RendererFactory, RendererStage } from "../model_renderer";
import { PartRenderer } from "../part_renderer";
import { type CrownUniforms, crownUniforms } from "../standard_material";
import { outdoorRig } from "./outdoor_light";
import { Scenery } from "./scenery";

/** Functions that give the parts and the placement of a standing plant. */
export interface StandingOptions<S, G> {
	parts: (grown: G, specimen: S) => Iterable<Part>;
	/** Returns how a plant stands; undefined for one that does not. */
	footing: (grown: G) => Footing | undefined;
	/** Returns additional points that the view must contain, metres. */
	room?: (specimen: S) => Float32Array;
	/** Returns a plant's motion in wind. */
	sway?: (grown: G) => Sway | undefined;
}

/** A crown so far below that all leaves on it face up. */
const NO_CROWN: Crown = { centre: [0, -1e6, 0], breadth: 1, height: 1 };

export class StandingRenderer<S, G extends Plant> extends PartRenderer<S, G> {
	readonly samples = 2;
	readonly outdoorRig = outdoorRig;
	readonly #crown: CrownUniforms;
	readonly #scenery: Scenery;
	readonly #footingOf: (grown: G) => Footing | undefined;

	constructor(stage: RendererStage, { parts, footing, room, sway }: StandingOptions<S, G>) {
		const crown = crownUniforms();
		super(stage, parts, room, sway, { onPaper: false, crown });
		this.#crown = crown;
		this.#footingOf = footing;
		this.#scenery = new Scenery(stage);
	}

	/** Height of the ground that the plant stands on, metres. */
	get groundLevel(): number | undefined {
		return this.#scenery.level;
	}

	/** Replaces the drawn plant by another, and places the ground under it. */
	override show(grown: G, specimen: S): void {
		super.show(grown, specimen);
		const { centre, breadth, height } = crownOf(grown) ?? NO_CROWN;
		this.#crown.crownCentre.value.set(...centre);
		this.#crown.crownSize.value.set(breadth, height, breadth);
		this.#scenery.show(this.#footingOf(grown));
	}

	/** Prepares the next frame for a camera: light, shadow, ground and sky. */
	override prepare(camera: PerspectiveCamera): void {
		super.prepare(camera);
		this.#scenery.aim(camera);
	}

	/** Removes everything from the scene and releases its graphics memory. */
	override dispose(): void {
		super.dispose();
		this.#scenery.dispose();
	}
}

/** Returns the renderer of a model whose plants stand on the ground. */
export function standingRenderer<S, G extends Plant>(options: StandingOptions<S, G>): RendererFactory<S, G> {
	return (stage) => new StandingRenderer(stage, options);
}
