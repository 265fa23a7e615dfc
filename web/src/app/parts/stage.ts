import { html, nothing } from "lit";
import type { PageModel } from "../../models/page_model";
import { orbitKeys } from "../../render/orbit_keys";
import { fromPreset } from "../../specimen/from_preset";
import { sameSpecimen } from "../../specimen/same";
import { icon } from "../../ui/icons";
import { rove, stopAt } from "../../ui/roving";
import { TOOL_SLOTS, type ToolSlot } from "../../ui/tool";
import { firstDrawing } from "../first_drawing";
import { text } from "../messages.generated";
import { applying } from "../panel_groups";
import { SolidView } from "../solid_view";
import type { Studio } from "../studio";
import type { StageView } from "../studio_state";
import { titleOf } from "../title";
import { type Failure, fetchFailed } from "../types";
import { findRoomSupport } from "../view/room_support";
import type { ViewAids } from "../view/view_aids";
import { offersRoom, openRoom } from "./open_room";
import { StudioPart } from "./studio_part";

interface Trouble {
	readonly title: string;
	readonly details: readonly string[];
	readonly again?: () => void;
}

/** A button on the 3-D view, of the page or of a tool. */
interface StageButton {
	readonly icon: Parameters<typeof icon>[0];
	readonly label: string;
	/** Undefined for a single action. */
	readonly pressed?: boolean | undefined;
	press(): void;
}

