import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { lookOf, type ShownPlant } from "../studio_state";

/**
 * Returns the plant to save: the document on the controls at the time of the call, in its look of that time. Waits for
 * a running growth; if the growth fails, returns the plant that stays in view.
 * @throws the signal's reason when cancelled, and an Error if there is no plant
 */
export async function plantToSave(studio: Studio, signal?: AbortSignal): Promise<ShownPlant> {
	const requested = studio.state;
	await caughtUp(studio, signal);
	const { shown } = studio.state;
	if (!shown) throw new Error(text("growing_nothing"));
	return { ...shown, from: { ...shown.from, look: lookOf(shown, requested) } };
}

/** Resolves once no growth is running. */
export function caughtUp(studio: Studio, signal?: AbortSignal): Promise<void> {
	return new Promise((resolve, reject) => {
		signal?.throwIfAborted();
		const done = () => {
			if (studio.state.pending) return;
			stop();
			resolve();
		};
		const end = studio.subscribe(done);
		const abort = () => {
			stop();
			reject(signal?.reason);
		};
		const stop = () => {
			end();
			signal?.removeEventListener("abort", abort);
		};
		signal?.addEventListener("abort", abort);
		done();
	});
}
