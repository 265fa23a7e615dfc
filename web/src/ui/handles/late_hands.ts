/** A tool's hands whose script is fetched when they are first wanted. */
import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";
import type { Desk, DeskState } from "../desk";
import type { ToolHands } from "../tool";

export interface LateHandsOptions<S extends Specimen, G extends Plant> {
	readonly desk: Desk<S, G>;
	/** Whether there is anything to take hold of; once there was, every change is told. */
	wanted(state: DeskState<S, G>): boolean;
	fetch(): Promise<ToolHands<S, G>>;
	/** Puts the tool back to where its button fetches them anew. */
	missed(): void;
}

export class LateHands<S extends Specimen, G extends Plant> implements ToolHands<S, G> {
	readonly #options: LateHandsOptions<S, G>;
	#hands: Promise<ToolHands<S, G> | undefined> | undefined;
	#disposed = false;

	constructor(options: LateHandsOptions<S, G>) {
		this.#options = options;
	}

	update(state: DeskState<S, G>): void {
		if (!this.#hands && !this.#options.wanted(state)) return;
		this.#hands ??= this.#fetch();
		void this.#hands.then((hands) => {
			if (!this.#disposed) hands?.update(state);
		});
	}

	dispose(): void {
		this.#disposed = true;
		void this.#hands?.then((hands) => hands?.dispose());
	}

	async #fetch(): Promise<ToolHands<S, G> | undefined> {
		const { desk, fetch, missed } = this.#options;
		const hands = await fetch().catch(() => undefined);
		if (hands) {
			if (!this.#disposed) return hands;
			hands.dispose();
			return undefined;
		}
		this.#hands = undefined;
		missed();
		desk.notify("The handles could not be fetched", ["Check the connection and press their button again."]);
		return undefined;
	}
}
