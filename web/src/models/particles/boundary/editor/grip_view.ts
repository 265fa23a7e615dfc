/**
 * A flat view with grips, of what a pose says: what boundary and sun are drawn and dragged on. Subclasses say what lies
 * behind the grips.
 */
import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import type { Change } from "../../../../controls/desk";
import { DragSession } from "../../../../controls/handles/drag_session";
import { HandleView } from "../../../../controls/handles/handle_view";
import type { Point } from "../../../../controls/handles/point";
import { type Frame, fromScreen, toScreen } from "./frame";
import { changeBy, type Grip, type Pose } from "./grip";
import { gripStyle } from "./grip_style";

export abstract class GripView extends HandleView<string> {
	static override styles = [...HandleView.styles, gripStyle];
	static override properties = { ...HandleView.properties, pose: { attribute: false } };
	declare pose: Pose | undefined;

	protected frame: Frame = { width: 1, height: 1, scale: 1, origin: { x: 0, y: 0 } };
	protected readonly drags = new DragSession<string, Change>({
		get: () => this.pose?.change ?? {},
		place: (id) => this.#grip(id)?.at ?? { x: 0, y: 0 },
		pull: (change, id, to) => this.pose?.pull(id, to) ?? change,
		same: (one, other) => one === other,
		// What one grip makes of the pose, another's drag does not know of.
		alone: true,
		input: (change) => this.tell("grip-input", change),
		change: () => this.tell("grip-change"),
	});

	/** How the view's units lie in an element of its size. */
	protected abstract fit(): Frame;
	/** What is drawn under the grips, in CSS pixels. */
	protected abstract drawing(frame: Frame): TemplateResult;

	/** What is in hand must not move by itself. */
	protected override willUpdate(changed: PropertyValues): void {
		super.willUpdate(changed);
		if (!this.drags.active) this.frame = this.fit();
	}

	protected inside(): unknown {
		const { pose, frame } = this;
		if (!pose) return undefined;
		return html`<svg class="drawing" viewBox="0 0 ${frame.width} ${frame.height}" aria-hidden="true">${this.drawing(frame)}</svg>
			${pose.grips.map((grip) => this.#drawGrip(grip))}`;
	}

	#drawGrip({ id, at, label, value }: Grip): TemplateResult {
		const place = toScreen(this.frame, at);
		const aside = place.x > this.frame.width / 2 ? "value left" : "value";
		const told = id === this.shown || this.drags.holds(id);
		const content = told ? html`<span class=${aside}>${value}</span>` : nothing;
		return this.drawHandle(id, place, { label: `${label}: ${value}`, content });
	}

	#grip(id: string): Grip | undefined {
		return this.pose?.grips.find((grip) => grip.id === id);
	}

	protected places(): [string, Point][] {
		return (this.pose?.grips ?? []).map(({ id, at }) => [id, toScreen(this.frame, at)]);
	}

	protected units(place: Point): Point {
		return fromScreen(this.frame, place);
	}

	protected words(id: string): string {
		return this.#grip(id)?.value ?? "";
	}

	protected key(id: string, event: KeyboardEvent): boolean {
		const change = this.pose && !event.altKey && changeBy(this.pose, id, event);
		if (!change) return false;
		this.#step(change);
		// The new pose comes with the page's next drawing.
		requestAnimationFrame(() => this.say(this.words(id)));
		return true;
	}

	protected doubled(id: string | undefined): void {
		const change = id !== undefined && this.pose?.reset?.(id);
		if (change) this.#step(change);
	}

	protected override focused(id: string): void {
		this.tell("grip-focus", id);
	}

	#step(change: Change): void {
		this.tell("grip-input", change);
		this.tell("grip-change");
	}
}