/** The 3-D view with its tools and its caption, or a message where there is no picture. */
export class StagePart extends StudioPart {
	/** The reason why there is no picture: no WebGL 2, a lost context, or a script that could not be fetched. */
	#trouble: Trouble | undefined;
	#solid: SolidView | undefined;
	/** The scale bar, the tape, the presentation and the view in the room; their loading starts with the first plant. */
	#aids: Promise<ViewAids> | undefined;
	/** Whether they could not be loaded: the next use tries again. */
	#hasNoAids = false;
	#started = false;
	/** Ends the subscription to the state. */
	#leave: (() => void) | undefined;
	/** Ends listening to Escape (`#pointAtTools`). */
	#leaveTools: () => void = () => {};
	/** Whether an update of the view is scheduled. */
	#due = false;
	/** False while a phone shows another view instead: hidden views are not drawn. */
	#visible = true;
	readonly #resized = new ResizeObserver(([{ contentRect }]) => {
		this.#visible = contentRect.width > 0;
		if (!this.#visible) return;
		this.#solid?.resize();
		this.#follow();
	});

	/** Returns the values whose change redraws the stage. */
	protected override shows({ state }: Studio): readonly unknown[] {
		const { failure, growing, shown, model, modelUi, tools, specimen, ui } = state;
		return [
			failure,
			growing,
			shown,
			model,
			modelUi,
			tools,
			ui.toolNames,
			ui.outdoors,
			state.aid,
			failure && specimen,
			...applying(modelUi?.tools, specimen),
		];
	}

	/** Renders the 3-D view's canvas with caption, messages, tools and progress over it. */
	protected override draw(studio: Studio): unknown {
		const { failure, growing, shown, model, ui } = studio.state;
		// While the next plant grows, the last one is dimmed, since the page already has the next one's title.
		const isLeaving = growing && isOther(studio);
		return html`<canvas
				class="stage-surface" ?data-leaving=${isLeaving} ?data-outdoors=${model.outdoors && ui.outdoors} tabindex="0" role="application" aria-roledescription=${text("stage_3d")} aria-label=${described(studio)} aria-describedby=${this.idOf("keys")}
				@keydown=${this.#turnByKey}
			></canvas>
			<div class="view-aids"></div>
			<p class="unseen" id=${this.idOf("keys")}>${orbitKeys()}</p>
			${shown && !isLeaving ? caption(studio) : nothing}
			<div aria-live="polite">${chips(studio)}</div>
			${warnings(studio)}
			${this.#trouble && !failure ? message(this.#trouble.title, this.#trouble.details, this.#trouble.again ? button(text("try_again"), this.#trouble.again) : nothing) : nothing}
			${failure ? message(failure.title, failure.details, remedies(studio, failure)) : nothing}
			${this.#solid || this.#trouble ? this.#tools(studio, this.#trouble ? undefined : this.#solid) : nothing}
			${growing ? progress(studio) : nothing}`;
	}

	/** Makes one tool the stop of the Tab key, and creates the 3-D view at the first drawing. */
	protected override updated(): void {
		const buttons = this.#buttons();
		stopAt(buttons, buttons.find(({ tabIndex }) => tabIndex === 0) ?? buttons[0]);
		if (!this.#started) void this.#start();
	}

	/**
	 * Updates the view in a task of its own, so that the browser may draw a frame after the page's other parts are
	 * updated.
	 */
	readonly #follow = (): void => {
		if (this.#due) return;
		this.#due = true;
		setTimeout(() => {
			this.#due = false;
			if (this.#visible) this.#solid?.update(this.context.state);
			if (this.#solid && this.context.state.shown) void this.#prepareAids();
		});
	};

	/** Loads the view's aids after the first drawing, or at once where one is in use. */
	async #prepareAids(): Promise<void> {
		if (!this.context.state.aid) await firstDrawing();
		if (this.#solid) this.#useAids(this.#solid);
	}

	/** Ends the 3-D view and all that follows it. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#leaveTools();
		this.#resized.disconnect();
		this.#leave?.();
		this.#aids?.then((aids) => aids.dispose()).catch(() => {});
		this.#aids = undefined;
		this.#solid?.dispose();
		this.#solid = undefined;
		if (this.#started) {
			this.context.showPicture(undefined);
			this.context.showView(undefined);
		}
		this.#started = false;
	}

	/**
	 * Creates the 3-D view and connects it to the studio. Without WebGL 2 there is no retry; other failures offer one.
	 */
	async #start(): Promise<void> {
		this.#started = true;
		const canvas = this.querySelector("canvas") as HTMLCanvasElement;
		try {
			const solid = await SolidView.create(canvas, this.context, {
				lost: () => this.#setTrouble({ title: text("stage_lost"), details: [text("stage_lost_details")] }),
				restored: () => this.#setTrouble(undefined),
				motion: () => this.requestUpdate(),
			});
			if (!this.isConnected) {
				solid.dispose();
				return;
			}
			this.#solid = solid;
			this.requestUpdate();
			this.#leave = this.context.subscribe(this.#follow);
			this.#follow();
			this.#resized.observe(canvas);
			this.context.showPicture((options) => solid.picture(options));
			this.context.showView(this.#viewOf(solid));
			void findRoomSupport().then(() => this.requestUpdate());
		} catch (error) {
			const none = error instanceof Error && error.name === "NoWebGL2Error";
			const again = () => {
				this.#setTrouble(undefined);
				void this.#start();
			};
			const details = [...(none ? [error.message] : fetchFailed()), text("stage_unavailable_details")];
			this.#setTrouble({ title: text("stage_unavailable"), details, ...(none ? {} : { again }) });
		}
	}

	/** Loads the scale bar, the measuring tape and the presentation once; a view without them still shows the plant. */
	#useAids(solid: SolidView): void {
		if (this.#aids && !(this.#hasNoAids && this.context.state.aid)) return;
		this.#hasNoAids = false;
		const place = this.querySelector<HTMLElement>(".view-aids") as HTMLElement;
		this.#aids = import("../view/view_aids").then(({ ViewAids }) => new ViewAids(place, solid, this.context));
		this.#aids.catch(() => {
			this.#hasNoAids = true;
			if (!this.context.state.aid) return;
			this.context.setAid(undefined);
			this.context.notify(text("stage_aids_failed"), fetchFailed(), { topic: "aids" });
		});
	}

	/** Shows the reason why there is no picture; undefined removes it. */
	#setTrouble(trouble: Trouble | undefined): void {
		this.#trouble = trouble;
		this.requestUpdate();
	}

	/** Renders the buttons of the 3-D view; without a view, those of tools that do not need it, such as the grammar. */
	#tools(studio: Studio, solid: SolidView | undefined): unknown {
		const slots = this.#slots(studio, solid);
		if (Object.values(slots).every((buttons) => buttons.length === 0)) return nothing;
		return html`<div
			class="stage-tools" role="toolbar" aria-orientation="vertical" aria-label=${text(solid ? "stage_3d" : "stage_tools")} ?data-names=${studio.state.ui.toolNames}
			@keydown=${this.#pressTool} @focusin=${this.#enterTool} @pointerover=${this.#showNames}
			@pointerenter=${this.#pointAtTools} @pointerleave=${() => this.#leaveTools()}
		>
			${TOOL_SLOTS.filter((slot) => slots[slot].length > 0).map(
				(slot) => html`<div class="tool-slot" role="group" data-slot=${slot} aria-label=${text("stage_slot", { slot })}>
					${slots[slot].map(toolButton)}
				</div>`,
			)}
		</div>`;
	}

	/** Returns the buttons by the slot in which every model shows them; the page's own are first in theirs. */
	#slots(studio: Studio, solid: SolidView | undefined): Record<ToolSlot, StageButton[]> {
		const { modelUi, specimen, model, ui, shown, aid } = studio.state;
		const slots: Record<ToolSlot, StageButton[]> = { view: [], edit: [], gestures: [], source: [] };
		if (solid) slots.view.push({ icon: "frame", label: text("stage_reset"), press: () => solid.reset() });
		if (solid && canBlow(solid, model))
			slots.view.push({
				icon: "wind",
				label: text("stage_wind"),
				press: () => this.#setWind(solid, !solid.wind),
				pressed: solid.wind,
			});
		if (solid && model.outdoors)
			slots.view.push({
				icon: "outdoors",
				label: text("stage_outdoors"),
				press: () => studio.setUi({ outdoors: !ui.outdoors }),
				pressed: ui.outdoors,
			});
		if (solid)
			slots.view.push({
				icon: "names",
				label: text("stage_names"),
				press: () => studio.setUi({ toolNames: !ui.toolNames }),
				pressed: ui.toolNames,
			});
		if (solid && shown)
			slots.view.push({
				icon: "tape",
				label: text("stage_measure"),
				press: () => studio.toggleAid("tape"),
				pressed: aid === "tape",
			});
		if (solid && shown)
			slots.view.push({
				icon: "presentation",
				label: text("stage_present"),
				press: () => studio.toggleAid("presentation"),
			});
		if (solid && offersRoom(studio))
			slots.view.push({ icon: "room", label: text("room"), press: () => openRoom(studio) });
		for (const { button, interaction, press } of applying(modelUi?.tools, specimen)) {
			if (!button || !(solid || !interaction)) continue;
			const { icon, label, slot, pressed } = button;
			slots[slot].push({ icon, label, press: () => press?.(studio), pressed: pressed?.(studio) });
		}
		return slots;
	}

	/** Moves the focus among the tools by a key. */
	#pressTool(event: KeyboardEvent): void {
		if (!rove(event, this.#buttons())) this.#hideNames(event);
	}

	/** Makes the tool that has received the focus the stop of the Tab key, and shows its name. */
	#enterTool({ target }: Event): void {
		stopAt(this.#buttons(), target as HTMLElement);
		this.#showNames();
	}

	/** Listens to Escape while the pointer is over the tools, wherever the focus is. */
	#pointAtTools(): void {
		this.#leaveTools();
		window.addEventListener("keydown", this.#hideNames);
		this.#leaveTools = () => window.removeEventListener("keydown", this.#hideNames);
	}

	/** Hides by Escape the name that the focus or the pointer shows, until either moves on. */
	readonly #hideNames = ({ key }: KeyboardEvent): void => {
		if (key === "Escape") this.querySelector(".stage-tools")?.setAttribute("data-nameless", "");
	};

	/** Shows the name of the tool under the pointer or in focus again. */
	#showNames(): void {
		this.querySelector(".stage-tools")?.removeAttribute("data-nameless");
	}

	/** Switches the wind on or off. */
	#setWind(solid: SolidView, on: boolean): void {
		// A plant that sways has no fixed lengths.
		if (on && this.context.state.aid === "tape") this.context.setAid(undefined);
		solid.wind = on;
		this.requestUpdate();
	}

	/** Returns the view for the page's actions. */
	#viewOf(solid: SolidView): StageView {
		const { context } = this;
		const blow = (on: boolean) => this.#setWind(solid, on);
		return {
			reset: () => solid.reset(),
			get canBlow() {
				return canBlow(solid, context.state.model);
			},
			get wind() {
				return solid.wind;
			},
			set wind(on) {
				blow(on);
			},
		};
	}

	/** Returns the buttons of the tools. */
	#buttons(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>(".stage-tools button")];
	}

	/** Turns, moves or zooms the view by a key. */
	#turnByKey(event: KeyboardEvent): void {
		if (this.#solid?.press(event)) event.preventDefault();
	}
}

