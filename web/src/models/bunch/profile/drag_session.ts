/** Drags of the profile's handles, in a flat view or in 3-D: positions are pixels of the handle's flat view. */
import { DragSession } from "../../../ui/handles/drag_session";
import { type DragOptions, dragHandle, sameShape, straightened } from "./drag";
import { type BunchShape, type Handle, handleKeys, handlePosition, type Locks } from "./handles";

export interface ProfileHost<P extends BunchShape> {
	/** Handles whose numbers a drag may change. */
	handles(): readonly Handle[];
	locks(): Locks;
	get(): P;
	input(parameters: P): void;
	change(): void;
	schedule?(callback: () => void): void;
}

export type ProfileKeys = Pick<PointerEvent, "shiftKey" | "altKey">;
export type ProfileDrags<P extends BunchShape> = DragSession<Handle, P, ProfileKeys>;

/**
 * Creates a drag session: Shift keeps a handle on its horizontal or vertical, Alt moves the opposite handle with it.
 */
export function profileDrags<P extends BunchShape>(host: ProfileHost<P>): ProfileDrags<P> {
	return new DragSession<Handle, P, ProfileKeys>({
		get: () => host.get(),
		place: (handle) => handlePosition(host.get(), handle),
		pull: (shape, handle, to, { from, keys }) => {
			const options: DragOptions = { locks: host.locks(), mirror: keys?.altKey };
			return dragHandle(shape, handle, keys?.shiftKey ? straightened(to, from) : to, options);
		},
		same: (one, other) => sameShape(one, other, host.handles()),
		restored: (now, before) => {
			const restored = { ...now };
			for (const key of host.handles().flatMap(handleKeys)) restored[key] = before[key];
			return restored;
		},
		input: (parameters) => host.input(parameters),
		change: () => host.change(),
		schedule: host.schedule,
	});
}
