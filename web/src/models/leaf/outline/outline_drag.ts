/**
 * Drag sessions of an outline's points, by their indices as text. A point stops where the outline would cross itself.
 */
import { DragSession } from "../../../ui/handles/drag_session";
import { movePoint, type OutlinePoints, type Place, type Symmetry } from "./points";
import { enclosesBlade } from "./spline";

export interface OutlineHost {
	get(): OutlinePoints;
	symmetry(): Symmetry;
	/** The nearest position that a point can be moved to now. */
	reach?(to: Place): Place;
	input(points: OutlinePoints): void;
	change(): void;
	/** Called when a drag first reaches a position where the outline would cross itself: the point stays. */
	refused(): void;
	schedule?(callback: () => void): void;
}

/** Returns the drag session of an outline's points; moves that make the margin cross itself are refused. */
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
