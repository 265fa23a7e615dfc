import type { PageModel } from "../models/page_model";
import type { Plant } from "../plant/plant";
import { fromPreset } from "../specimen/from_preset";
import * as histories from "../specimen/history";
import type { Restored } from "../specimen/restore";
import { growsAlike, sameSpecimen } from "../specimen/same";
import type { Specimen } from "../specimen/specimen";
import { apply, otherSeed } from "../ui/change";
import type { Change, EditorContext, Fault, NoticeOptions, Stateful } from "../ui/editor_context";
import type { ModelUi } from "../ui/tool";
import { EMPTY_MODEL_UI, ModelUis } from "./model_uis";
import { afterChange, withNotice, withoutTopic } from "./notice_list";
import type { StudioServices } from "./studio_services";
import { inStep, type Opening, opened, type StudioState } from "./studio_state";
import { stateOf, withState, withTools } from "./tool_states";
import { type Failure, TRY_AGAIN } from "./types";
import type { UiState } from "./ui_state";

/** Time that brief notices stay, milliseconds. */
const BRIEF = 4000;
const DRAG = "drag";

/**
 * Holds the page's state. A part of the page calls an action, the action replaces the state, and every part draws the new state.
 * The states of models' tools are here, too, as opaque data.
 */
export class Studio implements EditorContext {
	#state: StudioState;
	/** Passed on from the services (studio_services.ts). */
	readonly measure: StudioServices["measure"];
	readonly growOffscreen: StudioServices["growOffscreen"];
	readonly cancel: StudioServices["cancel"];
	readonly #listeners = new Set<() => void>();
	readonly #services: StudioServices;
	/** Models of all specimens of this session, by name. */
	readonly #models = new Map<string, PageModel>();
	readonly #modelUis = new ModelUis();
	/** The name of the model of each tool. */
	readonly #owners = new Map<Stateful<unknown>, string>();
	/** Functions that end the tools started by `Tool.start`. */
	#ends: (() => void)[] = [];
	#noticeId = 0;
	/** Whether the last request was for a measured plant, not for a preview. */
	#isMeasured = true;
	#preset: Specimen | undefined;

	constructor(opening: Opening, services: StudioServices) {
		this.#services = services;
		({ measure: this.measure, growOffscreen: this.growOffscreen, cancel: this.cancel } = services);
		this.#models.set(opening.model.name, opening.model);
		this.#state = opened(opening);
		void this.#loadModelUi(opening.model);
	}

	get state(): StudioState {
		return this.#state;
	}

	get preset(): Specimen {
		const { model, specimen } = this.#state;
		if (this.#preset?.model !== model.name || this.#preset.preset !== specimen.preset) {
			this.#preset = fromPreset(model, specimen.preset);
		}
		return this.#preset;
	}

	subscribe(listener: () => void): () => void {
		this.#listeners.add(listener);
		return () => this.#listeners.delete(listener);
	}

	// The document.

	edit(change: Change, gesture = DRAG): void {
		this.#applyHistory(histories.change(this.#state.history, this.#withFollowUps(change), gesture, change.run));
	}

