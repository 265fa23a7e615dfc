/** Aids for looking at the plant in the 3-D view: loaded once a plant is drawn. */
import type { SolidView } from "../solid_view";
import type { Studio } from "../studio";
import { Presentation } from "./presentation";
import { Room } from "./room";
import { Tape } from "./tape";
import { ViewScale } from "./view_scale";

export class ViewAids {
	readonly #place: HTMLElement;
	readonly #view: SolidView;
	readonly #studio: Studio;
	readonly #leave: () => void;
	/** Live region of the tape and the presentation. */
	readonly #words = document.createElement("div");
	#scaleBar: ViewScale | undefined;
	#tape: Tape | undefined;
	#presentation: Presentation | undefined;
	#room: Room | undefined;

	/** @param place empty element over the canvas */
	constructor(place: HTMLElement, view: SolidView, studio: Studio) {
		this.#place = place;
		this.#view = view;
		this.#studio = studio;
		this.#words.ariaLive = "polite";
		place.append(this.#words);
		this.#leave = studio.subscribe(() => this.#update());
		this.#update();
	}

	/** Removes the aids. */
	dispose(): void {
		this.#leave();
		this.#scaleBar?.dispose();
		this.#tape?.dispose();
		this.#presentation?.dispose();
		this.#room?.dispose();
		this.#words.remove();
	}

	/** Shows or hides the scale bar, as the user has chosen. */
	#update(): void {
		const { ui, aid } = this.#studio.state;
		const { scaleBar = aid !== "presentation" } = ui;
		if (scaleBar) this.#scaleBar ??= new ViewScale(this.#place, this.#view);
		else {
			this.#scaleBar?.dispose();
			this.#scaleBar = undefined;
		}
		if (aid !== "presentation") {
			this.#presentation?.dispose();
			this.#presentation = undefined;
		}
		if (aid === "tape") this.#tape ??= new Tape(this.#words, this.#view, this.#studio);
		else {
			this.#tape?.dispose();
			this.#tape = undefined;
		}
		if (aid === "room") this.#room ??= new Room(this.#view, this.#studio);
		else {
			this.#room?.dispose();
			this.#room = undefined;
		}
		if (aid !== "presentation") return;
		this.#presentation ??= new Presentation(this.#words, this.#view, this.#studio);
		this.#presentation.draw();
	}
}
