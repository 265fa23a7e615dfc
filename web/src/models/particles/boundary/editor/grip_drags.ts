/** Drag sessions of grips, one at a time: positions are in the view's units, changes are partial specimens. */
import type { Change } from "../../../../ui/editor_context";
import { type DragHost, DragSession } from "../../../../ui/handles/drag_session";
import { gripIn, type Pose } from "./grip";

export interface GripHost extends Pick<DragHost<string, Change, undefined>, "input" | "change" | "schedule"> {
	pose(): Pose | undefined;
}

/** Returns the drag session of a boundary's handles. */
export function gripDrags({ pose, input, change, schedule }: GripHost): DragSession<string, Change> {
	/** The last change of the dragged grip; each change sets the same fields. */
	let lastChange: Change = {};
	return new DragSession<string, Change>({
		get: () => pose()?.change ?? {},
		place: (id) => gripIn(pose(), id)?.at ?? { x: 0, y: 0 },
		pull: (state, id, to) => gripIn(pose(), id)?.pull(to) ?? state,
		same: (one, other) => one === other,
		restored: (_, before) => restrictedTo(before, lastChange),
		// Grips change different fields, so drags cannot be combined.
		alone: true,
		input: (next) => {
			lastChange = next;
			input(next);
		},
		change,
		schedule,
	});
}

/** Returns the entries of a change whose keys another change has too. */
function restrictedTo({ parameters, details }: Change, like: Change): Change {
	return { parameters: valuesOfKeys(parameters, like.parameters), details: valuesOfKeys(details, like.details) };
}

/** Returns the values in `from` of the keys that `like` has. */
function valuesOfKeys<T>(from: Readonly<Record<string, T>> = {}, like: object = {}): Record<string, T> {
	return Object.fromEntries(Object.keys(like).map((key) => [key, from[key]]));
}
