/** Interaction of a tool whose script loads on first use. */
import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";
import type { EditorContext, EditorState } from "../editor_context";
import { text } from "../messages.generated";
import type { ToolInteraction } from "../tool";

export interface LazyInteractionOptions<S extends Specimen, G extends Plant> {
	readonly context: EditorContext<S, G>;
	/** Returns whether the script is needed; after the first time, every change is passed on. */
	wanted(state: EditorState<S, G>): boolean;
	fetch(): Promise<ToolInteraction<S, G>>;
	/** Called if loading fails: resets the tool, so that its button retries. */
	onFetchFailed(): void;
}

export class LazyInteraction<S extends Specimen, G extends Plant> implements ToolInteraction<S, G> {
	readonly #options: LazyInteractionOptions<S, G>;
	#interaction: Promise<ToolInteraction<S, G> | undefined> | undefined;
	#disposed = false;

	constructor(options: LazyInteractionOptions<S, G>) {
		this.#options = options;
	}

	/** Passes the state to the interaction, whose script is loaded when it is first wanted. */
	update(state: EditorState<S, G>): void {
		if (!this.#interaction && !this.#options.wanted(state)) return;
		this.#interaction ??= this.#fetch();
		void this.#interaction.then((interaction) => {
			if (!this.#disposed) interaction?.update(state);
		});
	}

	/** Disposes of the interaction, also if its script is still loading. */
	dispose(): void {
		this.#disposed = true;
		void this.#interaction?.then((interaction) => interaction?.dispose());
	}

	/**
	 * Loads the interaction; undefined if it fails, with a notice, or if this object was disposed of meanwhile. After a
	 * failure the next use tries again.
	 */
	async #fetch(): Promise<ToolInteraction<S, G> | undefined> {
		const { context, fetch, onFetchFailed } = this.#options;
		const interaction = await fetch().catch(() => undefined);
		if (interaction) {
			if (!this.#disposed) return interaction;
			interaction.dispose();
			return undefined;
		}
		this.#interaction = undefined;
		onFetchFailed();
		context.notify(text("handles_not_loaded"), [text("press_again")]);
		return undefined;
	}
}
