/** What controls and tools have of the page: the document before them and the ways to change it. */
import type { TraceRequest } from "../plant/derivation_trace";
import type { Plant } from "../plant/plant";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";

/** What a control changes; what it leaves out stays. */
export interface Change {
	seed?: number;
	parameters?: Readonly<Partial<Record<string, number>>>;
	look?: Readonly<Partial<Record<string, number | string>>>;
	/** Fields of the specimen that are its details', by name, each in the form that its detail keeps; absent where undefined. */
	details?: Readonly<Record<string, unknown>>;
	/** The run of key presses that it is of: changes of one run are one undo step, though each comes to rest. */
	run?: string | undefined;
}

export interface EditorState<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** The document as it is on the controls now, mid-drag included. */
	readonly specimen: S;
	/** What `specimen` is one of. */
	readonly model: ModelSchema<S>;
	/** The last plant that grew; it stays on screen whatever goes wrong. */
	readonly grown: G | undefined;
	/** The specimen that `grown` grew from. */
	readonly grownFrom: S | undefined;
	/** What was last measured, in the order of the table; it stays while a drag asks for none. */
	readonly measures: Float32Array | undefined;
	/** Whether a hand is on a control: what is seen is on its way. */
	readonly held: boolean;
	/** Whether a growth takes long enough to say so. */
	readonly growing: boolean;
	/** What the core said of the document on the controls, where it could not grow it: what is shown is then an older plant. */
	readonly fault: Fault | undefined;
	/** Whether the page is dark now. */
	readonly dark: boolean;
}

/** Why the document on the controls could not be grown. */
export interface Fault {
	readonly message: string;
	/** In the grammar's text, from 1, columns in characters; 0 where no text is concerned. */
	readonly line: number;
	readonly column: number;
}

/** Something with a state of its own on the page: plain data, kept under the name of its model. */
export interface Stateful<T> {
	readonly name: string;
	/** What it is at first. */
	readonly initial: T;
	/** Makes a state of what a former visit left; a state without it is forgotten with the page. */
	recall?(stored: unknown): T;
}

/** How a notice behaves. */
export interface NoticeOptions {
	/** What it is about: what was said of that before is taken back. */
	topic?: string;
	/** Text to copy by hand. */
	copy?: string;
	/** Goes by itself after a while: confirmations, and what a hand has just run into; never warnings. */
	brief?: boolean;
	/** Is about the document as it came: the first change of it takes this back. */
	untouched?: boolean;
	/** Offers to try again. */
	again?: () => void;
	/** Offers something else to do. */
	act?: { readonly words: string; readonly run: () => void };
}

/** What is wanted of a plant that is not shown. */
export interface OffscreenOptions {
	/** Which step of its derivation is to be told, of models that tell of it; the default is none. */
	readonly trace?: TraceRequest;
	/** Steps of the derivation in place of the document's. */
	readonly steps?: number;
	/** Whether triangles are wanted; the default is no. */
	readonly meshes?: boolean;
	/** Cancels: the promise rejects with the signal's reason. */
	readonly signal?: AbortSignal;
}

/** The studio is one; a test may be another. */
export interface EditorContext<S extends Specimen = Specimen, G extends Plant = Plant> {
	readonly state: EditorState<S, G>;
	/** The specimen of the current preset as published: what double clicks go back to. */
	readonly preset: S;
	/** Calls back after every change of the state; returns the function that ends it. */
	subscribe(listener: () => void): () => void;
	/** A change while the hand still moves: it grows at once, but becomes an undo step only with `settle`. */
	edit(change: Change, gesture?: string): void;
	/** The end of a drag: one undo step, and the address bar follows. Of a named gesture only where that goes on. */
	settle(gesture?: string): void;
	/** A change that is a step of its own. */
	set(change: Change): void;
	/** Another document in place of this one, as one step. */
	replace(specimen: S): void;
	/** A step back in the document's history, and forward again. */
	undo(): void;
	redo(): void;
	/** Ends what grows now: what is asked for next begins at once. */
	cancel(): void;
	/**
	 * Grows a specimen without showing it; what is shown grows beside. One at a time: a newer call takes the place of one that has not
	 * begun, which rejects with Superseded; else it rejects as the core's client does.
	 */
	growOffscreen(specimen: S, options: OffscreenOptions): Promise<G>;
	/** Says something above the page. */
	notify(title: string, details?: readonly string[], options?: NoticeOptions): void;
	toolState<T>(tool: Stateful<T>): T;
	setToolState<T>(tool: Stateful<T>, state: T): void;
}
