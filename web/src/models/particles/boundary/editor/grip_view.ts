/**
 * A flat view with grips: base class of the views in which boundary and sun are edited. Subclasses draw the
 * background.
 */

import { html, type PropertyValues, type TemplateResult } from "lit";
import type { Change } from "../../../../ui/editor_context";
import { HandleView } from "../../../../ui/handles/handle_view";
import type { Point } from "../../../../ui/handles/point";
import { drawValue, valueStyle } from "../../../../ui/handles/value_label";
import { text } from "../../messages.generated";
import { type BoundaryFrame, fromScreen, toScreen } from "./frame";
import { type Grip, gripIn, type Pose, pressed } from "./grip";
import { gripDrags } from "./grip_drags";
import { gripStyle } from "./grip_style";

export abstract class GripView extends HandleView<string> {
	static override styles = [...HandleView.styles, valueStyle, gripStyle];
	static override properties = { pose: { attribute: false } };
	declare pose: Pose | undefined;

	protected frame: BoundaryFrame = { width: 1, height: 1, scale: 1, origin: { x: 0, y: 0 } };
	protected readonly drags = gripDrags({
		pose: () => this.pose,
		input: (change) => this.emit("grip-input", change),
		change: () => this.emit("grip-change"),
	});

	/** The frame that maps the view's units to an element of its size. */
	protected abstract fit(): BoundaryFrame;
	/** The drawing under the grips, CSS pixels. */
	protected abstract drawing(frame: BoundaryFrame): TemplateResult;

	/** Before rendering: fits the frame, except while a grip is dragged, so that it stays under the pointer. */
	protected override willUpdate(changed: PropertyValues): void {
		const before = changed.get("pose") as Pose | undefined;
		// Another action has removed the dragged grip.
		if (before?.grips.some(({ id }) => this.drags.holds(id) && !gripIn(this.pose, id))) this.drop();
		if (!this.drags.active) this.frame = this.fit();
	}

	/** Renders the drawing, the grips, and the value of the shown grip. */
	protected inside(): unknown {
		const { pose, frame } = this;
		if (!pose) return undefined;
		return html`<svg class="drawing" viewBox="0 0 ${frame.width} ${frame.height}" aria-hidden="true">${this.drawing(frame)}</svg>
			${pose.grips.map((grip) => this.#drawGrip(grip))}
			${pose.grips.map((grip) => this.#drawValue(grip))}
			<p class="spoken" id="adds">${text("insert_help")}</p>
			<p class="spoken" id="removes">${text("delete_help")}</p>`;
	}

	/** Renders the handle of a grip, with help for screen readers on the keys that it has. */
	#drawGrip(grip: Grip): TemplateResult {
		const { id, at, label, part, value } = grip;
		const help = ["help", grip.add ? "adds" : "", grip.remove ? "removes" : ""].filter(Boolean).join(" ");
		return this.drawHandle(id, toScreen(this.frame, at), {
			label: text("named_value", { name: part ? text("part_of", { name: label, part }) : label, value }),
			help,
		});
	}

	/** Renders a grip's value beside it while it is pointed at or dragged, placed so that it hides no other grip. */
	#drawValue({ id, at, value }: Grip): unknown {
		if (id !== this.shown && !this.drags.holds(id)) return undefined;
		const others = this.places().filter(([other]) => other !== id);
		const { width, height } = this.frame;
		return drawValue(
			value,
			toScreen(this.frame, at),
			{ width, height },
			others.map(([, place]) => place),
		);
	}

	/** Returns the positions of all grips by id, CSS pixels. */
	protected places(): [string, Point][] {
		return (this.pose?.grips ?? []).map(({ id, at }) => [id, toScreen(this.frame, at)]);
	}

	/** Converts a position in CSS pixels to the view's units. */
	protected units(place: Point): Point {
		return fromScreen(this.frame, place);
	}

	/** Describes a grip's position in words. */
	protected describe(id: string): string {
		return gripIn(this.pose, id)?.value ?? "";
	}

	/**
	 * Handles a key on a grip. The focus then goes to that grip, or to the one before it if the key removed it. Returns
	 * whether the key had an effect.
	 */
	protected key(id: string, event: KeyboardEvent): boolean {
		const { grips } = this.pose ?? { grips: [] };
		const place = grips.findIndex((grip) => grip.id === id);
		const step = place >= 0 && !event.altKey && pressed(grips[place], event);
		if (!step) return false;
		this.#applyChange(step.change);
		const nearest = grips.slice(0, place + 1).reverse();
		// The next update of the page sets the new pose.
		requestAnimationFrame(() => void this.updateComplete.then(() => this.#focusNearest(nearest, step.message)));
		return true;
	}

	/** Focuses the grip or, if it was removed, the nearest one before it, and announces the result. */
	#focusNearest(nearest: readonly Grip[], message?: string): void {
		const next = nearest.find(({ id }) => gripIn(this.pose, id));
		if (next) this.element(next.id)?.focus({ preventScroll: true });
		this.announce(message ?? this.describe(nearest[0].id));
	}

	/** Resets a grip to the preset after a double click. */
	protected doubled(id: string | undefined): void {
		const change = id !== undefined && gripIn(this.pose, id)?.reset?.();
		if (change) this.#applyChange(change);
	}

	/** Reports the grip that has received the focus. */
	protected override focused(id: string): void {
		this.emit("grip-focus", id);
	}

	/** Dispatches a finished change. */
	#applyChange(change: Change): void {
		this.emit("grip-input", change);
		this.emit("grip-change");
	}
}
