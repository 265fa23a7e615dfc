/**
 * Tools: the controls that a model adds to the page, besides the sliders of its table. A tool can have a button on the
 * 3-D view, a key, a place in the panel, a bar below the view, a flat view, a text pane and an interaction with the
 * canvas. The studio shows each at its place and depends on no particular tool.
 */

import type { SVGTemplateResult } from "lit";
import type { Camera, Object3D } from "three";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Group } from "../specimen/table";
import type { Change, EditorContext, EditorState, Fault, Stateful } from "./editor_context";
import type { PointerRay } from "./handles/handle_ways";
import type { Quantity } from "./quantity";

/**
 * Groups of the buttons on the 3-D view, in the order and places in which every model shows them: the view, handles
 * and other ways to edit the plant in the picture, gestures, and the source text of the plant.
 */
export const TOOL_SLOTS = ["view", "edit", "gestures", "source"] as const;
export type ToolSlot = (typeof TOOL_SLOTS)[number];

/** A button on the 3-D view. */
export interface ToolButton<S extends Specimen = Specimen, G extends Plant = Plant> {
	readonly slot: ToolSlot;
	/** A line drawing on a 20 × 20 field (icons.ts). */
	readonly icon: SVGTemplateResult;
	readonly label: string;
	/** Returns whether the button is switched on; absent for a button with a single action. */
	pressed?(context: EditorContext<S, G>): boolean;
}

/** A single-letter key for the whole page. */
export interface ToolKey {
	/** A lower-case letter that neither another tool of the model nor the page uses (n, ?). */
	readonly letter: string;
	/** Description of the key in the help. */
	readonly description: string;
}

/** Key of the panel's first group, which shows the basics of every model. */
export const BASICS = "basics";

/** Controls in the panel. */
export interface ToolPanel<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** `BASICS`, the key of a group of the table, or a group of the tool's own, placed before the table's groups. */
	readonly group: string | Group;
	/** Place relative to the group's controls. */
	readonly place: "above" | "below";
	/**
	 * Returns the subject of the group: a part of the plant that the user has chosen in the picture, or an active way to
	 * edit the picture; undefined if there is none. For a new subject, the panel opens the group and scrolls to it.
	 */
	subject?(context: EditorContext<S, G>): unknown;
	draw(context: EditorContext<S, G>): unknown;
}

/** Content of a part of the page: a bar, a chip or a flat view. */
export interface ToolPlace<S extends Specimen = Specimen, G extends Plant = Plant> {
	readonly title: string;
	draw(context: EditorContext<S, G>): unknown;
}

/** A wide pane for a text: to the left of the 3-D view in place of the flat views; on a phone in place of the sheet. */
export interface ToolPane<S extends Specimen = Specimen, G extends Plant = Plant> extends ToolPlace<S, G> {
	/** Returns whether the pane is open. */
	open(context: EditorContext<S, G>): boolean;
	/** Reports a fault of the text as a notice while the pane is closed; an open pane shows the fault itself. */
	report(context: EditorContext<S, G>, fault: Fault): void;
}

/** A plant that a tool shows in place of the document's plant, and the specimen it grew from. */
export interface SubstitutePlant {
	readonly grown: Plant;
	readonly from: Specimen;
}

/** The 3-D view as tools use it. */
export interface ToolView {
	readonly canvas: HTMLCanvasElement;
	readonly camera: Camera;
	/** Whether pointers turn the plant. A tool sets this to false while it drags something. */
	orbiting: boolean;
	/**
	 * Sets whether the view follows the plant only to keep all of it in the picture, even while orbiting is off, and
	 * never comes nearer.
	 */
	keepWhole(on: boolean): void;
	/**
	 * Adds an object to the scene, in the plant's metres.
	 * @param isPictured whether pictures show it; they leave out editing aids
	 */
	addOverlay(object: Object3D, isPictured?: boolean): void;
	removeOverlay(object: Object3D): void;
	requestRender(): void;
	/**
	 * Returns the pick id at a point of the canvas (CSS pixels from its top left corner); undefined if there is
	 * nothing.
	 */
	pick(x: number, y: number): number | undefined;
	/** Marks the part with a pick id, and softly the ids of its group; undefined removes the mark. */
	mark(picked: number | undefined, group?: ReadonlySet<number>): void;
	/** Returns the ray through a point of the canvas (CSS pixels from its top left corner), in the plant's metres. */
	rayThrough(x: number, y: number): PointerRay;
	/** Returns the position of a point of the plant on the canvas, in CSS pixels from its top left corner. */
	project(at: PointerRay["origin"]): { x: number; y: number };
	/**
	 * Calls a listener after every draw, so that overlays can follow the plant.
	 * @returns function that removes the listener
	 */
	onDrawn(listener: () => void): () => void;
	/**
	 * Shows a plant in place of the document's; undefined shows the document's plant again. Pictures and files are
	 * always of the document's.
	 */
	showSubstitute(plant: SubstitutePlant | undefined): void;
	/** Places the camera at a position, looking at another, in metres; undefined shows the whole plant again. */
	look(from: { readonly eye: PointerRay["origin"]; readonly towards: PointerRay["origin"] } | undefined): void;
	/** Sets one of the renderer's modes; undefined sets the first one. */
	setMode(mode: string | undefined): void;
}