/** Renders a button on the 3-D view, with its name beside it for the eye. */
function toolButton({ icon: drawn, label, pressed, press }: StageButton): unknown {
	return html`<button class="button icon" type="button" aria-label=${label} aria-pressed=${pressed ?? nothing} @click=${press}>
		${icon(drawn)}<span class="tool-name" aria-hidden="true">${label}</span>
	</button>`;
}
/**
 * Returns whether the wind can be switched on: not for models that are still, nor where the user prefers reduced
 * motion.
 */
const canBlow = ({ movesByItself }: SolidView, { still }: PageModel): boolean => still !== true && movesByItself;

/** Returns the text alternative of the picture. */
function described({ state: { failure, shown, model } }: Studio): string {
	if (shown) {
		const description = shown.model.summary(shown.grown, shown.from);
		return text("stage_plant", { model: shown.model.title, description });
	}
	return failure ? text("stage_nothing") : text("stage_growing", { model: model.title });
}

/** Renders the caption: the plant's title and a description. */
function caption(studio: Studio): unknown {
	const { shown, modelUi, grown } = studio.state;
	if (!shown) return nothing;
	const { model, from } = shown;
	const caption = grown && modelUi?.caption ? modelUi.caption(grown, studio) : model.summary(shown.grown, from);
	return html`<div class="caption">
		<h2>${titleOf(from, model, modelUi && grown ? modelUi.tools : [])}</h2>
		<p>${caption}</p>
	</div>`;
}

