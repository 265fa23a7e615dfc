/**
 * Details of a berry's skin finer than its vertices, for textures: patches of wax change the roughness, rinds and
 * raisins have a relief. Rules, numbers and noise are those of the view (skin_rules.ts).
 */
import { mix } from "../../../plant/colour";
import { noise } from "../../../plant/noise";
import type { SurfaceDetail, Vector } from "../../../plant/part";
import type { BerrySurfaces, BunchPlant } from "../bunch_plant";
import { traitOf } from "../traits";
import { Ball } from "./ball";
import { scarShare } from "./berry_colour";
import { type BerryTint, tintOf } from "./berry_tint";
import { RIND_ROUGHNESS, SKIN_ROUGHNESS } from "./materials";
import type { Skin } from "./skin";
import { FINE, FURROWS, RIND, WAX } from "./skin_rules";
import { hiddenBy, waxDepth } from "./wax";

/**
 * Roughness where wax covers the skin completely; the mean over berries in full bloom equals their material's
 * roughness.
 */
const WAXED_ROUGHNESS = 0.6;
/** Share by which raisins and scars are as dull as a rind. */
const DULL = { shrivel: 0.6, scar: 0.7 };

/** Returns the details of berry `index`. */
export function berryFiner(grown: BunchPlant, index: number, surfaces: BerrySurfaces, skin: Skin): SurfaceDetail {
	const { berries } = grown;
	const { uvs, pressed } = surfaces;
	// Index of the berry's first vertex among those of all berries, which share one set of `uvs`.
	const first = (index * uvs.length) / 2;
	const tint = tintOf(grown, index, skin);
	const shrivel = traitOf(berries, index, "shrivel");
	const { rind, scar } = skin.fruit;
	const steep = Math.max(FURROWS.rind * rind, FURROWS.shrivel * shrivel);
	const relief = steep > FURROWS.least;
	const furrows = rind > RIND.from ? FURROWS.onRinds : FURROWS.onRaisins;
	const ball = new Ball(berries, index);
	return {
		relief,
		/**
		 * Returns the roughness, and where there is a relief the normal, at a point of a triangle.
		 * @param corners the triangle's vertices within the berry
		 * @param weights barycentric coordinates of the point
		 */
		at(corners, weights) {
			// Interpolates component `k` of the vertices' values, `width` numbers each, from vertex `offset` on.
			const interpolated = (values: ArrayLike<number>, offset: number, width: number, k: number) =>
				weights.reduce((sum, weight, i) => sum + weight * values[width * (offset + corners[i]) + k], 0);
			const vectorAt = (values: Float32Array) => [0, 1, 2].map((k) => interpolated(values, first, 3, k)) as Vector;
			const normal = unitVector(vectorAt(surfaces.normals));
			ball.enter(vectorAt(surfaces.positions), 0);
			const roughness = roughnessAt(ball, normal[1], {
				pressed: interpolated(pressed, first, 1, 0) / FULLY_PRESSED,
				corky: scarShare(interpolated(uvs, 0, 2, 1), scar),
				shrivel,
				tint,
				skin,
			});
			return relief ? { roughness, normal: roughened(normal, ball.in(tint.phase, furrows), steep) } : { roughness };
		},
	};
}

/** State of a berry's skin at a point. */
interface SkinState {
	/** 0 free … 1 in contact with a neighbour. */
	readonly pressed: number;
	/** Share of the tip scar, 0 … 1. */
	readonly corky: number;
	/** How far the berry has dried, 0 … 1. */
	readonly shrivel: number;
	readonly tint: BerryTint;
	readonly skin: Skin;
}

/**
 * Returns the roughness of the skin at the ball's point: wax makes it matt, and scars, raisins and rinds are dull.
 * @param up how far the normal points up, −1 … 1
 */
function roughnessAt(ball: Ball, up: number, { pressed, corky, shrivel, tint, skin }: SkinState): number {
	const bloom = skin.bloom * tint.bloom * (1 - corky) * (1 - WAX.dry * shrivel);
	const waxed = hiddenBy(waxDepth(bloom, ball.noise(tint.phase), ball.noise(tint.phase, FINE), up, pressed));
	// Rinds, raisins and scars are dull, with or without wax.
	const dull = skin.fruit.rind > 0 ? 1 : Math.max(DULL.shrivel * shrivel, DULL.scar * corky);
	return mix(mix(SKIN_ROUGHNESS[0], WAXED_ROUGHNESS, waxed), RIND_ROUGHNESS, dull);
}

/** Value of `BerrySurfaces.pressed` in full contact. */
const FULLY_PRESSED = 255;

/**
 * Returns the normal of a surface with low bumps, whose height is the noise: tilted away from its gradient.
 * @param normal of the smooth surface, unit length
 * @param steep factor on the slopes
 */
function roughened(normal: Vector, [x, y, z]: Vector, steep: number): Vector {
	const here = noise(x, y, z);
	const { step } = FURROWS;
	const slope = [noise(x + step, y, z) - here, noise(x, y + step, z) - here, noise(x, y, z + step) - here];
	const out = slope[0] * normal[0] + slope[1] * normal[1] + slope[2] * normal[2];
	return unitVector(normal.map((value, k) => value - steep * (slope[k] - value * out)) as Vector);
}

/** Scales a vector to length 1; a zero vector remains. */
function unitVector(vector: Vector): Vector {
	const length = Math.hypot(...vector) || 1;
	return [vector[0] / length, vector[1] / length, vector[2] / length];
}
