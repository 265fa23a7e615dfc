/** Painting of a leaf's textures in a worker: requests, results, and the painting itself. */
import { rgbaPicture } from "../../../plant/picture";
import { FacePictures, type FaceTextures, type FlatLeaf, PREVIEW_SIDE, SIDE } from "../parts/face_pictures";
import type { LeafSpecimen } from "../specimen";

export interface PaintOrder {
	id: number;
	/** The leaf; where absent, the leaf of the request before. */
	leaf?: FlatLeaf;
	specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">;
	/** Whether to paint a preview: with fewer pixels and without relief, which takes little time. */
	preview: boolean;
}

/** Textures of both faces, with pictures in a format for upload. */
export interface BladeTextures {
	upper: FaceTextures;
	lower: FaceTextures;
}

export interface PaintedLeaf extends BladeTextures {
	id: number;
}

/** Paints repeatedly: a change of colours reuses the veins. */
export class Painter {
	#pictures: FacePictures | undefined;

	/**
	 * Paints the textures of both faces.
	 * @param order.leaf undefined for the leaf of the last order
	 */
	paint({ leaf, specimen, preview }: Omit<PaintOrder, "id">): BladeTextures {
		const side = preview ? PREVIEW_SIDE : SIDE;
		if (leaf) this.#pictures = new FacePictures(leaf, specimen.parameters.length, side, preview);
		const pictures = this.#pictures;
		if (!pictures) throw new Error("There is no leaf to paint.");
		const face = (side: "upper" | "lower"): FaceTextures => {
			const { colour, normal, mean } = pictures.face(specimen, side);
			return { colour: rgbaPicture(colour), normal: rgbaPicture(normal), mean };
		};
		return { upper: face("upper"), lower: face("lower") };
	}
}

/** Returns the pictures' buffers, which are transferred with a result instead of copied. */
export function moved({ upper, lower }: BladeTextures): ArrayBuffer[] {
	return [upper, lower].flatMap(({ colour, normal }) =>
		[colour, normal].map(({ pixels }) => pixels.buffer as ArrayBuffer),
	);
}
