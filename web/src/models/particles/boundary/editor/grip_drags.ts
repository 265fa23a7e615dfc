/** Drags of grips, one at a time: places are in the view's units, what they change are parts of a specimen. */
import type { Change } from "../../../../ui/editor_context";
import { type DragHost, DragSession } from "../../../../ui/handles/drag_session";
import { gripIn, type Pose } from "./grip";

export interface GripHost extends Pick<DragHost<string, Change, undefined>, "input" | "change" | "schedule"> {
	pose(): Pose | undefined;
}

export function gripDrags({ pose, input, change, schedule }: GripHost): DragSession<string, Change> {
	/** What the grip in hand was last told to make of the specimen: always the same numbers of it. */
	let lastChange: Change = {};
	return new DragSession<string, Change>({
		get: () => pose()?.change ?? {},
		place: (id) => gripIn(pose(), id)?.at ?? { x: 0, y: 0 },
		pull: (state, id, to) => gripIn(pose(), id)?.pull(to) ?? state,
		same: (one, other) => one === other,
		restored: (_, before) => only(before, lastChange),
		// What one grip makes of the pose, another's drag does not know of.
		alone: true,
		input: (next) => {
			lastChange = next;
			input(next);
		},
		change,
		schedule,
	});
}

/** Of a change only what another one says something of, too. */
function only({ parameters, details }: Change, like: Change): Change {
	return { parameters: picked(parameters, like.parameters), details: picked(details, like.details) };
}

function picked<T>(from: Readonly<Record<string, T>> = {}, like: object = {}): Record<string, T> {
	return Object.fromEntries(Object.keys(like).map((key) => [key, from[key]]));
}
