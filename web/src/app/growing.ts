import { CoreError, CoreTrap, Superseded } from "../core/errors";
import type { GrowthOptions } from "../models/model";
import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Fault } from "../ui/editor_context";
import { GROWTH_TOPIC as GROWTH } from "../ui/tool";
import type { Grower } from "./core_grower";
import { showFaultInPane } from "./show_fault";
import type { Studio } from "./studio";
import type { Failure, Remedy } from "./types";

/** What takes longer than this shows that it grows, and can be cancelled; milliseconds. */
const PROGRESS_DELAY = 200;

/** The measure from asking for a plant to having its buffers: the last one stands, an observer hears of all (`npm run bench`). */
const REGROW = "regrow";

/** Keeps the studio's plant in step with its specimen: asks the core, hands over what grew, says what went wrong. */
export class Growing {
	readonly #grower: Grower;
	readonly #studio: () => Studio;
	/** The newest request; older answers are shown too while a drag goes on, so that every frame is the latest there is. */
	#newest = 0;
	#shown = 0;
	#cancel: AbortController | undefined;
	#timer: ReturnType<typeof setTimeout> | undefined;
	/** Whether the first picture is yet to come: it waits for nothing that it can do without. */
	#opening = true;

	constructor(grower: Grower, studio: () => Studio) {
		this.#grower = grower;
		this.#studio = studio;
	}

	/** Grows a specimen, measured unless it says not; a newer call takes its place. */
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
			this.#answered(turn);
			this.#studio().grew(grown, specimen);
			this.#studio().retract(GROWTH);
			if (turn === this.#newest) this.#studio().caughtUp();
		} catch (error) {
			if (turn !== this.#newest) return;
			this.#answered(turn);
			const fault = faultOf(error);
			this.#explain(error, model.noun, fault);
			this.#studio().caughtUp(fault);
		}
	}

	/** Those that stand in a plant come one after the other: what there is of the newest is shown, and that it still grows. */
	#grewSome(turn: number, grown: Plant, specimen: Specimen): void {
		if (turn < this.#newest) return;
		this.#shown = turn;
		this.#studio().grew(grown, specimen);
	}

	/** The first plant has been drawn: what was a sketch follows. */
	finish(): void {
		this.#opening = false;
		const studio = this.#studio();
		const { model, specimen } = studio.state;
		const sketch = model.sketch?.(specimen);
		if (!sketch) return;
		// Whether it came showed when it was asked for first.
		sketch.catch(() => {});
		studio.growAgain();
	}

	/** Ends what is under way; the last plant stays, if there is one. */
	cancel(): void {
		this.#cancel?.abort(new Cancelled());
		// What is asked for next is not meant.
		this.#cancel = undefined;
	}

	/** Patience is with the answer that is awaited, not with a whole drag. */
	#answered(turn: number): void {
		clearTimeout(this.#timer);
		this.#studio().setGrowing(false);
		const atRest = turn === this.#newest;
		this.#timer = atRest ? undefined : this.#startProgressTimer();
		if (atRest) this.#cancel = undefined;
	}

	#startProgressTimer(): ReturnType<typeof setTimeout> {
		return setTimeout(() => this.#studio().setGrowing(true), PROGRESS_DELAY);
	}

	#explain(error: unknown, noun: string, fault: Fault | undefined): void {
		if (error instanceof Superseded) return;
		const studio = this.#studio();
		const { shown } = studio.state;
		const failure = failureOf(error, noun);
		// Where the place is at fault, no change of the specimen helps, so a notice beside the last plant would not do.
		if (!shown || !failure.remedies.includes("other")) studio.fail(failure);
		else if (fault && showFaultInPane(studio, fault)) return;
		else if (error instanceof CoreError)
			studio.notify(`${failure.title}; the last ${shown.model.noun} stays`, failure.details, { topic: GROWTH });
		else
			studio.notify(failure.title, [`The last ${shown.model.noun} stays; any change grows again.`], { topic: GROWTH });
	}
}

/** What went wrong, in the words for a page without a plant. */
function failureOf(error: unknown, noun: string): Failure {
	if (error instanceof CoreError) {
		return { title: "This cannot be grown", details: [where(error)], remedies: ["other"] };
	}
	const remedies: readonly Remedy[] = ["again", "other"];
	const noneYet = `There is no ${noun} yet; any change grows again.`;
	if (error instanceof Cancelled) {
		return { title: "Growing was cancelled", details: [noneYet], remedies };
	}
	if (error instanceof CoreTrap) {
		return { title: "Growing broke off and its worker was replaced", details: [noneYet], remedies };
	}
	const text = error instanceof Error ? error.message : String(error);
	return { title: `No ${noun} can grow here`, details: [text], remedies: ["again"] };
}

class Cancelled extends Error {
	override name = "Cancelled";
}

/** What the core said against the document, as plain data. */
function faultOf(error: unknown): Fault | undefined {
	if (!(error instanceof CoreError)) return undefined;
	const { message, line, column } = error;
	return { message, line, column };
}

function where({ message, line, column }: CoreError): string {
	return line > 0 ? `Line ${line}, column ${column} of the grammar: ${message}` : message;
}
