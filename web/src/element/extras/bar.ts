/**
 * The bar below a plant: turning, age, seed, download, and the link to the app. Every control has a label, keyboard
 * access and a part name.
 */

import { ageOf } from "../../generate/files/aged";
import { plantInWords } from "../../generate/plant_in_words";
import { messageOf } from "../../locale/message_error";
import { withParameters, withSeed } from "../../specimen/edit";
import { SEED } from "../../specimen/limits";
import { encodeLink } from "../../specimen/link";
import { appAddress } from "../app_address";
import type { GrownDocument } from "../grown_detail";
import { text } from "../messages.generated";
import type { SpecimenView } from "../specimen_view";
import { BAR_STYLE } from "./bar_style";
import type { Extra, ExtrasHost } from "./extras";

/** Angle of one click on Turn where the plant may not turn by itself, degrees. */
const TURN = 45;

const DRAWINGS = {
	turn: "M4 10.5C4 8 6.700 6.500 10 6.500s6 1.500 6 4-2.700 4-6 4M10 14.500 12.300 12.200M10 14.500l2.300 2.300",
	download: "M10 3v9.500M6.500 9.500 10 13l3.500-3.500M4 16.500h12",
	app: "M9 4.500H4.500v11h11V11M12 4h4v4M16 4l-6.500 6.500",
};

