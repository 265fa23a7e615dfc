/**
 * A model's handles over the picture of its plant: buttons that stand where the handles are, dragged by mouse, pen and finger, stepped by
 * arrow keys. One of them is a stop of the Tab key, Page Up and Page Down lead to the others.
 */
import { apply } from "../../controls/change";
import type { Change } from "../../controls/desk";
import { EscapeKey } from "../../controls/handles/escape_key";
import type { HandlesOf, PlantHandle, Vector } from "../../controls/handles/plant_handle";
import { ARROWS, nearest } from "../../controls/handles/point";
import { fromPreset } from "../../specimen/from_preset";
import type { Specimen } from "../../specimen/specimen";
import type { Shown } from "../grown_detail";
import type { SpecimenView } from "../specimen_view";
import type { Extra, ExtrasHost } from "./extras";
import { placeUnder, visibleWays } from "./handle_ways";
import { HANDLES_STYLE } from "./handles_style";

/** A handle in hand. */
interface Held {
	readonly id: string;
	readonly pointer: number;
	readonly ways: readonly Vector[];
	/** From the pointer to where the handle is seen, so that it does not jump. */
	readonly offset: { readonly x: number; readonly y: number };
	/** What Escape brings back. */
	readonly before: Specimen;
	/** Where the pointer has gone since the last frame. */
	to?: PointerEvent;
	moved: boolean;
}

const SVG = "http://www.w3.org/2000/svg";

export class HandlesLayer implements Extra {
	readonly #host: ExtrasHost;
	readonly #view: SpecimenView;
	readonly #layer = document.createElement("div");
	readonly #lines = document.createElementNS(SVG, "path");
	readonly #said = Object.assign(document.createElement("p"), { className: "unseen", role: "status" });
	readonly #buttons = new Map<string, HTMLButtonElement>();
	readonly #style = new CSSStyleSheet();
	readonly #undraw: () => void;
	readonly #escape = new EscapeKey(() => this.#cancel());
	#shown: Shown | undefined;
	/** Of the model shown; none where it has no handles. */
	#handlesOf: HandlesOf<Specimen> | undefined;
	/** Whether the model's handles could not be fetched: the next plant asks for them again. */
	#missed = false;
	/** As hands have it, ahead of what has grown. */
	#specimen: Specimen | undefined;
	#handles: readonly PlantHandle[] = [];
	#ends: readonly (readonly Vector[])[] = [];
	#held: Held | undefined;
	#frame = 0;
	#disposed = false;

