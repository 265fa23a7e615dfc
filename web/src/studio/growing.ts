import type { GrowOptions } from "../core/client";
import { CoreError, CoreTrap, Superseded } from "../core/errors";
import type { Grown } from "../models/bunch/grown";
import type { RequestOptions } from "../models/bunch/request";
import type { Specimen } from "../specimen/specimen";
import type { Studio } from "./studio";
import type { Failure, Remedy } from "./types";

/** What takes longer than this shows that it grows, and can be cancelled; milliseconds. */
const PATIENCE = 200;

/** The measure from asking for a bunch to having its buffers: the last one stands, an observer hears of all (`npm run bench`). */
const REGROW = "regrow";

/** Grows a specimen off the page's thread; rejects as Client.grow does. */
export interface Grower {
	grow(specimen: Specimen, options?: RequestOptions & GrowOptions): Promise<Grown>;
}

/** Keeps the studio's bunch in step with its specimen: asks the client, hands over what grew, says what went wrong. */
export class Growing {
	/** The newest request; older answers are shown too while a drag goes on, so that every frame is the latest there is. */
	#newest = 0;
	#shown = 0;
	#cancel: AbortController | undefined;
	#timer: ReturnType<typeof setTimeout> | undefined;

	constructor(
		private readonly client: Grower,
		private readonly studio: () => Studio,
	) {}

	/** Grows a specimen, measured unless it says not; a newer call takes its place. */
	async grow(specimen: Specimen, options: RequestOptions = {}): Promise<void> {
		const turn = ++this.#newest;
		this.#cancel ??= new AbortController();
		this.#timer ??= this.#patience();
		const start = performance.now();
		try {
			const grown = await this.client.grow(specimen, { ...options, signal: this.#cancel.signal });
			performance.clearMeasures(REGROW);
			performance.measure(REGROW, { start });
			if (turn < this.#shown) return;
			this.#shown = turn;
			this.#answered(turn);
			this.studio().grew(grown, specimen);
		} catch (error) {
			if (turn !== this.#newest) return;
			this.#answered(turn);
			this.#explain(error);
		}
	}

	/** Ends what is under way; the last bunch stays, if there is one. */
	cancel(): void {
		this.#cancel?.abort(new Cancelled());
	}

	/** Patience is with the answer that is awaited, not with a whole drag. */
	#answered(turn: number): void {
		clearTimeout(this.#timer);
		this.studio().setGrowing(false);
		const atRest = turn === this.#newest;
		this.#timer = atRest ? undefined : this.#patience();
		if (atRest) this.#cancel = undefined;
	}

	#patience(): ReturnType<typeof setTimeout> {
		return setTimeout(() => this.studio().setGrowing(true), PATIENCE);
	}

	#explain(error: unknown): void {
		if (error instanceof Superseded) return;
		const studio = this.studio();
		const failure = failureOf(error);
		// Where the place is at fault, no change of the specimen helps, so a notice beside the last bunch would not do.
		if (!studio.state.grown || !failure.remedies.includes("other")) studio.fail(failure);
		else if (error instanceof CoreError) studio.notify(`${failure.title}; the last bunch stays`, failure.details);
		else studio.notify(failure.title, ["The last bunch stays; any change grows again."]);
	}
}

const NONE_YET = "There is no bunch yet; any change grows again.";

/** What went wrong, in the words for a page without a bunch. */
function failureOf(error: unknown): Failure {
	if (error instanceof CoreError) {
		return { title: "This cannot be grown", details: [where(error)], remedies: ["other"] };
	}
	const remedies: readonly Remedy[] = ["again", "other"];
	if (error instanceof Cancelled) {
		return { title: "Growing was cancelled", details: [NONE_YET], remedies };
	}
	if (error instanceof CoreTrap) {
		return { title: "Growing broke off and its worker was replaced", details: [NONE_YET], remedies };
	}
	const text = error instanceof Error ? error.message : String(error);
	return { title: "No bunch can grow here", details: [text], remedies: ["again"] };
}

class Cancelled extends Error {
	override name = "Cancelled";
}

function where({ message, line, column }: CoreError): string {
	return line > 0 ? `Line ${line}, column ${column} of the grammar: ${message}` : message;
}
