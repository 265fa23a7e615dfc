/** The scale bar of the 3-D view: a round length at the depth of the plant's centre. */
import { roundLength } from "../../ui/handles/scale_bar";
import { formatLength } from "./length";
import "./view.css";

/** Used part of the 3-D view. */
export interface ScaledView {
	readonly canvas: HTMLElement;
	/** Metres per CSS pixel at the depth of the plant's centre; undefined where there is no scale. */
	readonly pixelSize: number | undefined;
	onDrawn(listener: () => void): () => void;
}

/** Largest length of the bar, CSS pixels, and as a share of the view's width. */
const LONGEST = 140;
const SHARE = 0.3;

/** Shows the scale in an element, and updates it after each draw. Screen readers get lengths from the measuring tape. */
export class ViewScale {
	readonly #view: ScaledView;
	readonly #bar = document.createElement("div");
	readonly #line = document.createElement("span");
	readonly #length = document.createElement("span");
	readonly #leave: () => void;
	/** Width of the line, CSS pixels, and length that it shows, metres. */
	#width = 0;
	#metres = 0;

	constructor(parent: HTMLElement, view: ScaledView) {
		this.#view = view;
		this.#bar.className = "scale-bar";
		this.#bar.ariaHidden = "true";
		this.#line.className = "scale-line";
		this.#bar.append(this.#length, this.#line);
		parent.append(this.#bar);
		this.#leave = view.onDrawn(() => this.#update());
		this.#update();
	}

	/** Removes the scale. */
	dispose(): void {
		this.#leave();
		this.#bar.remove();
	}

	/** Sets length and width of the bar for the present scale; hides it where there is none. */
	#update(): void {
		const { pixelSize, canvas } = this.#view;
		this.#bar.hidden = pixelSize === undefined;
		if (pixelSize === undefined) return;
		const metres = roundLength(Math.min(LONGEST, SHARE * canvas.clientWidth) * pixelSize);
		const width = metres / pixelSize;
		if (metres !== this.#metres) this.#length.textContent = formatLength(metres);
		if (width !== this.#width) this.#line.style.width = `${width}px`;
		this.#metres = metres;
		this.#width = width;
	}
}
