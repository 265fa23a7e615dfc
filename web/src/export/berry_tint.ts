/**
 * How one berry's colours differ from the bunch's: by chance, which its id decides for ever, by the sun it had and by how
 * far it has dried. The same rules by which the app draws it (scene/skin.ts).
 */
import type { Grown } from "../models/bunch/grown";
import type { Look } from "../specimen/specimen";
import { type Colour, clamp, fromLch, type Lch, linear, mixed, smoothstep, toLch } from "./colour";
import { hashFraction } from "./noise";
import { traitOf } from "./traits";

export interface BerryTint {
	/** Linear light. */
	unripe: Colour;
	ripe: Colour;
	/** Factor on the look's bloom. */
	bloom: number;
}

/** Colour of a bud or an ovary just set: the green of young leaves. */
const YOUNG = linear("86a046");

/** The tint of berry `index`. Hues are turned in radians. */
export function berryTint({ berries }: Grown, index: number, look: Look): BerryTint {
	const id = berries.ids[index];
	const trait = (name: "exposure" | "set" | "shrivel") => traitOf(berries, index, name);
	const [set, shrivel] = [trait("set"), trait("shrivel")];
	const chance = (stream: number) => 2 * look.uneven * (hashFraction(id, stream) + hashFraction(id, stream + 16) - 1);
	const ripe = toLch(linear(look.skin));
	const late = 2 * look.uneven * smoothstep(0.86, 1, hashFraction(id, 3));
	// Sun turns pale skins golden and dark ones darker.
	const sunned = 2 * look.uneven * (trait("exposure") - 0.5);
	const pale = smoothstep(0.45, 0.75, ripe.lightness);
	const green = toLch(mixed(YOUNG, linear(look.unripe), set));
	return {
		ripe: dried(
			{
				lightness: ripe.lightness * (1 + 0.1 * chance(0) - 0.05 * sunned * (1 - pale)) + 0.05 * late,
				chroma: ripe.chroma * (1 + 0.14 * chance(1) + 0.1 * sunned * pale),
				hue: ripe.hue + 0.11 * chance(2) - 0.14 * sunned * pale + 0.16 * late * (ripe.hue < 0 ? 1 : 0.4),
			},
			shrivel,
		),
		unripe: dried(
			{
				lightness: green.lightness * (1 + 0.06 * chance(6)),
				chroma: green.chroma * (1 + 0.1 * chance(7)),
				hue: green.hue + 0.06 * chance(8) - 0.06 * sunned,
			},
			shrivel,
		),
		bloom: (1 + 0.5 * chance(4)) * (1 - 0.45 * shrivel) * (0.25 + 0.75 * set),
	};
}

/** Towards a raisin's colour: browner, and darker the paler it was. */
function dried(lch: Lch, shrivel: number): Colour {
	const raisin = fromLch({ lightness: 0.2 + 0.3 * lch.lightness, chroma: 0.03 + 0.4 * lch.chroma, hue: 0.75 });
	return mixed(fromLch(lch), raisin, 0.8 * clamp(shrivel));
}

/** The colour of wax: it scatters short waves a little more; on dark skins that blue is what the eye sees. */
export function waxColour(look: Look): Colour {
	const skin = linear(look.skin);
	const pale = smoothstep(0.35, 0.8, toLch(skin).lightness);
	return mixed(fromLch({ lightness: 0.74, chroma: 0.04, hue: 4.75 }), mixed(skin, [1, 1, 1], 0.72), 0.6 * pale);
}