/** Renders the tools' chips about the selection in the picture; none while there is no picture. */
function chips(studio: Studio): unknown {
	const { modelUi, specimen, failure, shown } = studio.state;
	if (failure || !shown) return nothing;
	return applying(modelUi?.tools, specimen).map(({ chip }) => {
		const drawn = chip?.draw(studio) ?? nothing;
		return drawn === nothing
			? nothing
			: html`<div class="stage-chip" role="group" aria-label=${chip?.title ?? ""}>${drawn}</div>`;
	});
}

/**
 * Renders the warnings about the plant, over the picture. An open pane shows them, too; then only the pane announces
 * them.
 */
function warnings(studio: Studio): unknown {
	const { modelUi, grown, grownFrom, specimen, failure } = studio.state;
	const lines = grown && grownFrom && !failure ? (modelUi?.warnings?.(grown, grownFrom) ?? []) : [];
	const read = applying(modelUi?.tools, specimen).some(({ pane }) => pane?.open(studio));
	return html`<div class="stage-warnings" role=${read ? nothing : "status"}>${lines.map((line) => html`<p>${line}</p>`)}</div>`;
}

/** Renders a message in place of the picture. */
function message(title: string, details: readonly string[], actions: unknown = nothing): unknown {
	return html`<div class="stage-message" role="alert">
		<h2>${title}</h2>
		${details.map((line) => html`<p>${line}</p>`)}
		${actions}
	</div>`;
}

/** Renders a button of a message. */
function button(label: string, click: () => void): unknown {
	return html`<button class="button" type="button" @click=${click}>${label}</button>`;
}

/** Renders buttons that may lead to a plant after a failure. */
function remedies(studio: Studio, failure: Failure): unknown {
	return failure.remedies.map((remedy) => {
		if (remedy === "again") return button(text("try_again"), () => studio.growAgain());
		const { model, specimen, modelUi } = studio.state;
		const own = applying(modelUi?.tools, specimen).flatMap((tool) => tool.remedies ?? []);
		if (own.length > 0) return own.map(({ label, press }) => button(label, () => press(studio)));
		const standard = fromPreset(model);
		if (sameSpecimen(specimen, standard)) return nothing;
		return button(text("stage_open_default"), () => studio.replace(standard));
	});
}

/** Returns whether the plant in view is of another preset than the one on the controls, which has yet to grow. */
const isOther = ({ state: { shown, model, specimen } }: Studio): boolean =>
	shown !== undefined && (shown.model !== model || shown.from.preset !== specimen.preset);

/** Renders the progress of a growth, with a button that cancels it; that of another plant with its title. */
function progress(studio: Studio): unknown {
	const { specimen, model } = studio.state;
	const label = isOther(studio) ? text("growing_plant", { title: titleOf(specimen, model) }) : text("growing");
	return html`<div class="growing" role="status">
		<span>${label}</span><progress aria-label=${label}></progress>
		<button class="button quiet" type="button" title=${text("growing_cancel_title")} aria-keyshortcuts="Escape" @click=${() => studio.cancel()}>${text("cancel")}</button>
	</div>`;
}

customElements.define("panicle-stage", StagePart);
