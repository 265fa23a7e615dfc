/** Events of a flat view. */
import type { BunchSpecimen } from "../specimen";

/**
 * `profile-input`: live, at most once a frame. `profile-change`: a drag ended or was cancelled, or a key made a step.
 */
export type ProfileEvent = CustomEvent<{ parameters: BunchSpecimen["parameters"]; run?: string }>;

declare global {
	interface HTMLElementEventMap {
		"profile-input": ProfileEvent;
		"profile-change": CustomEvent;
	}
}
