/** File formats of trees and roots in addition to the common ones. */

import type { Specimen } from "../../../specimen/specimen";
import type { Format } from "../../model";
import { text } from "../messages.generated";
import type { TrailPlant } from "../trails";

/**
 * Lists the kinds of files that such plants have besides those of all plants.
 * @param words describes the plant in a few words
 */
export function woodFormats<S extends Specimen, G extends TrailPlant>(
	words: (grown: G, specimen: S) => string,
): readonly Format<S, G>[] {
	return [
		{
			key: "svg",
			get title() {
				return text("format_svg");
			},
			get about() {
				return text("format_svg_about");
			},
			suffix: "-wood.svg",
			type: "image/svg+xml",
			applies: ({ segments }) => segments.count > 0,
			make: async (grown, specimen, link) => (await import("./wood_svg")).woodSvg(grown, words(grown, specimen), link),
		},
	];
}
