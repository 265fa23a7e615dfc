/** File formats of trees and roots in addition to the common ones. */
import type { Specimen } from "../../../specimen/specimen";
import type { Format } from "../../model";
import type { TrailPlant } from "../trails";

/** @param words describes the plant in a few words */
export function woodFormats<S extends Specimen, G extends TrailPlant>(
	words: (grown: G, specimen: S) => string,
): readonly Format<S, G>[] {
	return [
		{
			key: "svg",
			title: "Wood as SVG",
			about: "From in front, at a round scale: each branch one tapering shape, far ones paler",
			suffix: "-wood.svg",
			type: "image/svg+xml",
			applies: ({ segments }) => segments.count > 0,
			make: async (grown, specimen, link) => (await import("./wood_svg")).woodSvg(grown, words(grown, specimen), link),
		},
	];
}
