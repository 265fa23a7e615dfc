/**
 * What a model brings to the page besides the table's sliders. A tool has as many faces as it needs: a button on the
 * 3-D view, a key, a place in the panel, a bar below the view, a flat view of its own, a pane, hands on the canvas. The studio
 * shows each where it belongs and knows none of them.
 */

import type { SVGTemplateResult } from "lit";
import type { Camera, Object3D } from "three";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import type { Group } from "../specimen/table";
import type { Change, EditorContext, EditorState, Fault, Stateful } from "./editor_context";
import type { Ray } from "./handles/handle_ways";

/** A button on the 3-D view. */
export interface ToolButton<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** A line drawing on a 20 × 20 field (icons.ts). */
	readonly icon: SVGTemplateResult;
	readonly label: string;
	/** Whether it is switched on; absent for a button that does something once. */
	pressed?(context: EditorContext<S, G>): boolean;
}

/** A letter for the whole page. */
export interface ToolKey {
	/** A small letter that no other tool of the model has, nor the page (n, ?). */
	readonly letter: string;
	/** What the help says of it. */
	readonly does: string;
}

/** A place in the panel. */
export interface ToolPanel<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** One of the table's groups by its key, or one of the tool's own, which stands before them. */
	readonly group: string | Group;
	/** Above the group's controls or below them. */
	readonly place: "above" | "below";
	draw(context: EditorContext<S, G>): unknown;
}

/** A bar below the 3-D view, or a flat view: at the left of it, on a phone in its place. */
export interface ToolPlace<S extends Specimen = Specimen, G extends Plant = Plant> {
	readonly title: string;
	draw(context: EditorContext<S, G>): unknown;
}

/** A wide place for reading and writing: left of the 3-D view instead of the flat views, on a phone instead of the sheet. */
export interface ToolPane<S extends Specimen = Specimen, G extends Plant = Plant> extends ToolPlace<S, G> {
	open(context: EditorContext<S, G>): boolean;
	/** Says what is wrong with the text while the pane is closed; an open one shows it. */
	report(context: EditorContext<S, G>, fault: Fault): void;
}

/** A plant that a tool shows in place of the document's, and what it has grown from. */
export interface SubstitutePlant {
	readonly grown: Plant;
	readonly from: Specimen;
}

/** What a tool has of the 3-D view. */
export interface ToolView {
	readonly canvas: HTMLCanvasElement;
	readonly camera: Camera;
	/** Whether pointers turn the plant. A tool that takes hold of something switches this off meanwhile. */
	orbiting: boolean;
	/** Whether from now on the view follows a plant only to keep all of it in the picture, orbiting or not, and never comes nearer. */
	keepWhole(on: boolean): void;
	/** Adds something to the scene, in the plant's metres. */
	addOverlay(object: Object3D): void;
	removeOverlay(object: Object3D): void;
	requestRender(): void;
	/** What is under a point of the canvas (CSS pixels from its top left corner), by the model's own number for it. */
	pick(x: number, y: number): number | undefined;
	/** Marks that, by the same number, and softly the cells that it is one of; nothing where undefined. */
	mark(picked: number | undefined, whole?: ReadonlySet<number>): void;
	/** The line of sight through a point of the canvas (CSS pixels from its top left corner). */
	rayThrough(x: number, y: number): Ray;
	/** Where a place of the plant is seen: CSS pixels from the canvas's top left corner. */
	project(at: Ray["origin"]): { x: number; y: number };
	/** Calls back after every draw, for what stands where something is seen. @returns what ends it */
	onDrawn(listener: () => void): () => void;
	/** Shows a plant in place of the document's, which comes back where undefined; pictures and files are of the document's all the same. */
	showSubstitute(plant: SubstitutePlant | undefined): void;
	/** Has the eye stand somewhere and look towards a place, metres; undefined brings back the whole plant. */
	look(from: { readonly eye: Ray["origin"]; readonly towards: Ray["origin"] } | undefined): void;
	/** One of the model's figure's ways of showing; the first where undefined. */
	setMode(mode: string | undefined): void;
}

