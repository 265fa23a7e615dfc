/**
 * Records the plants of this page in the list of recent plants, once they are at rest. An entry begins when a plant is
 * opened by a link, a file, a saved plant or a preset, and follows its edits; Undo to another plant continues the entry
 * of that plant.
 */
import { growsAlike } from "../../specimen/same";
import type { Specimen } from "../../specimen/specimen";
import { caughtUp } from "../files/plant_to_save";
import { extraOf } from "../session/stored_specimen";
import type { Studio } from "../studio";
import type { StudioState } from "../studio_state";
import type { RecentPicture } from "./recent_store";
import type { Recents } from "./recents";
import { Visit } from "./visit";

/** Time without changes after which a plant is recorded, milliseconds. */
const REST = 1000;

export interface RecorderOptions {
	/** Makes a small picture of the view. */
	readonly thumbnail: (take: NonNullable<StudioState["picture"]>) => Promise<RecentPicture>;
	/** Time without changes after which a plant is recorded, milliseconds. */
	readonly rest?: number;
}

export class RecentRecorder {
	readonly #studio: Studio;
	readonly #recents: Recents;
	readonly #options: RecorderOptions;
	/** The visits that specimens of the history belong to. */
	readonly #visits = new WeakMap<Specimen, Visit>();
	#visit: Visit;
	#timer: ReturnType<typeof setTimeout> | undefined;
	/** Ends waiting for the picture of an earlier specimen. */
	#waiting = new AbortController();
	/** The last step of the storage: they run one after the other. */
	#last: Promise<unknown> = Promise.resolve();

	constructor(studio: Studio, recents: Recents, options: RecorderOptions) {
		this.#studio = studio;
		this.#recents = recents;
		this.#options = options;
		this.#visit = new Visit(studio.state);
		this.#visits.set(studio.state.specimen, this.#visit);
	}

	/** Records from now on; returns the function that ends it. */
	start(): () => void {
		const end = this.#studio.subscribe(() => this.#followSpecimen());
		this.#schedule();
		return () => {
			end();
			clearTimeout(this.#timer);
			this.#waiting.abort();
		};
	}

	/** Records the plant at once, without a new picture: the page is hidden and may be closed. */
	async flush(): Promise<void> {
		if (this.#visit.isChanged) await this.#record(this.#visit).catch(() => {});
	}

	/** Stores the plant for the next page: this one is being left, and no step that takes time would be finished. */
	defer(): void {
		const entry = this.#visit.isChanged ? this.#visit.entry() : undefined;
		if (entry) this.#recents.defer(entry);
	}

	/** Follows a change of the specimen at rest: an edit continues the visit, another plant begins one. */
	#followSpecimen(): void {
		const { state } = this.#studio;
		const { specimen, held, opened } = state;
		const before = this.#visit;
		if (held || specimen === before.specimen) return;
		const known = this.#visits.get(specimen);
		const isNew = specimen === opened || originOf(specimen) !== originOf(before.specimen);
		if (known === before || (!known && !isNew)) before.show(state);
		else {
			if (before.isChanged) void this.#record(before).catch(() => {});
			known?.resume(state);
			this.#visit = known ?? new Visit(state);
		}
		this.#visits.set(specimen, this.#visit);
		this.#schedule();
	}

	/** Records the visit after a pause without changes. */
	#schedule(): void {
		const visit = this.#visit;
		this.#waiting.abort();
		this.#waiting = new AbortController();
		const { signal } = this.#waiting;
		clearTimeout(this.#timer);
		this.#timer = setTimeout(() => void this.#settle(visit, signal).catch(() => {}), this.#options.rest ?? REST);
	}

	/** Records a visit, with its picture once it has grown. */
	async #settle(visit: Visit, signal: AbortSignal): Promise<void> {
		const { specimen } = visit;
		if (this.#studio.state.pending) await this.#record(visit);
		await caughtUp(this.#studio, signal);
		const { shown, picture, held } = this.#studio.state;
		const isShown = shown !== undefined && !held && growsAlike(shown.from, specimen);
		const taken = isShown && picture ? await this.#options.thumbnail(picture).catch(() => undefined) : undefined;
		if (!signal.aborted) await this.#record(visit, taken);
	}

	/** Stores the entry of a visit. */
	#record(visit: Visit, picture?: RecentPicture): Promise<void> {
		const step = this.#last.then(async () => {
			const { specimen, model } = visit;
			const [from] = await Promise.all([visit.from, visit.encoding]);
			const entry = visit.entry();
			// A newer specimen is being encoded, and is recorded afterwards.
			if (!entry || visit.specimen !== specimen) return;
			const stored = await this.#recents.record(entry, { picture, extra: extraOf(model, specimen) }, from);
			if (visit.specimen === specimen) visit.isChanged = false;
			if (stored) visit.stored(stored);
		});
		this.#last = step.catch(() => {});
		return step;
	}
}

/** Returns a key of the model and preset of a specimen. */
const originOf = ({ model, preset }: Specimen): string => `${model} ${preset}`;
