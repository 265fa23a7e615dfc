/** Draggable numbers in the text; Alt with the arrow keys changes them, too. */
import { type Extension, Prec } from "@codemirror/state";
import { type Command, EditorView, keymap } from "@codemirror/view";
import { outlined } from "./highlight";
import { type NumberAt, numberAt } from "./outline";
import { PIXELS_A_STEP, reach, stepped } from "./scrub";

/** Events for the document's history. */
export interface Scrubbing {
	/** A drag begins: ends the undo step of earlier typing. */
	begin(): void;
	/** The drag has ended: makes one undo step. */
	end(): void;
}

/** Distance after which a press becomes a drag; pixels. */
const SLACK = 3;

/** Returns the number at the cursor. */
export function numberHere({ state }: EditorView): NumberAt | undefined {
	return numberAt(state.field(outlined).pieces, state.selection.main.head);
}

/**
 * Changes the number at the cursor by a number of steps.
 * @returns whether there is a number
 */
export function stepHere(view: EditorView, steps: number): boolean {
	const number = numberHere(view);
	if (number) write(view, number, stepped(number, steps), "step");
	return number !== undefined;
}

/**
 * Replaces a number; the cursor is then behind the new one.
 * @param insert the new number
 * @param how kind of the change, "step" or "scrub", which the undo steps depend on
 */
export function write(
	view: EditorView,
	{ from, text }: Pick<NumberAt, "from" | "text">,
	insert: string,
	how: string,
): void {
	view.dispatch({
		changes: { from, to: from + text.length, insert },
		selection: { anchor: from + insert.length },
		userEvent: `input.${how}`,
	});
}

/** A drag of a number. */
export class NumberDrag {
	readonly #start: NumberAt;
	#text: string;
	#steps = 0;
	/** 0.1 after the first move in tenths, else 1. */
	#quantum = 1;

	constructor(start: NumberAt) {
		this.#start = start;
		this.#text = start.text;
	}

	/**
	 * Moves the drag by pixels to the right, and writes the number if it changes.
	 * @param keys modifier keys: Shift for steps of 10, Ctrl or Command for tenths
	 */
	move(view: EditorView, pixels: number, keys: Pick<MouseEvent, "shiftKey" | "ctrlKey" | "metaKey">): void {
		const times = reach(keys);
		this.#quantum = Math.min(this.#quantum, times);
		this.#steps += (pixels / PIXELS_A_STEP) * times;
		const next = stepped(this.#start, Math.round(this.#steps / this.#quantum) * this.#quantum);
		if (next === this.#text) return;
		write(view, { from: this.#start.from, text: this.#text }, next, "scrub");
		this.#text = next;
	}
}

/**
 * Makes numbers draggable by the mouse. A click only places the cursor, and a drag that begins vertically selects
 * text.
 */
export function scrubbing(scrub: Scrubbing): Extension {
	const step =
		(steps: number): Command =>
		(view) =>
			stepHere(view, steps);
	const keys = [
		["Alt-ArrowUp", 1],
		["Alt-ArrowDown", -1],
		["Shift-Alt-ArrowUp", 10],
		["Shift-Alt-ArrowDown", -10],
		["Ctrl-Alt-ArrowUp", 0.1],
		["Ctrl-Alt-ArrowDown", -0.1],
	] as const;
	return [
		EditorView.domEventHandlers({ mousedown: (event, view) => startNumberDrag(event, view, scrub) }),
		Prec.highest(keymap.of(keys.map(([key, steps]) => ({ key, run: step(steps) })))),
	];
}

/**
 * Begins dragging a number in the text at a plain press of the main button on it. Returns whether the event is handled.
 */
function startNumberDrag(event: MouseEvent, view: EditorView, scrub: Scrubbing): boolean {
	if (event.button !== 0 || event.detail !== 1 || event.shiftKey || event.ctrlKey || event.metaKey) return false;
	const place = view.posAtCoords(event, false);
	const number = numberAt(view.state.field(outlined).pieces, place);
	if (!number || !within(view, number, event)) return false;
	event.preventDefault();
	view.focus();
	// The press moves the cursor here, as it would without the drag.
	view.dispatch({ selection: { anchor: place } });
	const drag = new NumberDrag(number);
	let last = event.clientX;
	let active = false;
	const ended = new AbortController();
	const { signal } = ended;
	/**
	 * Begins the drag once the pointer has moved horizontally by more than SLACK; a vertical movement selects text
	 * instead.
	 */
	const moved = (move: MouseEvent) => {
		if (!active) {
			const [dx, dy] = [Math.abs(move.clientX - event.clientX), Math.abs(move.clientY - event.clientY)];
			if (Math.max(dx, dy) <= SLACK) return;
			if (dy > dx) return select(move);
			active = true;
			scrub.begin();
			view.dom.classList.add("cm-scrubbing");
		}
		drag.move(view, move.clientX - last, move);
		last = move.clientX;
	};
	let selecting = false;
	const select = (move: MouseEvent) => {
		selecting = true;
		view.dispatch({ selection: { anchor: place, head: view.posAtCoords(move, false) } });
	};
	const end = () => {
		ended.abort();
		view.dom.classList.remove("cm-scrubbing");
		if (active) scrub.end();
	};
	window.addEventListener("mousemove", (move) => (selecting ? select(move) : moved(move)), { signal });
	window.addEventListener("mouseup", end, { signal });
	window.addEventListener("blur", end, { signal });
	return true;
}

/** Returns whether a pointer is on the number itself, and not behind the end of its line. */
function within(view: EditorView, { from, to }: NumberAt, { clientX, clientY }: MouseEvent): boolean {
	const [left, right] = [view.coordsAtPos(from, 1), view.coordsAtPos(to, -1)];
	if (!left || !right) return false;
	return clientX >= left.left && clientX <= right.right && clientY >= left.top && clientY <= right.bottom;
}
