/** The page as controls and tools use it: the open document, and the actions that change it. */
import type { TraceRequest } from "../plant/derivation_trace";
import type { Plant } from "../plant/plant";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";

/** A change of the document; absent members stay unchanged. */
export interface Change {
	seed?: number;
	parameters?: Readonly<Partial<Record<string, number>>>;
	look?: Readonly<Partial<Record<string, number | string>>>;
	/** Fields of the specimen by name, each in its field's own form; absent in the specimen if undefined. */
	details?: Readonly<Record<string, unknown>>;
	/** Run of key presses: changes of one run are one undo step, though each is settled by itself. */
	run?: string | undefined;
}

/** State of the open document and its plant. */
export interface EditorState<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** The document as set by the controls now, also during a drag. */
	readonly specimen: S;
	/** Model of `specimen`. */
	readonly model: ModelSchema<S>;
	/** The last plant that grew; it stays on screen after errors. */
	readonly grown: G | undefined;
	/** The specimen that `grown` grew from. */
	readonly grownFrom: S | undefined;
	/**
	 * Measures of the last measured plant, in the order of the table; not updated during drags that do not need them.
	 */
	readonly measures: Float32Array | undefined;
	/** Whether the user is dragging a control, so that the picture is a preview. */
	readonly held: boolean;
	/** Whether growth takes so long that a progress message is shown. */
	readonly growing: boolean;
	/** Why the document could not be grown; the plant shown is then of an older document. */
	readonly fault: Fault | undefined;
	/** Whether the dark theme is active. */
	readonly dark: boolean;
}

/** Why the document on the controls could not be grown. */
export interface Fault {
	readonly message: string;
	/** Position in the grammar's text, counted from 1, columns in characters; 0 if no text is concerned. */
	readonly line: number;
	readonly column: number;
}

/** An owner of state on the page: plain data, stored under the model's name. */
export interface Stateful<T> {
	readonly name: string;
	/** The initial state. */
	readonly initial: T;
	/** Restores the state from an earlier visit's data; without this method the state is not stored. */
	recall?(stored: unknown): T;
}

/** Behaviour of a notice. */
export interface NoticeOptions {
	/** Subject: a new notice replaces older ones of the same topic. */
	topic?: string;
	/** Disappears after a while: for confirmations and for limits reached during a drag, never for warnings. */
	brief?: boolean;
	/** Concerns the document as opened: the first change removes the notice. */
	untouched?: boolean;
	/** Action of a button that retries. */
	again?: () => void;
	/** Button with another action. */
	act?: { readonly label: string; readonly run: () => void };
}

/** Options of growing a plant offscreen. */
export interface OffscreenOptions {
	/** Step of the derivation to trace, for models with a derivation; the default is none. */
	readonly trace?: TraceRequest;
	/** Number of derivation steps, in place of the document's. */
	readonly steps?: number;
	/** Whether the plant has meshes; the default is no. */
	readonly meshes?: boolean;
	/** Cancels growth: the promise rejects with the signal's reason. */
	readonly signal?: AbortSignal;
}

/** Access of controls and tools to the page; implemented by the studio, and by fakes in tests. */
export interface EditorContext<S extends Specimen = Specimen, G extends Plant = Plant> {
	readonly state: EditorState<S, G>;
	/** The current preset's published specimen: double clicks restore its values. */
	readonly preset: S;
	/**
	 * Calls a listener after every change of the state.
	 * @returns function that removes the listener
	 */
	subscribe(listener: () => void): () => void;
	/** Applies a change during a drag or key press: the plant grows at once, and `settle` makes the undo step. */
	edit(change: Change, gesture?: string): void;
	/**
	 * Ends a drag: makes one undo step and updates the address bar. With a name, only if that gesture is in progress.
	 */
	settle(gesture?: string): void;
	/** Applies a change as an undo step of its own. */
	set(change: Change): void;
	/** Replaces the document, as one undo step. */
	replace(specimen: S): void;
	/** Moves back, or forward again, in the document's history. */
	undo(): void;
	redo(): void;
	/** Cancels growth in progress, so that the next request starts at once. */
	cancel(): void;
	/**
	 * Grows a specimen without showing it, while the document can grow at the same time. Runs one request at a time: a
	 * newer request replaces one that has not begun, which rejects with Superseded. Other errors are those of the
	 * core's client.
	 */
	growOffscreen(specimen: S, options: OffscreenOptions): Promise<G>;
	/** Shows a notice above the page. */
	notify(title: string, details?: readonly string[], options?: NoticeOptions): void;
	toolState<T>(tool: Stateful<T>): T;
	setToolState<T>(tool: Stateful<T>, state: T): void;
}
