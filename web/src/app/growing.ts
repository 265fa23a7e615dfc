import { CoreError, CoreTrap, Superseded, UnsupportedError } from "../core/errors";
import type { GrowthOptions } from "../models/model";
import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Fault } from "../ui/editor_context";
import { GROWTH_TOPIC as GROWTH } from "../ui/tool";
import type { Grower } from "./core_grower";
import { text } from "./messages.generated";
import { showFaultInPane } from "./show_fault";
import type { Studio } from "./studio";
import type { Failure, Remedy } from "./types";

/** Growths that take longer show progress and a Cancel button; milliseconds. */
const PROGRESS_DELAY = 200;

/**
 * Name of the performance measure from a request to the plant's buffers: only the last entry is retained (`npm run
 * bench`).
 */
const REGROW = "regrow";

/** Grows the studio's specimen: sends requests to the core, passes plants to the studio, and reports errors. */
export class PageGrowth {
	readonly #grower: Grower;
	readonly #studio: () => Studio;
	/**
	 * Number of the newest request. During a drag older responses are shown, too, if they are newer than the plant in
	 * view.
	 */
	#newest = 0;
	#shown = 0;
	#cancel: AbortController | undefined;
	#timer: ReturnType<typeof setTimeout> | undefined;
	/** Whether the first picture is yet to be drawn: until then sketches replace files that take time to fetch. */
	#opening = true;

	constructor(grower: Grower, studio: () => Studio) {
		this.#grower = grower;
		this.#studio = studio;
	}

	/** Grows a specimen, with measures by default; a newer call supersedes it. */
	async grow(model: PageModel, specimen: Specimen, options: GrowthOptions = {}): Promise<void> {
		const turn = ++this.#newest;
		this.#cancel ??= new AbortController();
		this.#timer ??= this.#startProgressTimer();
		const start = performance.now();
		try {
			const grew = (grown: Plant) => this.#grewSome(turn, grown, specimen);
			const wanted = { ...options, sketched: this.#opening, signal: this.#cancel.signal, grew };
			const grown = await this.#grower.grow(model, specimen, wanted);
			performance.clearMeasures(REGROW);
			performance.measure(REGROW, { start });
			if (turn < this.#shown) return;
			this.#shown = turn;
			this.#handleResponse(turn);
			this.#studio().grew(grown, specimen);
			this.#studio().retract(GROWTH);
			if (turn === this.#newest) this.#studio().caughtUp();
		} catch (error) {
			if (turn !== this.#newest) return;
			this.#handleResponse(turn);
			const fault = faultOf(error);
			this.#explain(error, fault);
			this.#studio().caughtUp(fault);
		}
	}

	/**
	 * Shows a stand of the newest request while its member plants still grow.
	 * @param turn number of the request
	 */
	#grewSome(turn: number, grown: Plant, specimen: Specimen): void {
		if (turn < this.#newest) return;
		this.#shown = turn;
		this.#studio().grew(grown, specimen);
	}

	/** Called once the first plant is drawn: grows again with the full files if a sketch was used. */
	finish(): void {
		this.#opening = false;
		const studio = this.#studio();
		const { model, specimen } = studio.state;
		const sketch = model.sketch?.(specimen);
		if (!sketch) return;
		// A failure of this fetch was reported by the first growth.
		sketch.catch(() => {});
		studio.growAgain();
	}

	/** Cancels the running growths; the last plant stays in view. */
	cancel(): void {
		this.#cancel?.abort(new Cancelled());
		// Later requests are not cancelled.
		this.#cancel = undefined;
	}

	/**
	 * Restarts the progress timer at every response: it measures one growth, not a whole drag.
	 * @param turn number of the request
	 */
	#handleResponse(turn: number): void {
		clearTimeout(this.#timer);
		this.#studio().setGrowing(false);
		const isNewest = turn === this.#newest;
		this.#timer = isNewest ? undefined : this.#startProgressTimer();
		if (isNewest) this.#cancel = undefined;
	}

	/** Starts the timer after which the page shows that a growth takes long. */
	#startProgressTimer(): ReturnType<typeof setTimeout> {
		return setTimeout(() => this.#studio().setGrowing(true), PROGRESS_DELAY);
	}

	/**
	 * Reports a failed growth. Nothing is reported if a newer growth replaced it, or if the grammar pane shows the error.
	 * @param fault the place of an error in the grammar
	 */
	#explain(error: unknown, fault: Fault | undefined): void {
		if (error instanceof Superseded) return;
		const studio = this.#studio();
		const { shown } = studio.state;
		const failure = failureOf(error);
		// If changing the specimen cannot help (no core, no network), the failure replaces the plant.
		if (!shown || !failure.remedies.includes("other")) studio.fail(failure);
		else if (fault && showFaultInPane(studio, fault)) return;
		else if (error instanceof CoreError)
			studio.notify(text("growing_refused_last"), failure.details, { topic: GROWTH });
		else studio.notify(failure.title, [text("growing_last_advice")], { topic: GROWTH });
	}
}

/** Describes an error for a page without a plant. */
function failureOf(error: unknown): Failure {
	if (error instanceof CoreError) {
		return { title: text("growing_refused"), details: [problemWithPlace(error)], remedies: ["other"] };
	}
	const remedies: readonly Remedy[] = ["again", "other"];
	const details = [text("growing_nothing_advice")];
	if (error instanceof Cancelled) return { title: text("growing_cancelled"), details, remedies };
	if (error instanceof CoreTrap) return { title: text("growing_crashed"), details, remedies };
	const reason = error instanceof Error ? error.message : String(error);
	const isMissing = error instanceof UnsupportedError && ["webassembly", "worker"].includes(error.missing);
	const title = text(isMissing ? "growing_unsupported" : "growing_unavailable");
	return { title, details: [reason], remedies: ["again"] };
}

class Cancelled extends Error {
	override name = "Cancelled";
}

/** Returns the core's error about the document, as plain data; undefined for other errors. */
function faultOf(error: unknown): Fault | undefined {
	if (!(error instanceof CoreError)) return undefined;
	const { message, line, column } = error;
	return { message, line, column };
}

/** Describes the core's error, with its place in the text if it has one. */
function problemWithPlace({ message, line, column }: CoreError): string {
	return line > 0 ? text("growing_refused_at", { line, column, problem: message }) : message;
}
