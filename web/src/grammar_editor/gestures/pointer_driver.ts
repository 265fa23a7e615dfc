import type { Driver, DriverEvents } from "./driver";

/** A pointer pressed on the picture moves the circle. A second finger selects the next pair. */
export class PointerDriver implements Driver {
	readonly #ended = new AbortController();
	#held: number | undefined;

	/** Listens in the capturing phase, before the camera controls. Places are shares of the canvas (0 … 1). */
	constructor(canvas: HTMLCanvasElement, events: DriverEvents) {
		const options = { signal: this.#ended.signal, capture: true };
		const go = ({ clientX, clientY }: PointerEvent) => {
			const { left, top, width, height } = canvas.getBoundingClientRect();
			events.move({ x: shareOf(clientX - left, width), y: shareOf(clientY - top, height) });
		};
		canvas.addEventListener(
			"pointerdown",
			(event) => {
				if (this.#held !== undefined) events.next();
				if (this.#held !== undefined || event.button !== 0) return;
				this.#held = event.pointerId;
				canvas.setPointerCapture(event.pointerId);
				go(event);
			},
			options,
		);
		canvas.addEventListener("pointermove", (event) => event.pointerId === this.#held && go(event), options);
		for (const end of ["pointerup", "pointercancel"] as const)
			canvas.addEventListener(
				end,
				({ pointerId }) => {
					if (pointerId !== this.#held) return;
					this.#held = undefined;
					events.rest();
				},
				options,
			);
	}

	/** Stops listening to the pointer. */
	stop(): void {
		this.#ended.abort();
	}
}

/** Returns a position as a share of a size, 0 … 1. */
function shareOf(position: number, size: number): number {
	return Math.min(Math.max(position / Math.max(size, 1), 0), 1);
}
