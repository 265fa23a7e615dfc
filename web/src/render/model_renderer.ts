/** A plant as it stands on the stage. Where parts are all there is to say of a model, `partRenderer` is its figure. */
import type { Object3D, PerspectiveCamera } from "three";
import type { Sway } from "../plant/sway";
import type { Bodies } from "./camera_fit";
import type { PaperShadow } from "./paper_shadow";
import type { StageLight } from "./stage_light";
import type { WindUniforms } from "./wind";

export type Vector = readonly [x: number, y: number, z: number];

/** A line of sight. */
export interface Ray {
	origin: Vector;
	/** Of any length. */
	direction: Vector;
}

/** What a figure is given to stand on. */
export interface RendererStage {
	/** Where its objects go, in the plant's metres; the viewer shows and hides it. */
	readonly root: Object3D;
	/** The light there is, as uniforms for shaders of its own and as the rig they are of. */
	readonly light: StageLight;
	/** Where it puts what casts its shadow on the paper. */
	readonly shadow: PaperShadow;
	/** The wind there is, for the shaders of what it moves. */
	readonly wind: WindUniforms;
	/** To be called where the figure changes by itself, so that it is drawn again; absent where nobody looks on. */
	readonly changed?: () => void;
}

/**
 * Draws the plants of one model, one after the other.
 * @typeParam S the model's specimen
 * @typeParam G what it grows into
 */
export interface ModelRenderer<S, G> {
	/** Shows a plant in place of the last, unmarked. Cheap enough for every step of a drag. */
	show(grown: G, specimen: S): void;
	/** Shows something too small to see, so that every program is built before the first plant arrives. */
	warmUp?(): void;
	/** What the view is to hold. */
	bounds(): Bodies;
	/** How wind moves what is shown; where absent it stands still. */
	sway?(): Sway | undefined;
	/** Settles what depends on where the viewer stands; called before each drawing, the light aimed. */
	prepare(camera: PerspectiveCamera): void;
	/** What is met first along a line of sight, by the model's own number for it; undefined where nothing is. */
	pick(ray: Ray): number | undefined;
	/** Marks what `pick` found, and softly what it is a part of, where it can; undefined marks nothing. */
	mark(picked: number | undefined, whole?: ReadonlySet<number>): void;
	/** Ways of showing a plant by name, the usual one first. */
	readonly modes: readonly string[];
	/** One of `modes`; a plant shown later keeps to it. */
	setMode(mode: string): void;
	/** How far above the plant's horizon the view begins, degrees; absent: a little. */
	readonly elevation?: number;
	/** Whether it is seen from within, since `prepare`: a sky is then behind it, and no paper. */
	readonly within?: boolean;
	/** Settles when nothing of what is shown is still being made; absent where `show` makes all of it. */
	whenFinished?(): Promise<void>;
	/** The graphics card has lost all that it was given: what the page has no copy of is made anew. */
	restored?(): void;
	/** Takes its objects off the stage and frees what they hold of the GPU. */
	dispose(): void;
}

export type RendererFactory<S, G> = (stage: RendererStage) => ModelRenderer<S, G>;
