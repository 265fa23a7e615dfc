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
import { text } from "./messages.generated";
import { EMPTY_MODEL_UI, ModelUis } from "./model_uis";
import { afterChange, withNotice, withoutTopic } from "./notice_list";
import type { StudioServices } from "./studio_services";
import { inStep, type Opening, opened, type StudioState, type ViewAid } from "./studio_state";
import { stateOf, withState, withTools } from "./tool_states";
import type { Failure, RestoredFrom } from "./types";
import { MAX_FAVOURITES, MAX_RECENT_PRESETS, type UiState } from "./ui_state";

/** Time that brief notices stay, milliseconds. */
const BRIEF = 4000;
const DRAG = "drag";

/**
 * Holds the page's state. A part of the page calls an action, the action replaces the state, and every part draws the
 * new state. The states of models' tools are here, too, as opaque data.
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

	/** The present state; another object after every change. */
	get state(): StudioState {
		return this.#state;
	}

	/** The published preset of the current specimen. */
	get preset(): Specimen {
		const { model, specimen } = this.#state;
		if (this.#preset?.model !== model.name || this.#preset.preset !== specimen.preset) {
			this.#preset = fromPreset(model, specimen.preset);
		}
		return this.#preset;
	}

	/** Calls back after every change of the state; returns a function that ends it. */
	subscribe(listener: () => void): () => void {
		this.#listeners.add(listener);
		return () => this.#listeners.delete(listener);
	}

	// The document.

	/** Applies a change during a gesture; all changes of a gesture are one undo step. */
	edit(change: Change, gesture = DRAG): void {
		this.#applyHistory(histories.change(this.#state.history, this.#withFollowUps(change), gesture, change.run));
	}

	/** Ends a gesture, or the one in progress: the next change is another undo step. */
	settle(gesture?: string): void {
		if (gesture !== undefined && gesture !== this.#state.history.gesture) return;
		this.#applyHistory(histories.settle(this.#state.history));
		this.#reportSettled();
	}

	/** Applies a change as one undo step. */
	set(change: Change): void {
		this.replace(this.#withFollowUps(change));
	}

	/** Replaces the document as one undo step. */
	replace(specimen: Specimen): void {
		this.#applyStep(histories.change(this.#state.history, specimen));
	}

	/**
	 * Starts a new history with a document from outside, of the model that the page opened with. @param from its source,
	 * for notices
	 */
	open(restored: Restored, from: RestoredFrom): void {
		const { specimen } = restored;
		this.#update({ specimen, history: histories.startHistory(specimen), opened: specimen });
		this.#requestGrowth();
		this.#reportSettled();
		this.#report(restored, from);
	}

	/** Replaces the document by one from outside, as one undo step. @param from its source, the topic of notices */
	take(model: PageModel, restored: Restored, from: RestoredFrom): void {
		this.#models.set(model.name, model);
		this.#openStep(restored.specimen);
		this.retract(from);
		this.#report(restored, from);
	}

	/**
	 * Follows the browser's Back and Forward. If the document equals the previous or the next step, undoes or redoes;
	 * otherwise takes it as a new step.
	 */
	visit(model: PageModel, restored: Restored, from: RestoredFrom): void {
		const { past, future } = histories.settle(this.#state.history);
		const leadsTo = (step: Specimen | undefined) => step !== undefined && sameSpecimen(step, restored.specimen);
		if (leadsTo(past.at(-1))) this.undo();
		else if (leadsTo(future[0])) this.redo();
		else this.take(model, restored, from);
	}

	/** Opens a published preset, of this model by default. */
	choosePreset(name: string, model: PageModel = this.#state.model): void {
		this.#models.set(model.name, model);
		this.#openStep(fromPreset(model, name));
		const key = `${model.name}/${name}`;
		const { recentPresets } = this.#state.ui;
		this.setUi({ recentPresets: [key, ...recentPresets.filter((each) => each !== key)].slice(0, MAX_RECENT_PRESETS) });
	}

	/** Resets the document to its published preset. */
	reset(): void {
		this.#openStep(this.preset);
	}

	/**
	 * Adds the steps of the history from before the page was loaded again (session/tab_history.ts). If its present has
	 * parts that the address could not hold, it replaces the document.
	 * @param models the models of its specimens
	 */
	continueHistory(
		earlier: Pick<histories.SpecimenHistory, "past" | "present" | "future">,
		models: Iterable<PageModel>,
	): void {
		for (const model of models) if (!this.#models.has(model.name)) this.#models.set(model.name, model);
		const history = histories.continued(this.#state.history, earlier);
		if (history.present === this.#state.specimen) this.#update({ history });
		else {
			this.retract("link");
			this.#update({ opened: history.present });
			this.#applyHistory(history);
		}
	}

	/** Returns the model of a specimen of this page; undefined where it is not loaded. */
	modelOf({ model }: Specimen): PageModel | undefined {
		return this.#models.get(model);
	}

	/** Sets another seed. */
	newVariation(): void {
		this.set({ seed: otherSeed(this.#state.specimen.seed) });
	}

	/** Undoes the last step. */
	undo(): void {
		this.#applyStep(histories.undo(this.#state.history));
	}

	/** Redoes the step that was undone last. */
	redo(): void {
		this.#applyStep(histories.redo(this.#state.history));
	}

	// Growth, reported by growing.ts.

	/** Shows a plant that has grown from a specimen. */
	grew(grown: Plant, from: Specimen): void {
		const model = this.#models.get(from.model);
		if (!model) return;
		const { measures = model === this.#state.model ? this.#state.measures : undefined } = grown;
		this.#update({ shown: { model, grown, from }, measures, failure: undefined });
	}

	/** Sets whether the page shows that a growth takes long. */
	setGrowing(growing: boolean): void {
		if (growing !== this.#state.growing) this.#update({ growing });
	}

	/**
	 * Records that the newest growth has ended, successfully or not.
	 * @param fault the core's error about the document
	 */
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

	/** Shows a notice. */
	notify(title: string, details: readonly string[] = [], options: NoticeOptions = {}): void {
		const id = ++this.#noticeId;
		this.#update({ notices: withNotice(this.#state.notices, { id, title, details, ...options }) });
		if (options.brief) setTimeout(() => this.dismiss(id), BRIEF);
	}

	/** Removes a notice. */
	dismiss(id: number): void {
		this.#update({ notices: this.#state.notices.filter((notice) => notice.id !== id) });
	}

	/** Removes the notices about a topic. */
	retract(topic: string): void {
		const notices = withoutTopic(this.#state.notices, topic);
		if (notices !== this.#state.notices) this.#update({ notices });
	}

	/** Changes the state of the interface and stores it. */
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

	/** Adds a preset to the favourites, or removes it. @param key as preset_cards.ts writes it */
	toggleFavourite(key: string): void {
		const { favourites } = this.#state.ui;
		const others = favourites.filter((each) => each !== key);
		this.setUi({ favourites: others.length < favourites.length ? others : [...others, key].slice(-MAX_FAVOURITES) });
	}

	/** Records that the system's colour scheme has changed. */
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

	/** Sets the 3-D view; undefined while there is none. */
	showView(view: StudioState["view"]): void {
		this.#update({ view });
	}

	/** Uses an aid in the 3-D view in place of the last one; undefined uses none. */
	setAid(aid: ViewAid | undefined): void {
		if (aid !== this.#state.aid) this.#update({ aid });
	}

	/** Uses an aid, or stops using it. */
	toggleAid(aid: ViewAid): void {
		this.setAid(this.#state.aid === aid ? undefined : aid);
	}

	/** Returns the state of a tool. */
	toolState<T>(tool: Stateful<T>): T {
		return stateOf(this.#state.tools, this.#ownerOf(tool), tool);
	}

	/** Sets the state of a tool; the states of some tools are stored for the next visit. */
	setToolState<T>(tool: Stateful<T>, state: T): void {
		const owner = this.#ownerOf(tool);
		const { ui } = this.#state;
		this.#update({ tools: withState(this.#state.tools, owner, tool, state) });
		if (tool.recall) this.setUi({ tools: withState(ui.tools, owner, tool, state) });
	}

	/** Returns the name of the model that has a tool; the present model for tools of the page. */
	#ownerOf(tool: Stateful<unknown>): string {
		return this.#owners.get(tool) ?? this.#state.model.name;
	}

	/** Notifies of the parts of a document that could not be used. */
	#report({ notes }: Restored, from: RestoredFrom): void {
		const lines = notes.map((note) => note.text);
		const options = { topic: from, untouched: true };
		if (lines.length > 0) this.notify(text("restored_in_part", { source: from }), lines, options);
	}

	/** Returns the document after a change, and after the further changes that tools derive from it. */
	#withFollowUps(change: Change): Specimen {
		const { model, specimen, modelUi } = this.#state;
		const whole = modelUi?.tools.reduce((done, tool) => tool.follow?.(done, this) ?? done, change);
		return apply(model, specimen, whole ?? change);
	}

	/** Replaces the document by one that is opened, as one undo step. */
	#openStep(specimen: Specimen): void {
		this.#update({ opened: specimen });
		this.replace(specimen);
	}

	/** Makes a history current and reports the document as at rest. */
	#applyStep(history: histories.SpecimenHistory): void {
		this.#applyHistory(history);
		this.#reportSettled();
	}

	/** Writes the document at rest to the address bar. */
	#reportSettled(): void {
		this.#services.settled(this.#state.model, this.#state.specimen);
	}

	/**
	 * Makes a history's present the current specimen: switches the model where it is another one, and requests a growth
	 * if it grows differently, or if the last growth was a preview, without measures, and the drag has ended.
	 */
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

	/** Loads the UI of a model; without its script, notifies and returns an empty UI. */
	#modelUiOf(model: PageModel): Promise<ModelUi> {
		return this.#modelUis.of(model).catch(() => {
			const details = [text("still_usable"), text("fetch_failed_advice")];
			const again = () => void this.#loadModelUi(model);
			this.notify(text("tools_failed"), details, { again });
			return EMPTY_MODEL_UI;
		});
	}

	/** Changes the state and notifies all listeners. */
	#update(patch: Partial<StudioState>): void {
		this.#state = inStep({ ...this.#state, ...patch });
		for (const listener of this.#listeners) listener();
	}
}
