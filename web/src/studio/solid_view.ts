/** The 3-D view as the studio's state wants it; the one place where the studio meets the scene. */

import type { Grown } from "../models/bunch/grown";
import type { OctahedronHandles } from "../models/bunch/profile/octahedron";
import type { OctahedronColours } from "../models/bunch/profile/octahedron_figure";
import type { Viewer } from "../scene/viewer";
import type { Specimen } from "../specimen/specimen";
import type { Studio, StudioState } from "./studio";
import { isDark } from "./theme";
import { ThinningPointer } from "./thinning_pointer";

type SceneModules = [typeof import("../scene/viewer"), typeof import("../models/bunch/figure/bunch_figure")];

let loading: Promise<SceneModules> | undefined;

/** Starts loading the scene's script, the largest of the page; asked for again, it is the same one. */
export function loadScene(): Promise<SceneModules> {
	loading ??= Promise.all([import("../scene/viewer"), import("../models/bunch/figure/bunch_figure")]);
	return loading;
}

/** What the canvas has to tell besides the bunch. */
export interface SolidViewEvents {
	lost(): void;
	restored(): void;
}

const ORBIT_STEP = 0.12;
const PAN_STEP = 0.05;
const ZOOM_STEP = 1.15;
/** Pixels of a picture to one of the page. */
const PICTURE_SCALE = 2;

export class SolidView {
	#shown: Pick<StudioState, "grown" | "specimen"> | undefined;
	#dark: boolean | undefined;
	#handles: Promise<OctahedronHandles> | undefined;
	#thinning: ThinningPointer;

	private constructor(
		readonly view: Viewer<Specimen, Grown>,
		private readonly canvas: HTMLCanvasElement,
		private readonly studio: Studio,
	) {
		this.#thinning = new ThinningPointer(canvas, {
			berryAt: (x, y) => view.pick(x, y),
			mark: (id) => studio.mark(id),
			take: (id) => studio.thin(id),
		});
	}

	/** @throws NoWebGL2Error where the browser has none, and whatever the loading of the script throws */
	static async create(canvas: HTMLCanvasElement, studio: Studio, events: SolidViewEvents): Promise<SolidView> {
		const [{ Viewer }, { bunchFigure }] = await loadScene();
		const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)").matches;
		const theme = isDark(studio.state.ui.theme) ? "dark" : "light";
		const view = new Viewer<Specimen, Grown>(canvas, { reducedMotion, theme, checked: import.meta.env.DEV });
		view.use(bunchFigure);
		view.onFirstDraw = () => performance.mark("first-bunch");
		view.onContextLost = () => events.lost();
		view.onContextRestored = () => events.restored();
		return new SolidView(view, canvas, studio);
	}

	/** Brings the view to the state; what has not changed costs nothing. */
	update({ grown, specimen, history, marked, ui }: StudioState): void {
		this.view.holdView(history.gesture !== undefined);
		if (grown && (grown !== this.#shown?.grown || specimen.look !== this.#shown.specimen.look)) {
			this.view.show(grown, specimen);
		}
		this.#shown = { grown, specimen };
		this.#thinning.enabled = ui.thinning && !ui.stems;
		this.view.mark(marked);
		this.view.setMode(ui.stems ? "stems" : "whole");
		const dark = isDark(ui.theme);
		if (dark !== this.#dark) this.view.setTheme(dark ? "dark" : "light");
		const themed = dark !== this.#dark;
		this.#dark = dark;
		void this.#updateHandles(ui.octahedron, themed);
	}

	/** The present view as a PNG. */
	picture(): Promise<Blob> {
		const { clientWidth, clientHeight } = this.canvas;
		return this.view.snapshot(clientWidth * PICTURE_SCALE, clientHeight * PICTURE_SCALE);
	}

	/** Turns, moves and zooms by keys; tells whether the key was one of them. */
	press({ key, shiftKey }: KeyboardEvent): boolean {
		const arrow = ARROWS[key];
		if (arrow && shiftKey) this.view.pan(arrow[0] * PAN_STEP, arrow[1] * PAN_STEP);
		else if (arrow) this.view.orbit(arrow[0] * ORBIT_STEP, arrow[1] * ORBIT_STEP);
		else if (key === "+" || key === "=") this.view.zoom(ZOOM_STEP);
		else if (key === "-" || key === "−") this.view.zoom(1 / ZOOM_STEP);
		else if (key === "0") this.view.resetView();
		else return false;
		return true;
	}

	async #updateHandles(visible: boolean, themed: boolean): Promise<void> {
		if (!visible && !this.#handles) return;
		const first = this.#handles === undefined;
		this.#handles ??= this.#createHandles();
		const handles = await this.#handles;
		const { specimen, ui } = this.studio.state;
		handles.locks = ui.locks;
		if (first || themed) handles.setColours(coloursOf(this.canvas));
		handles.setVisible(ui.octahedron);
		if (ui.octahedron) handles.update(specimen.parameters);
	}

	async #createHandles(): Promise<OctahedronHandles> {
		const { OctahedronHandles } = await import("../models/bunch/profile/octahedron");
		const { view, canvas, studio } = this;
		const handles = new OctahedronHandles({
			canvas,
			camera: view.camera,
			requestRender: () => view.requestRender(),
			setControlsEnabled: (on) => {
				view.orbiting = on;
				this.#thinning.blocked = !on;
			},
		});
		handles.onInput = (parameters) => studio.edit({ parameters });
		handles.onChange = () => studio.settle();
		view.addOverlay(handles.object);
		return handles;
	}
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
	ArrowLeft: [-1, 0],
	ArrowRight: [1, 0],
	ArrowUp: [0, -1],
	ArrowDown: [0, 1],
};

function coloursOf(element: Element): OctahedronColours {
	const colour = (name: string) => resolve(getComputedStyle(element).getPropertyValue(name));
	return { line: colour("--ink"), handle: colour("--wine"), rim: colour("--paper") };
}

/** `light-dark()` as the plain colour it means here. */
function resolve(colour: string): string {
	const probe = document.createElement("i");
	probe.style.color = colour;
	document.body.append(probe);
	const plain = getComputedStyle(probe).color;
	probe.remove();
	return plain;
}
