import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import { type SpecimenHistory, startHistory } from "../specimen/history";
import type { Specimen } from "../specimen/specimen";
import type { EditorState } from "../ui/editor_context";
import type { ModelUi } from "../ui/tool";
import type { ToolStates } from "./tool_states";
import type { Failure, Notice } from "./types";
import type { UiState } from "./ui_state";

/** The plant in the 3-D view: the last that grew, of any model. */
export interface ShownPlant {
	readonly model: PageModel;
	readonly grown: Plant;
	/** The specimen that the plant grew from. */
	readonly from: Specimen;
}

export interface StudioState extends EditorState {
	readonly model: PageModel;
	/** The model's tools and texts; undefined until they are loaded. */
	readonly modelUi: ModelUi | undefined;
	readonly history: SpecimenHistory;
	/** The specimen that was opened last: by a link, a file, a saved plant or a preset. */
	readonly opened: Specimen;
	/** Stays when a later growth fails. */
	readonly shown: ShownPlant | undefined;
	/** Whether a growth is running: the plant in view is older than the document. */
	readonly pending: boolean;
	/** Shown in place of a plant. */
	readonly failure: Failure | undefined;
	readonly notices: readonly Notice[];
	readonly ui: UiState;
	/** States of models' tools. */
	readonly tools: ToolStates;
	/** Models whose presets the gallery shows. */
	readonly catalogue: readonly PageModel[];
	/** Takes a picture of the 3-D view, as PNG, while there is one. */
	readonly picture: ((options?: PictureOptions) => Promise<Blob>) | undefined;
	/** The 3-D view, while there is one. */
	readonly view: StageView | undefined;
	/** The aid in use in the 3-D view. */
	readonly aid: ViewAid | undefined;
	/** Whether the system's colour scheme is dark. */
	readonly systemDark: boolean;
}

/**
 * An aid for looking at the plant: the measuring tape, the presentation, which shows nothing else, or the view in the
 * user's room.
 */
export type ViewAid = "tape" | "presentation" | "room";

/** The 3-D view as the page's actions use it. */
export interface StageView {
	/** Shows the whole plant again. */
	reset(): void;
	/** Whether the shown plant can sway in the wind. */
	readonly canBlow: boolean;
	wind: boolean;
}

/** Options of a picture of the 3-D view. */
export interface PictureOptions {
	/** Pixels; by default twice the height of the view. */
	readonly height?: number;
	/** Whether the background is transparent. */
	readonly alone?: boolean;
}

/** The initial part of the studio's state. */
export type Opening = Pick<StudioState, "model" | "specimen" | "ui" | "systemDark">;

/** Returns the state of a page that has just been opened. */
export function opened(opening: Opening): StudioState {
	return inStep({
		...opening,
		modelUi: undefined,
		history: startHistory(opening.specimen),
		opened: opening.specimen,
		shown: undefined,
		grown: undefined,
		grownFrom: undefined,
		measures: undefined,
		held: false,
		dark: false,
		pending: false,
		growing: false,
		fault: undefined,
		failure: undefined,
		notices: [],
		tools: {},
		catalogue: [opening.model],
		picture: undefined,
		view: undefined,
		aid: undefined,
	});
}

/**
 * Returns the look of the plant in view: that on the controls, since colours change without growing. While another
 * preset is on the controls and has yet to grow, the look that the plant in view grew with.
 */
export function lookOf({ model, from }: ShownPlant, now: Pick<StudioState, "model" | "specimen">): Specimen["look"] {
	return model === now.model && from.preset === now.specimen.preset ? now.specimen.look : from.look;
}

/** Returns the state with its derived fields computed anew. */
export function inStep(state: StudioState): StudioState {
	const { model, shown, history, ui, systemDark } = state;
	const own = shown?.model === model ? shown : undefined;
	return {
		...state,
		grown: own?.grown,
		grownFrom: own?.from,
		measures: own && state.measures,
		held: history.gesture !== undefined,
		dark: ui.theme === "system" ? systemDark : ui.theme === "dark",
	};
}
