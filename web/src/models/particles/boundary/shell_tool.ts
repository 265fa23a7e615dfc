/** The boundary in the 3-D view, on and off. */
import { svg } from "lit";
import type { Desk, DeskState } from "../../../controls/desk";
import type { Tool, ToolHands, ToolView } from "../../../controls/tool";
import type { BoundedSpecimen } from "./bounded";
import type { Lay } from "./editor/lay";
import { shellsOf } from "./editor/shell";
import type { ShellFigure } from "./editor/shell_figure";
import type { WoodenPlant } from "./wooden_plant";

const ICON = svg`<path d="M10 3c4 0 6.5 2.8 6.5 6s-2.5 6-6.5 6-6.5-2.8-6.5-6 2.5-6 6.5-6zM3.5 9c0 1.300 2.900 2.300 6.5 2.300s6.5-1 6.5-2.300M10 15v2.5"/>`;

export function shellTool<S extends BoundedSpecimen>(lay: Lay<S>): Tool<S, WoodenPlant, boolean> {
	const tool: Tool<S, WoodenPlant, boolean> = {
		name: "shell",
		initial: false,
		press: (desk) => desk.setToolState(tool, !desk.toolState(tool)),
		button: { icon: ICON, label: "Boundary in 3-D", pressed: (desk) => desk.toolState(tool) },
		hands: (view, desk) => new ShellHands(view, desk, lay, tool),
	};
	return tool;
}

class ShellHands<S extends BoundedSpecimen> implements ToolHands<S, WoodenPlant> {
	readonly #view: ToolView;
	readonly #desk: Desk<S, WoodenPlant>;
	readonly #lay: Lay<S>;
	readonly #tool: Tool<S, WoodenPlant, boolean>;
	/** Loaded when first asked for. */
	#figure: Promise<ShellFigure | undefined> | undefined;
	#shown: { readonly specimen: S; readonly dark: boolean } | undefined;
	#disposed = false;

	constructor(view: ToolView, desk: Desk<S, WoodenPlant>, lay: Lay<S>, tool: Tool<S, WoodenPlant, boolean>) {
		this.#view = view;
		this.#desk = desk;
		this.#lay = lay;
		this.#tool = tool;
	}

	update(): void {
		if (!this.#desk.toolState(this.#tool) && !this.#figure) return;
		this.#figure ??= this.#fetch();
		void this.#figure.then((figure) => {
			if (figure && !this.#disposed) this.#show(figure, this.#desk.state);
		});
	}

	dispose(): void {
		this.#disposed = true;
		void this.#figure?.then((figure) => {
			if (!figure) return;
			this.#view.removeOverlay(figure.object);
			figure.dispose();
		});
	}

	#show(figure: ShellFigure, { specimen, dark }: DeskState<S, WoodenPlant>): void {
		const visible = this.#desk.toolState(this.#tool);
		const same = this.#shown?.specimen === specimen && this.#shown.dark === dark;
		if (visible === figure.object.visible && (same || !visible)) return;
		figure.object.visible = visible;
		if (visible && !same) {
			figure.show(shellsOf(this.#lay, specimen), getComputedStyle(this.#view.canvas).color);
			this.#shown = { specimen, dark };
		}
		this.#view.requestRender();
	}

	/** Where the script does not come, the tool is off again, and the next press asks for it anew. */
	async #fetch(): Promise<ShellFigure | undefined> {
		const script = await import("./editor/shell_figure").catch(() => undefined);
		if (!script) {
			this.#figure = undefined;
			this.#desk.setToolState(this.#tool, false);
			this.#desk.notify("The boundary could not be fetched", ["Check the connection and press its button again."]);
			return undefined;
		}
		const figure = new script.ShellFigure();
		figure.object.visible = false;
		this.#view.addOverlay(figure.object);
		return figure;
	}
}
