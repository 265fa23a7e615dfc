import { html, nothing } from "lit";
import type { Specimen } from "../../specimen/specimen";
import { StudioPart } from "../parts/studio_part";
import type { Studio } from "../studio";
import { forgetDone, HINTS, type HintKey, hintsDue, markDone } from "./hint_store";
import { areaOn, type HintTarget, isAtHandle, obstaclesOn, targetOf } from "./hint_targets";
import { text } from "./messages.generated";
import { isFree, placeHint, type ScreenBox, type Surroundings } from "./place_hint";
import "../style/hints.css";

/** Time between two looks at the page, and between a hint that is done and the next one; milliseconds. */
const INTERVAL = 150;
const PAUSE = 700;
/** Widths of a hint, CSS pixels: the first with which it has a place. */
const WIDTHS = [272, 224, 184];
/** Movement of a pointer that turns the plant, CSS pixels. */
const TURN = 6;
/** Movement of a target that the hint follows, CSS pixels. */
const FOLLOW = 24;

/** The hint in view. */
interface ShownHint {
	readonly key: HintKey;
	readonly target: HintTarget;
	/** Its place; undefined until it is measured, and while there is no free place. */
	readonly place: { readonly left: number; readonly top: number; readonly width: number } | undefined;
}

/**
 * Short hints about a visitor's first plants, one after another, each near the element that it is about. A hint goes once
 * its action was done or it was dismissed, and is never shown again. Hints take no focus and cover no control.
 */
export class Hints extends StudioPart {
	/** Hints that are still to be shown. */
	#due: readonly HintKey[] = [];
	#hint: ShownHint | undefined;
	/** The last announcement to screen readers. */
	#announced = "";
	readonly #announcedKeys = new Set<HintKey>();
	#timer: ReturnType<typeof setTimeout> | undefined;
	/** Time until which no hint is shown. */
	#pausedUntil = 0;
	/** The document when a handle was pressed. */
	#pressed: Specimen | undefined;
	/** Where a pointer was pressed on the 3-D view, and whether it has moved since. */
	#turning: { readonly x: number; readonly y: number; moved: boolean } | undefined;
	#lifetime: AbortController | undefined;

	/** Returns no values: state changes move hints, but draw nothing by themselves. */
	protected override shows(): readonly unknown[] {
		return [];
	}

	/** Ends the hints when the element is removed. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#stop();
	}

	/** Renders the hint with its buttons, the mark at its target, and the announcement. */
	protected override draw(_studio: Studio): unknown {
		return html`<p class="unseen" role="status">${this.#announced}</p>${this.#hint ? this.#card(this.#hint) : nothing}`;
	}

