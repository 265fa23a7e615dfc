/** The outline's points as handles on the leaf. */

import type { Change } from "../../../ui/editor_context";
import type { HandlesOf, HandleVector } from "../../../ui/handles/plant_handle";
import { text } from "../messages.generated";
import type { LeafSpecimen } from "../specimen";
import { bent } from "./bent";
import { placeInWords } from "./outline_words";
import { isSymmetric, movePoint, type Place } from "./points";
import { curveOf, enclosesBlade } from "./spline";

/** Step of an arrow key, in leaf lengths; Shift multiplies it by ten. */
const NUDGE = 0.005;

/** The handles of the outline's points on the bent blade, and the outline as a line. */
export const leafHandles: HandlesOf<LeafSpecimen> = ({ outline, parameters }) => {
	const { length, fold, curl } = parameters;
	const metres = length / 1000;
	const bend = { fold, curl };
	// Symmetric outlines stay symmetric.
	const symmetry = { mirror: isSymmetric(outline) };
	const changeFor = (index: number, to: Place): Change => {
		const outlineAfter = movePoint(outline, index, to, symmetry);
		return { details: { outline: enclosesBlade(outlineAfter) ? outlineAfter : outline } };
	};
	const inMetres = ([x, y, z]: HandleVector): HandleVector => [x * metres, y * metres, z * metres];
	const curve = curveOf(outline).map((place) => inMetres(bent(place, bend).at));
	return {
		handles: outline.flatMap((point, index) => {
			// The base, at the petiole, cannot be moved.
			if (index === 0) return [];
			const { at, along, stretch } = bent(point, bend);
			const position = inMetres(at);
			const [right, up] = along;
			return {
				id: `point${index}`,
				label: text("point", { number: index }),
				value: placeInWords(point),
				at: position,
				along,
				pull: (to: HandleVector) => {
					const [x, y] = [
						distanceAlong(position, to, right) / metres,
						distanceAlong(position, to, up) / metres / stretch,
					];
					return changeFor(index, { x: point.x + x, y: point.y + y });
				},
				nudge: (x: number, y: number, large: boolean) => {
					const step = large ? 10 * NUDGE : NUDGE;
					return changeFor(index, { x: point.x + x * step, y: point.y + y * step });
				},
			};
		}),
		lines: [[...curve, curve[0]]],
	};
};

/** Returns how far `to` lies from `from` in a direction: the dot product with the unit vector `along`. */
function distanceAlong(from: HandleVector, to: HandleVector, along: HandleVector): number {
	return along.reduce((sum, way, i) => sum + way * (to[i] - from[i]), 0);
}
