import type { Grown } from "../models/bunch/grown";
import { mirrorFrontBack, mirrorLeftRight } from "../models/bunch/profile/drag";
import { thin, unthinAll } from "../specimen/edit";
import { specimenFromPreset } from "../specimen/from_preset";
import * as histories from "../specimen/history";
import type { Restored } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import { apply, asPrinted, growsAlike, isAsPrinted, lockSides, otherSeed } from "./change";
import type { Change, Failure, Locks, Notice } from "./types";
import type { UiState } from "./ui_state";

export interface StudioState {
	/** The document as it is on the controls now, mid-drag included. */
	readonly specimen: Specimen;
	readonly history: histories.History;
	/** The last bunch that grew; it stays on screen whatever goes wrong. */
	readonly grown: Grown | undefined;
	/** The specimen `grown` grew from: what the exporters write beside it. */
	readonly grownFrom: Specimen | undefined;
	/** What was last measured; it stays while a drag asks for none. In the order of MEASURES. */
	readonly measures: Float32Array | undefined;
	/** Id of the berry that is pointed at, in the view or on the panel. */
	readonly marked: number | undefined;
	/** Whether the age runs by itself. */
	readonly playing: boolean;
	/** Whether a growth takes long enough to say so. */
	readonly growing: boolean;
	/** Why there is no bunch, in place of one. */
	readonly failure: Failure | undefined;
	readonly notices: readonly Notice[];
	readonly ui: UiState;
}

/** What the studio does outside itself; main.ts wires it. */
export interface Surroundings {
	/** Asks for growth, measured or not; the newest request wins. */
	grow(specimen: Specimen, options: { measures: boolean }): void;
	/** Ends a long growth. */
	cancel(): void;
	/** The document came to rest: the address bar is to hold it. */
	settled(specimen: Specimen): void;
	/** The interface changed: remember it. */
	remember(ui: UiState): void;
}

/** Confirmations stay this long, in milliseconds. */
const BRIEF = 4000;
const MOST_NOTICES = 3;
const DRAG = "drag";
/** The gesture of an age that runs by itself: a drag meanwhile is a step of its own. */
export const PLAY = "play";

/**
 * The one place where the page's state lives. It flows one way: a part calls an action, the action replaces the state,
 * every part draws the new one.
 */
export class Studio {
	#state: StudioState;
	readonly #listeners = new Set<() => void>();
	readonly #surroundings: Surroundings;
	#noticeId = 0;
	/** Whether what was last asked for is to be measured. */
	#measured = true;
	#preset: Specimen | undefined;
	/** What `fit` and `vary` were before *as printed*. */
	#beforePrinted: { fit: number; vary: number } | undefined;
	/** Takes a picture of the 3-D view, as PNG; set by the stage while it has a view. */
	picture: (() => Promise<Blob>) | undefined;

