import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import { type History, startHistory } from "../specimen/history";
import type { Specimen } from "../specimen/specimen";
import type { EditorState } from "../ui/editor_context";
import type { ModelUi } from "../ui/tool";
import type { ToolStates } from "./tool_states";
import type { Failure, Notice } from "./types";
import type { UiState } from "./ui_state";

/** What is in the 3-D view: the last plant that grew, of whatever model. */
export interface ShownPlant {
	readonly model: PageModel;
	readonly grown: Plant;
	/** The specimen it grew from. */
	readonly from: Specimen;
}

export interface StudioState extends EditorState {
	readonly model: PageModel;
	/** The model's tools and words; undefined until they have come. */
	readonly modelUi: ModelUi | undefined;
	readonly history: History;
	/** Stays whatever goes wrong. */
	readonly shown: ShownPlant | undefined;
	/** Whether a growth is under way, so that what is shown is not yet what is on the controls. */
	readonly pending: boolean;
	/** Why there is no plant, in place of one. */
	readonly failure: Failure | undefined;
	readonly notices: readonly Notice[];
	readonly ui: UiState;
	/** What models' tools keep. */
	readonly tools: ToolStates;
	/** Models whose presets the gallery shows. */
	readonly catalogue: readonly PageModel[];
	/** Takes a picture of the 3-D view, as PNG, while there is one. */
	readonly picture: ((options?: PictureOptions) => Promise<Blob>) | undefined;
	/** Whether the system is dark. */
	readonly systemDark: boolean;
}

/** What is wanted of a picture. */
export interface PictureOptions {
	/** Pixels; twice the page's where absent. */
	readonly height?: number;
	/** Whether nothing is to stand behind the plant. */
	readonly alone?: boolean;
}

/** What the studio opens with. */
export type Opening = Pick<StudioState, "model" | "specimen" | "ui" | "systemDark">;

/** The state of a page that has just been opened. */
export function opened(opening: Opening): StudioState {
	return inStep({
		...opening,
		modelUi: undefined,
		history: startHistory(opening.specimen),
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
	});
}

/**
 * The look of what is shown: that on the controls, since colours change without growing. While what is on them is another preset, which
 * has yet to grow, it is the look that the plant in view has grown with.
 */
export function lookOf({ model, from }: ShownPlant, now: Pick<StudioState, "model" | "specimen">): Specimen["look"] {
	return model === now.model && from.preset === now.specimen.preset ? now.specimen.look : from.look;
}

/** What follows from the rest of the state, brought into step with it. */
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