	constructor(host: ExtrasHost, view: SpecimenView) {
		this.#host = host;
		this.#view = view;
		this.#style.replaceSync(HANDLES_STYLE);
		host.root.adoptedStyleSheets.push(this.#style);
		this.#layer.className = "handles";
		this.#layer.role = "group";
		this.#layer.ariaLabel = "Handles";
		this.#layer.part.add("handles");
		const svg = document.createElementNS(SVG, "svg");
		svg.setAttribute("aria-hidden", "true");
		svg.append(this.#lines);
		this.#layer.append(svg, this.#said);
		host.root.querySelector("canvas")?.after(this.#layer);
		this.#undraw = view.onDrawn(() => this.#place());
	}

	show(shown: Shown): void {
		const another = shown.model !== this.#shown?.model;
		this.#shown = shown;
		if (another || this.#missed) void this.#use(shown);
		else if (!this.#held) this.#lay(shown.specimen);
	}

	dispose(): void {
		this.#disposed = true;
		this.#cancel();
		cancelAnimationFrame(this.#frame);
		this.#undraw();
		this.#layer.remove();
		const { root } = this.#host;
		root.adoptedStyleSheets = root.adoptedStyleSheets.filter((sheet) => sheet !== this.#style);
	}

	/** Another model has other handles, which have to be fetched. */
	async #use({ model }: Shown): Promise<void> {
		this.#cancel();
		this.#handlesOf = undefined;
		this.#lay(undefined);
		this.#missed = false;
		const handlesOf = await model.handles?.().catch(() => {
			this.#missed = this.#shown?.model === model;
			return undefined;
		});
		if (this.#disposed || this.#shown?.model !== model) return;
		this.#handlesOf = handlesOf;
		this.#lay(this.#shown.specimen);
	}

	/** Puts the handles where a specimen has them. */
	#lay(specimen: Specimen | undefined): void {
		const { model } = this.#shown ?? {};
		this.#specimen = specimen;
		const set = specimen && model && this.#handlesOf?.(specimen, fromPreset(model, specimen.preset));
		this.#handles = set?.handles ?? [];
		this.#ends = set?.lines ?? [];
		const there = new Set(this.#handles.map(({ id }) => id));
		for (const [id, button] of this.#buttons) {
			if (there.has(id)) continue;
			button.remove();
			this.#buttons.delete(id);
		}
		for (const { id, label, value } of this.#handles) this.#buttonOf(id).ariaLabel = `${label}: ${value}`;
		const buttons = [...this.#buttons.values()];
		if (!buttons.some(({ tabIndex }) => tabIndex === 0) && buttons[0]) buttons[0].tabIndex = 0;
		this.#place();
	}

	#buttonOf(id: string): HTMLButtonElement {
		const before = this.#buttons.get(id);
		if (before) return before;
		const button = Object.assign(document.createElement("button"), { type: "button", tabIndex: -1 });
		button.ariaRoleDescription = "handle";
		button.part.add("handle");
		button.addEventListener("pointerdown", (event) => this.#grasp(event));
		button.addEventListener("pointermove", (event) => this.#move(event));
		for (const type of ["pointerup", "lostpointercapture"] as const)
			button.addEventListener(type, (event) => this.#release(event));
		button.addEventListener("keydown", (event) => this.#press(id, event));
		button.addEventListener("focus", () => this.#stopAt(button));
		this.#buttons.set(id, button);
		this.#layer.append(button);
		return button;
	}

	/** Puts the buttons over the handles as they are seen now. */
	#place(): void {
		for (const { id, at } of this.#handles) {
			const { x, y } = this.#view.project(at);
			this.#buttonOf(id).style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
		}
		const seen = (point: Vector) => {
			const { x, y } = this.#view.project(point);
			return `${x.toFixed(1)} ${y.toFixed(1)}`;
		};
		this.#lines.setAttribute("d", this.#ends.map((line) => `M${line.map(seen).join("L")}`).join(""));
	}

	/** Where buttons overlap, the handle that is nearest to the pointer is meant. */
	#grasp(event: PointerEvent): void {
		const at = this.#pointOf(event);
		const places = this.#handles.map((each) => [each, this.#view.project(each.at)] as const);
		const handle = nearest(places, at, Number.POSITIVE_INFINITY);
		if (event.button !== 0 || this.#held || !handle || !this.#specimen) return;
		const { id } = handle;
		const seen = this.#view.project(handle.at);
		this.#held = {
			id,
			pointer: event.pointerId,
			ways: visibleWays(handle.along, this.#view.sightThrough(seen.x, seen.y)),
			offset: { x: seen.x - at.x, y: seen.y - at.y },
			before: this.#specimen,
			moved: false,
		};
		const button = this.#buttons.get(id);
		// Keys go on with the handle that is held, whichever button lay on top.
		event.preventDefault();
		button?.focus();
		button?.setPointerCapture(event.pointerId);
		this.#escape.listen(true);
	}

	/** At most one growth a frame. */
	#move(event: PointerEvent): void {
		const held = this.#held;
		if (held?.pointer !== event.pointerId) return;
		if (!held.to) this.#frame = requestAnimationFrame(() => this.#pull());
		held.to = event;
	}

	#pull(): void {
		const held = this.#held;
		const handle = this.#handles.find(({ id }) => id === held?.id);
		if (!held?.to || !handle) return;
		const { x, y } = this.#pointOf(held.to);
		held.to = undefined;
		const place = placeUnder(handle.at, held.ways, this.#view.sightThrough(x + held.offset.x, y + held.offset.y));
		if (!place) return;
		held.moved = true;
		this.#change(handle.pull(place));
	}

	#release(event: PointerEvent): void {
		const held = this.#held;
		if (held?.pointer !== event.pointerId) return;
		this.#pull();
		this.#end();
		if (held.moved) this.#settle(held.id);
	}

	#cancel(): void {
		const held = this.#held;
		if (!held) return;
		this.#end();
		if (!held.moved) return;
		this.#lay(held.before);
		this.#host.hands.edit(() => held.before);
		this.#host.hands.settle();
	}

	#end(): void {
		this.#held = undefined;
		this.#escape.listen(false);
	}

	#press(id: string, event: KeyboardEvent): void {
		const { key, shiftKey, ctrlKey, metaKey, altKey } = event;
		const handle = this.#handles.find((each) => each.id === id);
		if (!handle || ctrlKey || metaKey || altKey) return;
		const arrow = ARROWS[key];
		if (arrow) {
			this.#change(handle.nudge(arrow.x, arrow.y, shiftKey));
			this.#settle(id);
		} else if (key === "PageDown" || key === "PageUp") this.#lead(id, key === "PageDown" ? 1 : -1);
		else return;
		event.preventDefault();
	}

	/** To the next handle, round and round. */
	#lead(id: string, by: number): void {
		const ids = this.#handles.map((each) => each.id);
		const next = ids.at((ids.indexOf(id) + by) % ids.length);
		if (next !== undefined) this.#buttonOf(next).focus();
	}

	#stopAt(stop: HTMLButtonElement): void {
		for (const button of this.#buttons.values()) button.tabIndex = button === stop ? 0 : -1;
	}

	#change(change: Change): void {
		const { model } = this.#shown ?? {};
		if (!model || !this.#specimen) return;
		this.#lay(apply(model, this.#specimen, change));
		this.#host.hands.edit((now) => (now.model === model.name ? apply(model, now, change) : now));
	}

	#settle(id: string): void {
		this.#said.textContent = this.#handles.find((each) => each.id === id)?.value ?? "";
		this.#host.hands.settle();
	}

	/** From the canvas's upper left corner, CSS pixels. */
	#pointOf({ clientX, clientY }: PointerEvent): { x: number; y: number } {
		const { left, top } = this.#layer.getBoundingClientRect();
		return { x: clientX - left, y: clientY - top };
	}
}