/** A tool's interaction with the canvas. Exists from the loading of the 3-D view until another model is opened. */
export interface ToolInteraction<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** Called after every change of the state and of the theme. */
	update(state: EditorState<S, G>): void;
	dispose(): void;
}

/** A tool of a model. All members below are optional; `name`, `initial` and `recall` (Stateful) define its state. */
export interface Tool<S extends Specimen = Specimen, G extends Plant = Plant, T = unknown> extends Stateful<T> {
	/** Returns whether the tool applies to a specimen; absent: always. If not, no part of the tool is shown. */
	applies?(specimen: S): boolean;
	/** Action of the button and of the key. */
	press?(context: EditorContext<S, G>): void;
	/** Button on the 3-D view. */
	readonly button?: ToolButton<S, G>;
	/** Key that triggers `press` from anywhere on the page. */
	readonly key?: ToolKey;
	/** Returns whether the tool currently uses letter keys itself; the page's single-letter keys are then inactive. */
	holdsLetters?(context: EditorContext<S, G>): boolean;
	/** Controls in the panel, above or below the controls of a group. */
	readonly panel?: ToolPanel<S, G>;
	/** Numbers of the plant that are no parameter, which the panel shows first among the basics. */
	quantities?(specimen: S): readonly Quantity<S, G>[];
	/** Bar below the 3-D view. */
	readonly bar?: ToolPlace<S, G>;
	/** Card over the lower edge of the 3-D view: describes the chosen part and offers actions on it. */
	readonly chip?: ToolPlace<S, G>;
	/** Files that the tool accepts by drag and drop, anywhere on the page. */
	readonly drop?: ToolDrop<S, G>;
	/** Flat view: to the left of the 3-D view; on a phone in its place. */
	readonly editor?: ToolPlace<S, G>;
	/** Pane for a text. */
	readonly pane?: ToolPane<S, G>;
	/** Further keys of the tool, listed in the help. */
	readonly keys?: readonly { readonly keys: readonly string[]; readonly description: string }[];
	/** Keys of the parameters that the tool controls; the panel shows no controls for these. */
	readonly parameters?: readonly string[];
	/**
	 * Extends a change before it is applied, in addition to the fields' own rules: locked sides, for example, change
	 * together.
	 */
	follow?(change: Change, context: EditorContext<S, G>): Change;
	/** Starts the tool's interaction with the canvas; called once the 3-D view has loaded. */
	interaction?(view: ToolView, context: EditorContext<S, G>): ToolInteraction<S, G>;
	/** Actions offered if the document cannot be grown, such as restoring the built-in grammar. */
	readonly remedies?: readonly { readonly label: string; press(context: EditorContext<S, G>): void }[];
	/** Stops running animations, because the document is about to be saved. */
	rest?(context: EditorContext<S, G>): void;
	/**
	 * Called when the model is opened.
	 * @returns function that is called when another model is opened
	 */
	start?(context: EditorContext<S, G>): () => void;
}

/** Files that a tool accepts, wherever on the page they are dropped. */
export interface ToolDrop<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** Description shown while a file is dragged over the page: "a picture of a leaf is traced". */
	readonly description: string;
	/**
	 * Returns whether the tool handles a file, by its name and type; also true if the tool can explain why the file is
	 * unsuitable.
	 */
	takes(file: File): boolean;
	/** Handles a dropped file that contains no specimen. */
	take(context: EditorContext<S, G>, file: File): void;
}

/** Topic of notices about a document that does not grow; the next plant removes them. */
export const GROWTH_TOPIC = "growth";

/** Topic of notices about imported files; a new one replaces the last. */
export const FILE_TOPIC = "file";

/** A row of the readout that the core does not measure. */
export interface ReadoutRow {
	/** Group of measures in which the row is the last. */
	readonly group: string;
	readonly key: string;
	readonly label: string;
	readonly help: string;
	readonly text: string;
	readonly oiv?: number;
	readonly unchecked?: string;
	readonly found?: { readonly note: number; readonly words: string };
}

/** The user interface of a model, besides the sliders of its table. */
export interface ModelUi<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** Tools in display order. */
	readonly tools: readonly Tool<S, G>[];
	/** Draws further content of the readout, between the measures and the fingerprint. */
	readout?(grown: G, specimen: S): unknown;
	/** Returns rows added to the measures. */
	rows?(specimen: S): readonly ReadoutRow[];
	/** Returns the caption of the picture if tools change the picture; absent: the model's own words. */
	caption?(grown: G, context: EditorContext<S, G>): string;
	/** Returns warnings about unmet requests, one line each; listed over the picture of the plant. */
	warnings?(grown: G, specimen: S): readonly string[];
	/** Section of the help: usage, and the paper that the model follows. */
	readonly about?: unknown;
}