	/** Renders a hint with its buttons, and the ring around its target. */
	#card({ target, place }: ShownHint): unknown {
		const { left, top, width, height } = target.box;
		const about = this.idOf("about");
		const ring = `left: ${left}px; top: ${top}px; width: ${width}px; height: ${height}px`;
		return html`${place && target.marked ? html`<span class="hint-ring" .style=${ring}></span>` : nothing}
			<div
				class="hint" role="group" aria-label=${text("tip")} aria-describedby=${about} ?data-placed=${place !== undefined}
				.style=${`left: ${place?.left ?? 0}px; top: ${place?.top ?? 0}px; max-width: ${place?.width ?? WIDTHS[0]}px`} @keydown=${this.#key}
			>
				<p id=${about}>${text(target.text)}</p>
				<div class="choices">
					<button class="button quiet" type="button" @click=${() => this.#dismiss(HINTS)}>${text("skip")}</button>
					<button class="button wine" type="button" @click=${this.#dismissShown}>${text("done")}</button>
				</div>
			</div>`;
	}

	/** Starts the hints that are still due. */
	start(): void {
		this.#due = hintsDue();
		if (this.#due.length === 0) return;
		this.#listen();
		this.#schedule(0);
	}

	/** Shows all hints again, from the first. */
	open(): void {
		forgetDone();
		this.#announcedKeys.clear();
		this.#hint = undefined;
		this.start();
	}

	/** Follows the state, the layout and the user's actions while hints are due. */
	#listen(): void {
		this.#lifetime?.abort();
		this.#lifetime = new AbortController();
		const { signal } = this.#lifetime;
		const leave = this.context.subscribe(() => this.#follow());
		signal.addEventListener("abort", leave);
		const options = { signal, capture: true, passive: true };
		const look = () => this.#schedule();
		addEventListener("resize", look, options);
		addEventListener("scroll", look, options);
		const layout = new ResizeObserver(look);
		for (const part of document.querySelectorAll("main, panicle-stage, panicle-editors, panicle-bars"))
			layout.observe(part);
		signal.addEventListener("abort", () => layout.disconnect());
		addEventListener("pointerdown", (event) => this.#press(event), options);
		addEventListener("pointermove", (event) => this.#followTurn(event), options);
		addEventListener("pointerup", () => this.#endPress(), options);
		addEventListener("keydown", (event) => this.#press(event), options);
		addEventListener("input", (event) => this.#followAge(event), options);
	}

	/** Ends the hints and all listeners. */
	#stop(): void {
		this.#lifetime?.abort();
		this.#lifetime = undefined;
		clearTimeout(this.#timer);
		this.#timer = undefined;
		this.#hint = undefined;
	}

	/** Looks at the page soon, once for all changes until then. */
	#schedule(delay = INTERVAL): void {
		if (!this.#lifetime) return;
		this.#timer ??= setTimeout(() => {
			this.#timer = undefined;
			this.#look();
		}, delay);
	}

	/** Chooses the hint to show: the first that is due and whose target is on the page. */
	#look(): void {
		const page = this.closest<HTMLElement>(".studio");
		const { shown, modelUi, failure, held, aid } = this.context.state;
		const wait = this.#pausedUntil - performance.now();
		if (wait > 0) this.#schedule(wait);
		const isReady = page && shown && modelUi && !failure && !held && aid !== "presentation" && wait <= 0;
		const found = isReady ? this.#firstTarget(page) : undefined;
		const before = this.#hint;
		const place = before && before.key === found?.key ? before.place : undefined;
		this.#hint = found && { ...found, place };
		if (!found && !before) return;
		this.requestUpdate();
		void this.updateComplete.then(() => page && this.#place(page, before?.target.box));
	}

	/** Returns the first hint that is due and whose target is on the page; undefined if there is none. */
	#firstTarget(page: HTMLElement): Omit<ShownHint, "place"> | undefined {
		for (const key of this.#due) {
			const target = targetOf(key, page);
			if (target) return { key, target };
		}
		return undefined;
	}

	/** Moves the hint to a free place near its target; its present place stays while that is free. */
	#place(page: HTMLElement, before: ScreenBox | undefined): void {
		const hint = this.#hint;
		const card = this.querySelector<HTMLElement>(".hint");
		if (!hint || !card) return;
		const size = { width: card.offsetWidth, height: card.offsetHeight };
		const around = { target: hint.target.box, bounds: areaOn(page), ...obstaclesOn(page) };
		const isNear = before && Math.hypot(before.left - around.target.left, before.top - around.target.top) < FOLLOW;
		if (hint.place && isNear && isFree(size, hint.place, around)) return;
		const place = this.#freePlace(card, around);
		this.#hint = { ...hint, place };
		if (place) this.#announce(hint);
		this.requestUpdate();
	}

	/** Returns the place of the widest hint that has one. */
	#freePlace(card: HTMLElement, around: Surroundings): ShownHint["place"] {
		for (const width of WIDTHS) {
			card.style.maxWidth = `${width}px`;
			const { offsetWidth, offsetHeight } = card;
			const place = placeHint({ width: offsetWidth, height: offsetHeight }, around);
			if (place) return { ...place, width };
		}
		return undefined;
	}

	/** Announces a hint to screen readers, once. */
	#announce({ key, target }: ShownHint): void {
		if (this.#announcedKeys.has(key)) return;
		this.#announcedKeys.add(key);
		this.#announced = text("announced", { tip: text(target.text) });
	}

	/** Follows a change of the state: a dragged point, and a plant that plays. */
	#follow(): void {
		const { specimen, tools, model } = this.context.state;
		if (this.#pressed && specimen !== this.#pressed) {
			this.#pressed = undefined;
			this.#done(["point"]);
		}
		const states = Object.values(tools[model.name] ?? {});
		if (states.some((state) => (state as { playing?: boolean } | undefined)?.playing === true)) this.#done(["play"]);
		this.#schedule();
	}

	/** Remembers a press at a handle or on the 3-D view; arrow keys turn the plant at once. */
	#press(event: PointerEvent | KeyboardEvent): void {
		this.#pressed = isAtHandle(event) ? this.context.state.specimen : undefined;
		const isOnView = event.target instanceof Element && event.target.matches(".stage-surface");
		this.#turning = undefined;
		if (!isOnView) return;
		if (event instanceof PointerEvent) this.#turning = { x: event.clientX, y: event.clientY, moved: false };
		else if (event.key.startsWith("Arrow")) this.#done(["turn"]);
	}

	/** Records that the pointer has moved far enough to turn the plant. */
	#followTurn({ clientX, clientY }: PointerEvent): void {
		const from = this.#turning;
		if (from && Math.hypot(clientX - from.x, clientY - from.y) >= TURN) from.moved = true;
	}

	/** Ends a press: the hint on turning is done if the plant was turned. */
	#endPress(): void {
		if (this.#turning?.moved) this.#done(["turn"]);
		this.#turning = undefined;
	}

	/** Marks the hint on playing as done when the slider of the age is moved. */
	#followAge({ target }: Event): void {
		if (target instanceof Element && target.matches(".life input[type=range]")) this.#done(["play"]);
	}

	/** Escape dismisses the hint that has the focus. */
	readonly #key = (event: KeyboardEvent): void => {
		if (event.key !== "Escape") return;
		event.preventDefault();
		event.stopPropagation();
		this.#dismissShown();
	};

	/** Dismisses the hint in view. */
	readonly #dismissShown = (): void => {
		if (this.#hint) this.#dismiss([this.#hint.key]);
	};

	/** Dismisses hints; if the hint has the focus, its target takes it. */
	#dismiss(keys: readonly HintKey[]): void {
		const target = this.contains(document.activeElement) ? this.#hint?.target.element : undefined;
		this.#done(keys);
		target?.focus({ preventScroll: true });
	}

	/** Stores that hints are done, and shows the next one after a pause. */
	#done(keys: readonly HintKey[]): void {
		if (!this.#due.some((key) => keys.includes(key))) return;
		markDone(keys);
		this.#due = this.#due.filter((key) => !keys.includes(key));
		this.#announced = "";
		if (this.#hint && keys.includes(this.#hint.key)) {
			this.#hint = undefined;
			this.#pausedUntil = performance.now() + PAUSE;
		}
		if (this.#due.length === 0) this.#stop();
		else this.#schedule();
		this.requestUpdate();
	}
}

customElements.define("panicle-hints", Hints);
