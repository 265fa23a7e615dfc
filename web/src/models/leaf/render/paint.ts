/** Painting the faces of a leaf away from the page's thread: what is asked, what is answered, and the painting. */
import { asCardsTakeIt } from "../../../plant/picture";
import { FacePictures, type FaceTextures, type FlatLeaf, PREVIEW_SIDE, SIDE } from "../parts/face_pictures";
import type { LeafSpecimen } from "../specimen";

export interface PaintOrder {
	id: number;
	/** Where absent, that of the order before. */
	leaf?: FlatLeaf;
	specimen: Pick<LeafSpecimen, "look" | "parameters" | "seed">;
	/** Whether it is of a leaf in passing: with fewer pixels and flat, which takes little time. */
	preview: boolean;
}

/** BladeTextures with pictures as cards take them. */
export interface BladeTextures {
	upper: FaceTextures;
	lower: FaceTextures;
}

export interface Painted extends BladeTextures {
	id: number;
}

/** Paints for one who asks time and again: veins stay drawn while colours change. */
export class Painter {
	#pictures: FacePictures | undefined;

	paint({ leaf, specimen, preview }: Omit<PaintOrder, "id">): BladeTextures {
		const side = preview ? PREVIEW_SIDE : SIDE;
		if (leaf) this.#pictures = new FacePictures(leaf, specimen.parameters.length, side, preview);
		const pictures = this.#pictures;
		if (!pictures) throw new Error("There is no leaf to paint.");
		const face = (side: "upper" | "lower"): FaceTextures => {
			const { colour, normal, mean } = pictures.face(specimen, side);
			return { colour: asCardsTakeIt(colour), normal: asCardsTakeIt(normal), mean };
		};
		return { upper: face("upper"), lower: face("lower") };
	}
}

/** The buffers that move with an answer, rather than be copied. */
export function moved({ upper, lower }: BladeTextures): ArrayBuffer[] {
	return [upper, lower].flatMap(({ colour, normal }) =>
		[colour, normal].map(({ pixels }) => pixels.buffer as ArrayBuffer),
	);
}
