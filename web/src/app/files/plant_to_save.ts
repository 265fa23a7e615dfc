import type { Studio } from "../studio";
import { lookOf, type ShownPlant } from "../studio_state";

/**
 * What a download is of: the plant that is on the controls at the time of asking, in the look it has then. Where it still grows,
 * its growth is waited for; where that fails, it is the plant that stays in view.
 * @throws the signal's reason where it is cancelled, and an Error where there is no plant
 */
export async function plantToSave(studio: Studio, signal?: AbortSignal): Promise<ShownPlant> {
	const requested = studio.state;
	await caughtUp(studio, signal);
	const { shown } = studio.state;
	if (!shown) throw new Error("Nothing has grown yet.");
	return { ...shown, from: { ...shown.from, look: lookOf(shown, requested) } };
}

/** Resolves once no growth is under way. */
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
