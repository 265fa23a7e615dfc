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
import { tintOf } from "./berry_tint";
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
		at(corners, weights) {
			const among = (values: ArrayLike<number>, width: number, k: number) =>
				weights.reduce((sum, weight, i) => sum + weight * values[width * (first + corners[i]) + k], 0);
			const all = (values: Float32Array) => [0, 1, 2].map((k) => among(values, 3, k)) as Vector;
			const normal = unit(all(surfaces.normals));
			ball.enter(all(surfaces.positions), 0);
			const fine = ball.noise(tint.phase, FINE);
			const touched = among(pressed, 1, 0) / 255;
			const corky = scarShare(
				weights.reduce((sum, weight, i) => sum + weight * uvs[2 * corners[i] + 1], 0),
				scar,
			);
			const bloom = skin.bloom * tint.bloom * (1 - corky) * (1 - WAX.dry * shrivel);
			const waxed = hiddenBy(waxDepth(bloom, ball.noise(tint.phase), fine, normal[1], touched));
			const dull = rind > 0 ? 1 : Math.max(DULL.shrivel * shrivel, DULL.scar * corky);
			const roughness = mix(mix(SKIN_ROUGHNESS[0], WAXED_ROUGHNESS, waxed), RIND_ROUGHNESS, dull);
			return relief ? { roughness, normal: roughened(normal, ball.in(tint.phase, furrows), steep) } : { roughness };
		},
	};
}

/** Returns the normal of a surface with low bumps: uphill is where the noise grows. */
function roughened(normal: Vector, [x, y, z]: Vector, steep: number): Vector {
	const here = noise(x, y, z);
	const { step } = FURROWS;
	const slope = [noise(x + step, y, z) - here, noise(x, y + step, z) - here, noise(x, y, z + step) - here];
	const out = slope[0] * normal[0] + slope[1] * normal[1] + slope[2] * normal[2];
	return unit(normal.map((value, k) => value - steep * (slope[k] - value * out)) as Vector);
}

function unit(vector: Vector): Vector {
	const length = Math.hypot(...vector) || 1;
	return [vector[0] / length, vector[1] / length, vector[2] / length];
}
