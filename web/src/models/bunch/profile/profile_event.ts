/** What a flat view tells of. */
import type { BunchSpecimen } from "../specimen";

/** `profile-input`: live, once a frame at most. `profile-change`: a drag ended or was called off, a key stepped. */
export type ProfileEvent = CustomEvent<{ parameters: BunchSpecimen["parameters"]; run?: string }>;

declare global {
	interface HTMLElementEventMap {
		"profile-input": ProfileEvent;
		"profile-change": CustomEvent;
	}
}