	settle(gesture?: string): void {
		if (gesture !== undefined && gesture !== this.#state.history.gesture) return;
		this.#applyHistory(histories.settle(this.#state.history));
		this.#reportSettled();
	}

	set(change: Change): void {
		this.replace(this.#withFollowUps(change));
	}

	replace(specimen: Specimen): void {
		this.#applyStep(histories.change(this.#state.history, specimen));
	}

	/** Starts a new history with a document from outside, of the model that the page opened with. @param from its source, for notices */
	open(restored: Restored, from: string): void {
		const { specimen } = restored;
		this.#update({ specimen, history: histories.startHistory(specimen) });
		this.#requestGrowth();
		this.#reportSettled();
		this.#report(restored, from);
	}

	/** Replaces the document by one from outside, as one undo step. @param from its source, the topic of notices */
	take(model: PageModel, restored: Restored, from: string): void {
		this.#models.set(model.name, model);
		this.replace(restored.specimen);
		this.retract(from);
		this.#report(restored, from);
	}

	/**
	 * Follows the browser's Back and Forward. If the document equals the previous or the next step, undoes or redoes; otherwise takes it
	 * as a new step.
	 */
	visit(model: PageModel, restored: Restored, from: string): void {
		const { past, future } = histories.settle(this.#state.history);
		const leadsTo = (step: Specimen | undefined) => step !== undefined && sameSpecimen(step, restored.specimen);
		if (leadsTo(past.at(-1))) this.undo();
		else if (leadsTo(future[0])) this.redo();
		else this.take(model, restored, from);
	}

	/** Opens a published preset, of this model by default. */
	choosePreset(name: string, model: PageModel = this.#state.model): void {
		this.#models.set(model.name, model);
		this.replace(fromPreset(model, name));
	}

	/** Resets the document to its published preset. */
	reset(): void {
		this.replace(this.preset);
	}

	newVariation(): void {
		this.set({ seed: otherSeed(this.#state.specimen.seed) });
	}

	undo(): void {
		this.#applyStep(histories.undo(this.#state.history));
	}

	redo(): void {
		this.#applyStep(histories.redo(this.#state.history));
	}

	// Growth, reported by growing.ts.

	grew(grown: Plant, from: Specimen): void {
		const model = this.#models.get(from.model);
		if (!model) return;
		const { measures = model === this.#state.model ? this.#state.measures : undefined } = grown;
		this.#update({ shown: { model, grown, from }, measures, failure: undefined });
	}

	setGrowing(growing: boolean): void {
		if (growing !== this.#state.growing) this.#update({ growing });
	}

	/** The newest growth has ended, successfully or not. @param fault the core's error about the document */
	caughtUp(fault?: Fault): void {
		this.#update({ pending: false, fault });
	}

	/** Shows a failure in place of a plant. */
	fail(failure: Failure): void {
		this.#update({ failure });
	}

	/** Grows again, after a failure. */
	growAgain(): void {
		this.#requestGrowth();
	}

	// The page.

	notify(title: string, details: readonly string[] = [], options: NoticeOptions = {}): void {
		const id = ++this.#noticeId;
		this.#update({ notices: withNotice(this.#state.notices, { id, title, details, ...options }) });
		if (options.brief) setTimeout(() => this.dismiss(id), BRIEF);
	}

	dismiss(id: number): void {
		this.#update({ notices: this.#state.notices.filter((notice) => notice.id !== id) });
	}

	/** Removes the notices about a topic. */
	retract(topic: string): void {
		const notices = withoutTopic(this.#state.notices, topic);
		if (notices !== this.#state.notices) this.#update({ notices });
	}

	setUi(patch: Partial<UiState>): void {
		const { ui: before } = this.#state;
		const ui = { ...before, ...patch };
		this.#update({ ui });
		this.#services.remember(ui, before);
	}

	/** Opens or closes a group of the panel. */
	setGroup(key: string, open: boolean): void {
		const { groups } = this.#state.ui;
		if (groups[key] !== open) this.setUi({ groups: { ...groups, [key]: open } });
	}

	setSystemDark(systemDark: boolean): void {
		this.#update({ systemDark });
	}

	/** Sets the models whose presets the gallery shows. */
	list(catalogue: readonly PageModel[]): void {
		this.#update({ catalogue });
	}

	/** Sets the function that takes pictures of the 3-D view; undefined while there is no view. */
	showPicture(picture: StudioState["picture"]): void {
		this.#update({ picture });
	}

	toolState<T>(tool: Stateful<T>): T {
		return stateOf(this.#state.tools, this.#ownerOf(tool), tool);
	}

	setToolState<T>(tool: Stateful<T>, state: T): void {
		const owner = this.#ownerOf(tool);
		const { ui } = this.#state;
		this.#update({ tools: withState(this.#state.tools, owner, tool, state) });
		if (tool.recall) this.setUi({ tools: withState(ui.tools, owner, tool, state) });
	}

	#ownerOf(tool: Stateful<unknown>): string {
		return this.#owners.get(tool) ?? this.#state.model.name;
	}

	/** Notifies of the parts of a document that could not be used. */
	#report({ notes }: Restored, from: string): void {
		const texts = notes.map(({ text }) => text);
		const options = { topic: from, untouched: true };
		if (texts.length > 0) this.notify(`Not everything in the ${from} could be used`, texts, options);
	}

	/** The document after a change, and after the further changes that tools derive from it. */
	#withFollowUps(change: Change): Specimen {
		const { model, specimen, modelUi } = this.#state;
		const whole = modelUi?.tools.reduce((done, tool) => tool.follow?.(done, this) ?? done, change);
		return apply(model, specimen, whole ?? change);
	}

	#applyStep(history: histories.SpecimenHistory): void {
		this.#applyHistory(history);
		this.#reportSettled();
	}

	#reportSettled(): void {
		this.#services.settled(this.#state.model, this.#state.specimen);
	}

	#applyHistory(history: histories.SpecimenHistory): void {
		const { specimen: before, model: left } = this.#state;
		const { present } = history;
		if (history === this.#state.history) return;
		const model = this.#models.get(present.model) ?? left;
		const modelUi = model === left ? this.#state.modelUi : undefined;
		this.#update({ history, specimen: present, model, modelUi, notices: afterChange(this.#state.notices) });
		if (model !== left) void this.#loadModelUi(model);
		if (!growsAlike(before, present) || (!this.#state.held && !this.#isMeasured)) this.#requestGrowth();
	}

	/** Requests growth: a preview without measures during a drag, everything else when it ends. */
	#requestGrowth(): void {
		const { model, specimen, held } = this.#state;
		this.#isMeasured = !held;
		this.#update({ pending: true });
		this.#services.grow(model, specimen, { preview: held });
	}

	/** Loads the tools of a model and starts them; ends those of the last model. */
	async #loadModelUi(model: PageModel): Promise<void> {
		for (const end of this.#ends.splice(0)) end();
		const modelUi = this.#modelUis.known(model) ?? (await this.#modelUiOf(model));
		if (this.#state.model !== model || this.#state.modelUi === modelUi) return;
		for (const tool of modelUi.tools) this.#owners.set(tool, model.name);
		const { tools, ui } = this.#state;
		this.#update({ modelUi, tools: withTools(tools, model.name, modelUi.tools, ui.tools) });
		this.#ends = modelUi.tools.flatMap((tool) => tool.start?.(this) ?? []);
	}

	#modelUiOf(model: PageModel): Promise<ModelUi> {
		return this.#modelUis.of(model).catch(() => {
			const details = ["Sliders and downloads work all the same.", TRY_AGAIN];
			const again = () => void this.#loadModelUi(model);
			this.notify(`The tools of the ${model.noun} could not be fetched`, details, { again });
			return EMPTY_MODEL_UI;
		});
	}

	#update(patch: Partial<StudioState>): void {
		this.#state = inStep({ ...this.#state, ...patch });
		for (const listener of this.#listeners) listener();
	}
}
