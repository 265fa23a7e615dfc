/** Interfaces of renderers, which draw the plants of one model. Models that consist of parts use `partRenderer`. */
import type { Object3D, PerspectiveCamera } from "three";
import type { Sway } from "../plant/sway";
import type { Bodies } from "./camera_fit";
import type { LightRig, Theme } from "./light";
import type { PaperShadow } from "./paper_shadow";
import type { StageLight } from "./stage_light";
import type { WindUniforms } from "./wind_shader";

export type SceneVector = readonly [x: number, y: number, z: number];

/** A ray. */
export interface ViewRay {
	origin: SceneVector;
	/** Of any length. */
	direction: SceneVector;
}

/** Where the plant is shown; changes at any time, and counts from the next drawing on. */
export interface StageSetting {
	/** Whether outdoors instead of on paper, if the renderer has a light for that. */
	outdoors: boolean;
	/** Whether the plant alone is drawn: in cut-out pictures and in the user's room. */
	bare: boolean;
	theme: Theme;
}

/** The setting of a new stage. */
export const PAPER: Readonly<StageSetting> = { outdoors: false, bare: false, theme: "light" };

/** Environment of a renderer. */
export interface RendererStage {
	/** Parent of the renderer's objects, in the plant's metres; the viewer shows and hides it. */
	readonly root: Object3D;
	/** The light, as uniforms for the renderer's own shaders, and as its rig. */
	readonly light: StageLight;
	/** Scene for the objects that cast the shadow on the paper. */
	readonly shadow: PaperShadow;
	readonly setting: Readonly<StageSetting>;
	/** Uniforms of the wind, for shaders of the parts that it moves. */
	readonly wind: WindUniforms;
	/** Called when the drawing changes by itself, to request a frame; absent without a viewer. */
	readonly changed?: () => void;
}

/**
 * Draws the plants of one model, one after the other.
 * @typeParam S the model's specimen
 * @typeParam G the plant grown from it
 */
export interface ModelRenderer<S, G> {
	/** Shows a plant in place of the last, without marks. Fast enough for every step of a drag. */
	show(grown: G, specimen: S): void;
	/** Shows something too small to be visible, so that all programs are compiled before the first plant arrives. */
	warmUp?(): void;
	/** Returns the bounds that the view must contain. */
	bounds(): Bodies;
	/** Returns the motion of the plant in wind; without it, the plant does not move. */
	sway?(): Sway | undefined;
	/** Updates the parts that depend on the camera; called before each drawing, after the light is aimed. */
	prepare(camera: PerspectiveCamera): void;
	/** Returns the pick id of the first part along a ray; undefined if the ray hits nothing. */
	pick(ray: ViewRay): number | undefined;
	/**
	 * Marks the part with a pick id, and softly the group that it belongs to, if the renderer supports this; undefined
	 * removes the mark.
	 */
	mark(picked: number | undefined, whole?: ReadonlySet<number>): void;
	/** Names of the modes of display, the default first. */
	readonly modes: readonly string[];
	/** Sets one of `modes`, also for plants shown later. */
	setMode(mode: string): void;
	/** Elevation of the first view above the plant's horizon, degrees; absent: a small default. */
	readonly elevation?: number;
	/** Samples per pixel of pictures, along each side; 1 if absent. Plants with many thin parts need more. */
	readonly samples?: number;
	/** Returns the light outdoors, for plants that can be shown there; absent where they cannot. */
	outdoorRig?(theme: Theme): LightRig;
	/** Height of the ground that the shown plant stands on, metres; undefined where it does not stand. */
	readonly groundLevel?: number | undefined;
	/** Least elevation of the first view outdoors, degrees; absent: the eye is at the height of a person's eyes. */
	readonly outdoorElevation?: number;
	/**
	 * Whether the camera is within the plant, as of the last `prepare`: the background is then a sky instead of paper.
	 */
	readonly within?: boolean;
	/** Resolves when all parts of the plant are complete; absent if `show` completes them. */
	whenFinished?(): Promise<void>;
	/** Restores GPU resources of which the page has no copy, after the graphics context was lost. */
	restored?(): void;
	/** Removes the objects from the stage and frees their GPU resources. */
	dispose(): void;
}

export type RendererFactory<S, G> = (stage: RendererStage) => ModelRenderer<S, G>;
