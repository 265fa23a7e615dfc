/**
 * Renders a leaf: at once with coarse textures, then with fine ones when they are painted (paint_queue.ts). Fine
 * textures are uploaded one per frame, to keep frames short. While particles move, and when they stop, a leaf has the
 * last painted textures until its own arrive; previews take a frame or two.
 */
import type { PerspectiveCamera } from "three";
import type { Picture } from "../../../plant/material";
import { type Sway, swayOf } from "../../../plant/sway";
import type { Bodies } from "../../../render/camera_fit";
import type { ModelRenderer, RendererFactory, RendererStage, ViewRay } from "../../../render/model_renderer";
import { PartRenderer } from "../../../render/part_renderer";
import type { Leaf } from "../grown";
import { FacePictures, type FaceTextures, FLAT_PICTURE, PREVIEW_SIDE } from "../parts/face_pictures";
import { leafParts } from "../parts/leaf_parts";
import { FACES, type Side } from "../parts/materials";
import type { LeafSpecimen } from "../specimen";
import type { BladeTextures } from "./paint";
import { PaintQueue } from "./paint_queue";

/** A texture that waits for its upload. */
interface Sheet {
	side: Side;
	kind: "colour" | "normal";
	picture: Picture;
}

export class LeafRenderer implements ModelRenderer<LeafSpecimen, Leaf> {
	readonly modes = ["whole"];
	readonly #stage: RendererStage;
	readonly #parts: PartRenderer<LeafSpecimen, Leaf>;
	readonly #painters: PaintQueue;
	#leaf: Leaf | undefined;
	#preview = false;
	#preset: string | undefined;
	/**
	 * The finest textures available for the shown leaf, maybe in its previous colours; of a preview maybe those of the
	 * one before.
	 */
	#faces: ((side: Side) => FaceTextures) | undefined;
	#sheets: Sheet[] = [];

	/**
	 * @param painters creates the queue that paints the fine textures and delivers them to a callback; by default a
	 * worker paints
	 */
	constructor(
		stage: RendererStage,
		painters: (deliver: (faces: BladeTextures, preview: boolean) => void) => PaintQueue = (to) => new PaintQueue(to),
	) {
		this.#stage = stage;
		this.#parts = new PartRenderer(
			stage,
			(leaf, specimen) => leafParts(leaf, specimen, this.#faces),
			undefined,
			(leaf) => swayOf(leaf),
		);
		this.#painters = painters((faces, preview) => (preview ? this.#applyPreview(faces) : this.#receiveFinal(faces)));
	}

	/**
	 * Replaces the drawn leaf and orders its textures. Another leaf is drawn with coarse textures at first, unless the
	 * last ones serve.
	 */
	show(leaf: Leaf, specimen: LeafSpecimen): void {
		this.#sheets = [];
		// Previews have no visibility of the sky.
		const preview = !leaf.meshes.some(({ sky }) => sky);
		// The next frame of an animation or a drag, its end included, looks much like the last one.
		const next = this.#faces && (preview || this.#preview) && specimen.preset === this.#preset;
		if (leaf !== this.#leaf && !next) this.#faces = coarseTextures(leaf, specimen);
		this.#leaf = leaf;
		this.#preview = preview;
		this.#preset = specimen.preset;
		this.#parts.show(leaf, specimen);
		this.#painters.order(leaf, specimen, preview);
	}

	/** Returns the bounds of the drawn leaf. */
	bounds(): Bodies {
		return this.#parts.bounds();
	}

	/** Returns the movement in the wind; undefined where there is none. */
	sway(): Sway | undefined {
		return this.#parts.sway();
	}

	/** Uploads everything again after the graphics context was lost. */
	restored(): void {
		this.#parts.restored();
	}

	/** Prepares the next frame: uploads at most one texture that waits. */
	prepare(camera: PerspectiveCamera): void {
		this.#applyNextSheet();
		this.#parts.prepare(camera);
	}

	/** Returns the number of the part that a ray from the camera hits; undefined where it hits none. */
	pick(ray: ViewRay): number | undefined {
		return this.#parts.pick(ray);
	}

	/** Highlights the part that `pick` returned; undefined ends the highlight. */
	mark(picked: number | undefined): void {
		this.#parts.mark(picked);
	}

	/** Does nothing: a leaf has a single mode. */
	setMode(): void {}

	/** Waits until all fine textures are painted and applied. */
	async whenFinished(): Promise<void> {
		await this.#painters.whenDone();
		while (this.#sheets.length > 0) this.#applyNextSheet();
	}

	/** Stops painting and releases the graphics memory. */
	dispose(): void {
		this.#painters.dispose();
		this.#parts.dispose();
	}

	/** Applies the textures of a preview at once: they are small. */
	#applyPreview(faces: BladeTextures): void {
		this.#faces = (side) => ({ ...faces[side], normal: FLAT_PICTURE });
		for (const side of ["upper", "lower"] as const) {
			this.#parts.setPicture(FACES[side], "colour", faces[side].colour);
			this.#parts.setPicture(FACES[side], "normal", FLAT_PICTURE);
		}
		this.#stage.changed?.();
	}

	/** Receives fine textures: they wait for their upload, one per frame. */
	#receiveFinal(faces: BladeTextures): void {
		this.#faces = (side) => faces[side];
		const sides = ["upper", "lower"] as const;
		const sheets = (kind: Sheet["kind"]) => sides.map((side) => ({ side, kind, picture: faces[side][kind] }));
		this.#sheets = [...sheets("colour"), ...sheets("normal")];
		this.#stage.changed?.();
	}

	/** Applies one texture per frame until none waits. */
	#applyNextSheet(): void {
		const sheet = this.#sheets.shift();
		if (!sheet) return;
		this.#parts.setPicture(FACES[sheet.side], sheet.kind, sheet.picture);
		if (this.#sheets.length > 0) this.#stage.changed?.();
	}
}

/**
 * Returns a function that computes a face's coarse textures at its first use: with fewer pixels and without relief.
 */
function coarseTextures(leaf: Leaf, specimen: LeafSpecimen): (side: Side) => FaceTextures {
	const pictures = new FacePictures(leaf, specimen.parameters.length, PREVIEW_SIDE, true);
	const faces = new Map<Side, FaceTextures>();
	return (side) => {
		const face = faces.get(side) ?? pictures.face(specimen, side);
		faces.set(side, face);
		return face;
	};
}

export const leafRenderer: RendererFactory<LeafSpecimen, Leaf> = (stage) => new LeafRenderer(stage);