/** A tool's hands on the canvas, from when the view has come until the model goes. */
export interface ToolInteraction<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** After every change of the state, and of the theme. */
	update(state: EditorState<S, G>): void;
	dispose(): void;
}

export interface Tool<S extends Specimen = Specimen, G extends Plant = Plant, T = unknown> extends Stateful<T> {
	/** Whether it means anything to this specimen; where not, none of its faces is shown. */
	applies?(specimen: S): boolean;
	/** What the button and the key do. */
	press?(context: EditorContext<S, G>): void;
	readonly button?: ToolButton<S, G>;
	readonly key?: ToolKey;
	/** Whether letters are its own now: those of the page rest meanwhile. */
	holdsLetters?(context: EditorContext<S, G>): boolean;
	readonly panel?: ToolPanel<S, G>;
	readonly bar?: ToolPlace<S, G>;
	/** Over the 3-D view's lower edge: what is said of something that is chosen there, the ways on from it. */
	readonly chip?: ToolPlace<S, G>;
	readonly drop?: ToolDrop<S, G>;
	readonly editor?: ToolPlace<S, G>;
	readonly pane?: ToolPane<S, G>;
	/** Further keys that its faces know, for the help. */
	readonly keys?: readonly { readonly keys: readonly string[]; readonly does: string }[];
	/** Parameters whose control it is: the panel shows none for them. */
	readonly parameters?: readonly string[];
	/** What a change brings along, besides what the table's details do: locked sides follow each other. */
	follow?(change: Change, context: EditorContext<S, G>): Change;
	interaction?(view: ToolView, context: EditorContext<S, G>): ToolInteraction<S, G>;
	/** Ways out where this specimen cannot be grown. */
	readonly remedies?: readonly { readonly words: string; press(context: EditorContext<S, G>): void }[];
	/** Brings what runs by itself to rest: something is to be saved. */
	rest?(context: EditorContext<S, G>): void;
	/** Works while the model is open; returns what ends it. */
	start?(context: EditorContext<S, G>): () => void;
}

/** Files that a tool can use, wherever on the page they are dropped. */
export interface ToolDrop<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** What becomes of them, said while one hovers: "a picture of a leaf is traced". */
	readonly words: string;
	/** Whether it can say something of a file by its name and type, be it why the file is none for it. */
	takes(file: File): boolean;
	/** Where no plant is in the file. */
	take(context: EditorContext<S, G>, file: File): void;
}

/** What notices about a document that does not grow are of: the next plant takes them back. */
export const GROWTH_TOPIC = "growth";

/** What notices about files brought to the page are of: one stands at a time. */
export const FILE_TOPIC = "file";

/** A line of the read-out that is not measured by the core. */
export interface ReadoutRow {
	/** The group of measures that it closes. */
	readonly group: string;
	readonly key: string;
	readonly label: string;
	readonly help: string;
	readonly text: string;
	readonly oiv?: number;
	readonly unchecked?: string;
	readonly found?: { readonly note: number; readonly words: string };
}

/** The page's side of a model: what the studio shows of it besides the table. */
export interface ModelUi<S extends Specimen = Specimen, G extends Plant = Plant> {
	/** In the order in which they are shown. */
	readonly tools: readonly Tool<S, G>[];
	/** What the read-out says between the measures and the fingerprint. */
	readout?(grown: G, specimen: S): unknown;
	/** Rows that join the measures. */
	rows?(specimen: S): readonly ReadoutRow[];
	/** The words below the picture, where tools change what is seen; else the model's `words`. */
	caption?(grown: G, context: EditorContext<S, G>): string;
	/** What the plant lacks of what was asked for, a line each: said over the picture while it is shown. */
	warnings?(grown: G, specimen: S): readonly string[];
	/** What the help says of it: what to do, whose paper it follows. */
	readonly about?: unknown;
}
