/** What a flat view tells of. */
import type { BunchSpecimen } from "../specimen";

/** `profile-input`: live, once a frame at most. `profile-change`: a drag ended, a key stepped. `profile-cancel`: Escape. */
export type ProfileEvent = CustomEvent<{ parameters: BunchSpecimen["parameters"] }>;

declare global {
	interface HTMLElementEventMap {
		"profile-input": ProfileEvent;
		"profile-change": ProfileEvent;
		"profile-cancel": ProfileEvent;
	}
}