	constructor(specimen: Specimen, ui: UiState, surroundings: Surroundings) {
		this.#surroundings = surroundings;
		this.#state = {
			specimen,
			history: histories.startHistory(specimen),
			grown: undefined,
			grownFrom: undefined,
			measures: undefined,
			marked: undefined,
			playing: false,
			growing: false,
			failure: undefined,
			notices: [],
			ui,
		};
	}

	get state(): StudioState {
		return this.#state;
	}

	/** The specimen of the current preset as published: what double clicks go back to. */
	get preset(): Specimen {
		const { preset } = this.#state.specimen;
		if (this.#preset?.preset !== preset) this.#preset = specimenFromPreset(preset);
		return this.#preset;
	}

	/** Calls back after every change of the state; returns the function that ends it. */
	subscribe(listener: () => void): () => void {
		this.#listeners.add(listener);
		return () => this.#listeners.delete(listener);
	}

	// The document.

	/** A change while the hand still moves: it grows at once, but becomes an undo step only with `settle`. */
	edit(change: Change, gesture = DRAG): void {
		const next = apply(this.#state.specimen, change, this.#state.ui.locks);
		this.#go(histories.change(this.#state.history, next, gesture));
	}

	/** The end of a drag: one undo step, and the address bar follows. */
	settle(): void {
		this.#go(histories.settle(this.#state.history));
		this.#surroundings.settled(this.#state.specimen);
	}

	/** A change that is a step of its own. */
	set(change: Change): void {
		this.replace(apply(this.#state.specimen, change, this.#state.ui.locks));
	}

	/** Another document in place of this one, as one step: a preset, a dropped file, a link. */
	replace(specimen: Specimen): void {
		this.#travel(histories.change(this.#state.history, specimen));
	}

	/** Starts with a document from outside: there is nothing before it to go back to. */
	open(restored: Restored, from: string): void {
		const { specimen } = restored;
		this.#update({ specimen, history: histories.startHistory(specimen) });
		this.#ask();
		this.#surroundings.settled(specimen);
		this.#report(restored, from);
	}

	/** Takes a document from outside in place of this one, as one step. */
	take(restored: Restored, from: string): void {
		this.replace(restored.specimen);
		this.#report(restored, from);
	}

	choosePreset(name: string): void {
		this.replace(specimenFromPreset(name));
	}

	/** The preset as it was published. */
	reset(): void {
		this.replace(this.preset);
	}

	newVariation(): void {
		this.set({ seed: otherSeed(this.#state.specimen.seed) });
	}

	/** Exchanges the two sides of a pair; every number is named, so that locks have nothing to add. */
	mirror(pair: keyof Locks): void {
		const { parameters } = this.#state.specimen;
		this.set({ parameters: pair === "leftRight" ? mirrorLeftRight(parameters) : mirrorFrontBack(parameters) });
	}

	setAsPrinted(on: boolean): void {
		const { specimen } = this.#state;
		const { fit, vary } = specimen.parameters;
		this.set(asPrinted(specimen, on, this.#beforePrinted));
		this.#beforePrinted = on && !isAsPrinted(specimen) ? { fit, vary } : undefined;
	}

	/** The profile's own m and n again, or the built-in grammar, in place of those a link or a file brought. */
	drop(key: "inputs" | "grammar"): void {
		const { [key]: _, ...specimen } = this.#state.specimen;
		this.replace(specimen);
	}

	/** Takes a berry off by hand; the mark goes on to `next`. */
	thin(id: number, next?: number): void {
		this.replace(thin(this.#state.specimen, id));
		this.mark(next);
	}

	/** Gives back every berry that was taken off by hand. */
	putBack(): void {
		this.replace(unthinAll(this.#state.specimen));
	}

	/** Points at a berry, or at none. */
	mark(id: number | undefined): void {
		if (id !== this.#state.marked) this.#update({ marked: id });
	}

	/** Lets the age run (age_player.ts drives it), or stops it where it stands: one undo step in all. */
	setPlaying(playing: boolean): void {
		if (playing === this.#state.playing) return;
		this.#update({ playing });
		if (!playing && this.#state.history.gesture === PLAY) this.settle();
	}

	undo(): void {
		this.#travel(histories.undo(this.#state.history));
	}

	redo(): void {
		this.#travel(histories.redo(this.#state.history));
	}

	// Growth, reported by growing.ts.

	grew(grown: Grown, from: Specimen): void {
		const measures = grown.measures ?? this.#state.measures;
		this.#update({ grown, grownFrom: from, measures, failure: undefined });
	}

	setGrowing(growing: boolean): void {
		if (growing !== this.#state.growing) this.#update({ growing });
	}

	/** There is no bunch to show, and none comes without a remedy. */
	fail(failure: Failure): void {
		this.#update({ failure });
	}

	cancel(): void {
		this.#surroundings.cancel();
	}

	/** Asks again, after a failure. */
	growAgain(): void {
		this.#ask();
	}

	// The page.

	/** Shows a notice above the page; the same words are not stacked. */
	notify(title: string, details: readonly string[] = [], options: { copy?: string; brief?: boolean } = {}): void {
		const id = ++this.#noticeId;
		const others = this.#state.notices.filter((notice) => notice.title !== title);
		this.#update({ notices: [...others, { id, title, details, ...options }].slice(-MOST_NOTICES) });
		if (options.brief) setTimeout(() => this.dismiss(id), BRIEF);
	}

	dismiss(id: number): void {
		this.#update({ notices: this.#state.notices.filter((notice) => notice.id !== id) });
	}

	setUi(patch: Partial<UiState>): void {
		const ui = { ...this.#state.ui, ...patch };
		this.#update({ ui });
		this.#surroundings.remember(ui);
	}

	setGroup(key: string, open: boolean): void {
		const { closed } = this.#state.ui;
		if (closed.includes(key) !== open) return;
		this.setUi({ closed: open ? closed.filter((each) => each !== key) : [...closed, key] });
	}

	/** Locking brings the two sides together at once, so that what is shown is what is locked. */
	toggleLock(lock: keyof Locks): void {
		const { locks } = this.#state.ui;
		this.setUi({ locks: { ...locks, [lock]: !locks[lock] } });
		if (!locks[lock]) this.set(lockSides(this.#state.specimen, lock));
	}

	/** Says what could not be used of a document. */
	#report({ notes }: Restored, from: string): void {
		if (notes.length > 0) {
			this.notify(
				`Not everything in the ${from} could be used`,
				notes.map((note) => note.text),
			);
		}
	}

	#travel(history: histories.History): void {
		this.#go(history);
		this.#surroundings.settled(this.#state.specimen);
	}

	#go(history: histories.History): void {
		const { specimen: before } = this.#state;
		const { present } = history;
		if (history === this.#state.history) return;
		this.#update({ history, specimen: present });
		const rests = history.gesture === undefined;
		if (!growsAlike(before, present) || (rests && !this.#measured)) this.#ask();
	}

	/** While the hand still moves, only the shape is asked for; what is measured follows when it rests. */
	#ask(): void {
		const { specimen, history } = this.#state;
		this.#measured = history.gesture === undefined;
		this.#surroundings.grow(specimen, { measures: this.#measured });
	}

	#update(patch: Partial<StudioState>): void {
		this.#state = { ...this.#state, ...patch };
		for (const listener of this.#listeners) listener();
	}
}
