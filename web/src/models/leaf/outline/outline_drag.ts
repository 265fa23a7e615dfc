/** The drags of an outline's points, each named by its number. A point stops where the outline would cross itself. */
import { DragSession } from "../../../ui/handles/drag_session";
import { movePoint, type OutlinePoints, type Place, type Symmetry } from "./points";
import { enclosesBlade } from "./spline";

export interface OutlineHost {
	get(): OutlinePoints;
	symmetry(): Symmetry;
	/** The nearest place that a point can be taken to now. */
	reach?(to: Place): Place;
	input(points: OutlinePoints): void;
	change(): void;
	/** A point would go where the outline crosses itself: it stays. Told when it comes to that, not all along. */
	refused(): void;
	schedule?(callback: () => void): void;
}

export function outlineDrags(host: OutlineHost): DragSession<string, OutlinePoints> {
	let refused = false;
	return new DragSession<string, OutlinePoints>({
		get: () => host.get(),
		place: (index) => host.get()[Number(index)],
		pull: (points, index, to) => {
			if (Number(index) >= points.length) return points;
			const moved = movePoint(points, Number(index), host.reach?.(to) ?? to, host.symmetry());
			const crosses = !enclosesBlade(moved);
			if (crosses && !refused) host.refused();
			refused = crosses;
			return crosses ? points : moved;
		},
		same: (one, other) => one === other,
		input: (points) => host.input(points),
		change: () => host.change(),
		schedule: host.schedule,
	});
}