export class Bar implements Extra {
	readonly #host: ExtrasHost;
	readonly #view: SpecimenView;
	readonly #bar = document.createElement("div");
	readonly #turn = button(text("turn"), "turn");
	readonly #age = field("range", text("age"));
	readonly #seed = field("number", text("seed"));
	readonly #download = button(text("download_glb"), "download");
	readonly #app = withIcon(
		Object.assign(document.createElement("a"), { target: "_blank", rel: "noopener" }),
		text("open_in_app"),
		"app",
	);
	readonly #status = Object.assign(document.createElement("p"), { className: "unseen", role: "status" });
	readonly #style = new CSSStyleSheet();
	readonly #ended = new AbortController();
	#shown: GrownDocument | undefined;
	/** Whether the user has changed something since the last announcement. */
	#touched = false;
	/** The last valid seed typed, until its plant is shown. */
	#requestedSeed: number | undefined;
	/** The value of `autorotate` when it was last switched off. */
	#speed = "";

	/** Adds the bar and its style to the element's shadow root. */
	constructor(host: ExtrasHost, view: SpecimenView) {
		this.#host = host;
		this.#view = view;
		this.#style.replaceSync(BAR_STYLE);
		host.root.adoptedStyleSheets.push(this.#style);
		const space = Object.assign(document.createElement("span"), { className: "space" });
		this.#bar.className = "bar";
		this.#bar.role = "group";
		this.#bar.ariaLabel = text("bar");
		this.#bar.part.add("controls");
		this.#bar.append(this.#turn, this.#age, space, this.#seed, this.#download, this.#app, this.#status);
		Object.assign(this.#seed, { min: `${SEED.min}`, max: `${SEED.max}`, step: "1" });
		this.#listen();
		host.root.append(this.#bar);
		view.resize();
		this.follow();
	}

	/** Follows a grown plant: sets age, seed and link, and announces plants that the bar's controls caused. */
	show(shown: GrownDocument): void {
		this.#shown = shown;
		const { model, specimen } = shown;
		const age = ageOf(model, specimen);
		this.#age.hidden = age === undefined;
		if (age) {
			const value = specimen.parameters[age.key];
			Object.assign(this.#age, {
				min: `${age.min}`,
				max: `${age.max}`,
				step: `${age.step}`,
				ariaLabel: age.label,
				title: age.label,
			});
			// During a drag the slider is ahead of the plant.
			if (!this.#age.matches(":active")) this.#age.value = `${value}`;
			this.#age.ariaValueText = `${value} ${age.unit}`;
		}
		if (specimen.seed === this.#requestedSeed) this.#requestedSeed = undefined;
		if (this.#seed !== this.#host.root.activeElement) this.#seed.value = `${specimen.seed}`;
		if (this.#touched) this.#announce(plantInWords(shown));
		else if (!this.#status.classList.contains("unseen")) this.#announce("");
		this.#touched = false;
		void this.#updateAppLink(shown);
	}

	/** Follows a changed attribute: the state of the turning switch, and the address of the app. */
	follow(): void {
		const { element } = this.#host;
		// Without automatic turning the button is no switch.
		if (this.#view.turnsByItself) this.#turn.ariaPressed = `${element.hasAttribute("autorotate")}`;
		else this.#turn.ariaPressed = null;
		if (this.#shown) void this.#updateAppLink(this.#shown);
	}

	/** Removes the bar, which gives its height back to the picture. */
	dispose(): void {
		this.#ended.abort();
		const { root } = this.#host;
		this.#bar.remove();
		root.adoptedStyleSheets = root.adoptedStyleSheets.filter((sheet) => sheet !== this.#style);
		this.#view.resize();
	}

	/** Connects the controls to the document. The bar's own `input` and `change` events do not leave it. */
	#listen(): void {
		const { interaction } = this.#host;
		this.#turn.addEventListener("click", () => {
			if (this.#view.turnsByItself) this.#switchTurning();
			else this.#view.turnBy(TURN);
		});
		this.#age.addEventListener("input", () => {
			const age = this.#shown && ageOf(this.#shown.model, this.#shown.specimen);
			const { model } = this.#shown ?? {};
			if (!age || !model) return;
			interaction.edit((now) => withParameters(model, now, { [age.key]: this.#age.valueAsNumber }));
		});
		this.#age.addEventListener("change", () => this.#settle());
		this.#seed.addEventListener("change", () => {
			const { valueAsNumber: seed, validity } = this.#seed;
			if (!validity.valid || Number.isNaN(seed)) {
				this.#seed.value = `${this.#requestedSeed ?? this.#shown?.specimen.seed ?? ""}`;
				return;
			}
			this.#requestedSeed = seed;
			interaction.edit((now) => withSeed(now, seed));
			this.#settle();
		});
		this.#download.addEventListener("click", () => void this.#save());
		const { signal } = this.#ended;
		matchMedia("(prefers-reduced-motion: reduce)").addEventListener("change", () => this.follow(), { signal });
		// Pages get these events from the element alone.
		for (const type of ["input", "change"]) this.#bar.addEventListener(type, (event) => event.stopPropagation());
	}

	/** Switches automatic turning; switched on again, it has the same speed. */
	#switchTurning(): void {
		const { element } = this.#host;
		const speed = element.getAttribute("autorotate");
		if (speed === null) element.setAttribute("autorotate", this.#speed);
		else {
			this.#speed = speed;
			element.removeAttribute("autorotate");
		}
	}

	/** Ends a change by the bar's controls, whose plant is then announced. */
	#settle(): void {
		this.#touched = true;
		this.#host.interaction.settle();
	}

	/** Announces a text to screen readers; errors are visible, too, until the next plant or file. */
	#announce(words: string, seen?: "seen"): void {
		this.#status.textContent = words;
		this.#status.classList.toggle("unseen", !seen);
	}

	/** Sets the link that opens the plant in the app; hides it where there is no app. */
	async #updateAppLink({ model, specimen }: GrownDocument): Promise<void> {
		const app = appAddress(this.#host.element.getAttribute("app"));
		this.#app.hidden = app === undefined;
		const link = await encodeLink(model, specimen);
		if (app !== undefined) this.#app.href = `${app}${link}`;
	}

	/** Saves the plant as GLB; errors are shown in the bar. */
	async #save(): Promise<void> {
		this.#download.ariaBusy = "true";
		this.#announce("");
		try {
			const file = await this.#host.element.toFile("glb");
			const { preset, seed } = this.#shown?.specimen ?? { preset: "plant", seed: 1 };
			const anchor = document.createElement("a");
			anchor.href = URL.createObjectURL(file);
			anchor.download = `${preset}-${seed}.glb`;
			anchor.click();
			// By then the download has its own reference to the data.
			setTimeout(() => URL.revokeObjectURL(anchor.href), 60_000);
		} catch (error) {
			this.#announce(text("glb_failed", { problem: messageOf(error).text }), "seen");
		} finally {
			this.#download.ariaBusy = null;
		}
	}
}

/** Creates an input with its name for screen readers, and the part `control` for style sheets. */
function field(type: "range" | "number", label: string): HTMLInputElement {
	const input = Object.assign(document.createElement("input"), { type, ariaLabel: label, title: label });
	input.part.add("control");
	return input;
}

/** Creates a button with an icon. */
const button = (label: string, icon: keyof typeof DRAWINGS) =>
	withIcon(Object.assign(document.createElement("button"), { type: "button" }), label, icon);

/** Gives a control its icon, its name for screen readers and hints, and the part `control` for style sheets. */
function withIcon<E extends HTMLElement>(control: E, label: string, icon: keyof typeof DRAWINGS): E {
	const [svg, path] = ["svg", "path"].map((tag) => document.createElementNS("http://www.w3.org/2000/svg", tag));
	svg.setAttribute("viewBox", "0 0 20 20");
	svg.setAttribute("aria-hidden", "true");
	path.setAttribute("d", DRAWINGS[icon]);
	svg.append(path);
	control.append(svg);
	control.ariaLabel = label;
	control.title = label;
	control.part.add("control");
	return control;
}
