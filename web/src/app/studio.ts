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

/** Confirmations stay this long, in milliseconds. */
const BRIEF = 4000;
const DRAG = "drag";

/**
 * The one place where the page's state lives. It flows one way: a part calls an action, the action replaces the state,
 * every part draws the new one. What models' tools keep is here too, and unknown.
 */
export class Studio implements EditorContext {
	#state: StudioState;
	/** What a specimen measures, and what it grows into, without showing it; the end of what grows now. */
	readonly measure: StudioServices["measure"];
	readonly growOffscreen: StudioServices["growOffscreen"];
	readonly cancel: StudioServices["cancel"];
	readonly #listeners = new Set<() => void>();
	readonly #services: StudioServices;
	/** Models of all specimens there have been. */
	readonly #models = new Map<string, PageModel>();
	readonly #modelUis = new ModelUis();
	/** Whose a tool is. */
	readonly #owners = new Map<Stateful<unknown>, string>();
	/** What ends the tools that work by themselves. */
	#ends: (() => void)[] = [];
	#noticeId = 0;
	/** Whether what was last asked for is all there is, and not what does in passing. */
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

	/** Starts with a document from outside, of the model it opened with: there is nothing before it to go back to. */
	open(restored: Restored, from: string): void {
		const { specimen } = restored;
		this.#update({ specimen, history: histories.startHistory(specimen) });
		this.#requestGrowth();
		this.#reportSettled();
		this.#report(restored, from);
	}

	/** Takes a document from outside in place of this one, as one step. */
	take(model: PageModel, restored: Restored, from: string): void {
		this.#models.set(model.name, model);
		this.replace(restored.specimen);
		this.retract(from);
		this.#report(restored, from);
	}

	/**
	 * Follows the browser's Back and Forward: where they lead to the step before this one or after it, that is undone or
	 * done again; else it is a step as any document from outside.
	 */
	visit(model: PageModel, restored: Restored, from: string): void {
		const { past, future } = histories.settle(this.#state.history);
		const leadsTo = (step: Specimen | undefined) => step !== undefined && sameSpecimen(step, restored.specimen);
		if (leadsTo(past.at(-1))) this.undo();
		else if (leadsTo(future[0])) this.redo();
		else this.take(model, restored, from);
	}

	/** A preset as it was published: of this model, or of another. */
	choosePreset(name: string, model: PageModel = this.#state.model): void {
		this.#models.set(model.name, model);
		this.replace(fromPreset(model, name));
	}

	/** The preset as it was published. */
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

	/** The newest growth has ended, one way or the other. @param fault what the core said against the document */
	caughtUp(fault?: Fault): void {
		this.#update({ pending: false, fault });
	}

	/** There is no plant to show, and none comes without a remedy. */
	fail(failure: Failure): void {
		this.#update({ failure });
	}

	/** Asks again, after a failure. */
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

	/** Takes back what was said of something: it holds no more. */
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

	/** Models whose presets the gallery is to show. */
	list(catalogue: readonly PageModel[]): void {
		this.#update({ catalogue });
	}

	/** The 3-D view has come, and takes pictures from now on; or it has gone. */
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

	/** Says what could not be used of a document. */
	#report({ notes }: Restored, from: string): void {
		const texts = notes.map(({ text }) => text);
		const options = { topic: from, untouched: true };
		if (texts.length > 0) this.notify(`Not everything in the ${from} could be used`, texts, options);
	}

	/** The document with a change in it, and with what the tools let follow from it. */
	#withFollowUps(change: Change): Specimen {
		const { model, specimen, modelUi } = this.#state;
		const whole = modelUi?.tools.reduce((done, tool) => tool.follow?.(done, this) ?? done, change);
		return apply(model, specimen, whole ?? change);
	}

	#applyStep(history: histories.History): void {
		this.#applyHistory(history);
		this.#reportSettled();
	}

	#reportSettled(): void {
		this.#services.settled(this.#state.model, this.#state.specimen);
	}

	#applyHistory(history: histories.History): void {
		const { specimen: before, model: left } = this.#state;
		const { present } = history;
		if (history === this.#state.history) return;
		const model = this.#models.get(present.model) ?? left;
		const modelUi = model === left ? this.#state.modelUi : undefined;
		this.#update({ history, specimen: present, model, modelUi, notices: afterChange(this.#state.notices) });
		if (model !== left) void this.#loadModelUi(model);
		if (!growsAlike(before, present) || (!this.#state.held && !this.#isMeasured)) this.#requestGrowth();
	}

	/** While the hand still moves, only the shape is asked for; what is measured follows when it rests. */
	#requestGrowth(): void {
		const { model, specimen, held } = this.#state;
		this.#isMeasured = !held;
		this.#update({ pending: true });
		this.#services.grow(model, specimen, { preview: held });
	}

	/** Puts the tools of a model on the controls, in place of the last one's. */
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
