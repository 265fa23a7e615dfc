/** The map of a stand: positions of plants, and links that open a plant alone. */

import { html, nothing, svg } from "lit";
import { guard } from "lit/directives/guard.js";
import { live } from "lit/directives/live.js";
import { shortFloat } from "../../../formats/numbers";
import { formatNumber } from "../../../locale/format";
import type { EditorContext } from "../../../ui/editor_context";
import { PickPointer } from "../../../ui/pick_pointer";
import { takeFocus } from "../../../ui/take_focus";
import type { Tool } from "../../../ui/tool";
import { plantGroups, titlesOf, valuesOf } from "../members";
import { text } from "../messages.generated";
import type { StandSpecimen } from "../specimen";
import type { StandPlant } from "../stand_plant";
import { groundColour, kindColours } from "./map_colours";
import { kindShapes } from "./map_shapes";

/** Margin around the ground, as a share of its width: crowns reach over its edge. */
const MARGIN = 0.05;
/** Least radius of a plant on the map, as a share of the ground's width: its shape must be seen. */
const LEAST_RADIUS = 0.006;
/** Largest distance of a click from the plant that it chooses, as a share of the map's width. */
const NEAR = 0.04;

type StandContext = EditorContext<StandSpecimen, StandPlant>;
/** The chosen plant. */
type Chosen = number | undefined;

export const map: Tool<StandSpecimen, StandPlant, Chosen> = {
	name: "map",
	initial: undefined,
	chip: {
		get title() {
			return text("selected_plant");
		},
		draw: (context) => {
			const chosen = chosenIn(context);
			return context.state.grown && chosen !== undefined ? drawChip(context, context.state.grown, chosen) : nothing;
		},
	},
	editor: {
		get title() {
			return text("map");
		},
		draw: (context) => (context.state.grown ? drawMap(context, context.state.grown) : nothing),
	},
	keys: [
		{
			keys: ["Esc"],
			get description() {
				return text("clear_selection");
			},
		},
	],
	/** Selects a plant by a click; Escape clears the selection. */
	interaction: (view, context) => {
		const pointer = new PickPointer(view, {
			name: "picking-plant",
			at: (x, y) => view.pick(x, y),
			mark: (plant) => view.mark(plant ?? chosenIn(context)),
			take: (plant) => context.setToolState(map, plant),
		});
		pointer.enabled = true;
		const leave = (event: KeyboardEvent) => {
			if (event.key !== "Escape" || event.defaultPrevented || chosenIn(context) === undefined || !clearsChoice(event))
				return;
			event.preventDefault();
			context.setToolState(map, undefined);
		};
		window.addEventListener("keydown", leave);
		let before = chosenIn(context);
		return {
			update: () => {
				const chosen = chosenIn(context);
				view.mark(chosen);
				if (before !== undefined && chosen === undefined) takeFocus(view.canvas, ".stage-chip");
				before = chosen;
			},
			dispose: () => {
				window.removeEventListener("keydown", leave);
				pointer.dispose();
			},
		};
	},
};

/**
 * Returns whether Escape clears the choice: not in text fields except the plant's number, and not while a dialog is
 * open.
 */
function clearsChoice({ target }: KeyboardEvent): boolean {
	if (document.querySelector("dialog[open]")) return false;
	const field = (target as Partial<Element> | null)?.closest?.("input, select, textarea, [contenteditable]");
	return !field || field.closest(".stand-plant") !== null;
}

/** Returns the chosen plant; undefined where none is chosen or the stand has fewer plants now. */
function chosenIn(context: StandContext): Chosen {
	const chosen = context.toolState(map);
	return chosen !== undefined && chosen < (context.state.grown?.places.count ?? 0) ? chosen : undefined;
}

/** Draws the map of a stand: its ground, its plants by kind, and the chosen plant with a field for its number. */
function drawMap(context: StandContext, stand: StandPlant): unknown {
	const { width, depth } = stand.ground;
	const [wide, deep] = mapSize(stand);
	const titles = titlesOf(stand);
	const chosen = chosenIn(context);
	const colours = kindColours(stand);
	const shapes = kindShapes(stand);
	const { soil } = context.state.specimen.look;
	return html`<div class="stand-map">
		<svg viewBox=${`${-0.5 * wide} ${-0.5 * deep} ${wide} ${deep}`} aria-hidden="true"
			@click=${(event: MouseEvent) => context.setToolState(map, nearestPlant(stand, event))}
		>
			<rect fill=${groundColour(soil)} x=${-0.5 * width} y=${-0.5 * depth} width=${width} height=${depth}></rect>
			${guard([stand.places, colours.join()], () => drawPlants(stand, colours))}
			${chosen === undefined ? nothing : drawChosen(stand, chosen)}
		</svg>
		<label class="stand-plant">${text("plant")}
			<input type="number" min="1" max=${stand.places.count} .value=${live(chosen === undefined ? "" : String(chosen + 1))}
				@change=${({ target }: Event) => chooseByNumber(context, stand, Number((target as HTMLInputElement).value))}>
		</label>
		<div aria-live="polite">${chosen === undefined ? html`<p>${text("select_plant")}</p>` : describePlant(stand, titles, chosen)}</div>
		<ul class="stand-kinds">
			${plantGroups(stand).map(
				({
					title,
					kind,
					count,
				}) => html`<li><svg viewBox="0 0 10 10" aria-hidden="true"><path d=${shapes[kind](5, 5, 4)} fill=${colours[kind]}></path></svg>${title}
					<small>${formatNumber(count)}</small></li>`,
			)}
		</ul>
	</div>`;
}

/** Returns the size of the area on the map with its margin, metres. */
function mapSize({ ground: { width, depth } }: StandPlant): readonly [wide: number, deep: number] {
	return [width + 2 * MARGIN * width, depth + 2 * MARGIN * width];
}

/**
 * Draws one path per kind, because thousands of shapes would be as many elements; the tallest kind last, as seen from
 * above.
 */
function drawPlants(stand: StandPlant, colours: readonly string[]): unknown {
	const { kinds, places, ground } = stand;
	const shapes = kindShapes(stand);
	const least = LEAST_RADIUS * ground.width;
	const order = [...kinds.keys()].sort((one, other) => kinds[one].crown.height - kinds[other].crown.height);
	return order.map((kind) => {
		const { crown } = kinds[kind];
		const paths: string[] = [];
		for (let plant = 0; plant < places.count; plant++) {
			if (places.kind[plant] !== kind) continue;
			// Attached plants have no crown of their own.
			const isAttached = places.parent[plant] >= 0;
			const radius = isAttached ? least : Math.max(0.35 * crown.width * places.scale[plant], least);
			paths.push(shapes[kind](places.at[3 * plant], places.at[3 * plant + 2], radius));
		}
		return svg`<path d=${paths.join("")} fill=${colours[kind]} fill-opacity="0.9"></path>`;
	});
}

/** Draws a circle around the chosen plant. */
function drawChosen({ kinds, places, ground }: StandPlant, plant: number): unknown {
	const r = Math.max(0.6 * kinds[places.kind[plant]].crown.width * places.scale[plant], 0.02 * ground.width);
	return svg`<circle class="stand-chosen" cx=${places.at[3 * plant]} cy=${places.at[3 * plant + 2]} r=${r}></circle>`;
}

/** Returns the plant nearest to a click on the map; undefined if none is near. */
function nearestPlant(stand: StandPlant, { currentTarget, clientX, clientY }: MouseEvent): Chosen {
	const box = (currentTarget as SVGSVGElement).getBoundingClientRect();
	const { places, ground } = stand;
	const [wide, deep] = mapSize(stand);
	const scale = Math.max(wide / box.width, deep / box.height);
	const x = (clientX - box.left - 0.5 * box.width) * scale;
	const z = (clientY - box.top - 0.5 * box.height) * scale;
	let nearestDistance = NEAR * ground.width;
	let found: Chosen;
	for (let plant = 0; plant < places.count; plant++) {
		const distance = Math.hypot(places.at[3 * plant] - x, places.at[3 * plant + 2] - z);
		if (distance >= nearestDistance) continue;
		nearestDistance = distance;
		found = plant;
	}
	return found;
}

/** Chooses the plant of a number, counted from 1; none where there is no such plant. */
function chooseByNumber(context: StandContext, { places }: StandPlant, number: number): void {
	const fits = Number.isInteger(number) && number >= 1 && number <= places.count;
	context.setToolState(map, fits ? number - 1 : undefined);
}

/** Formats a number with a fixed number of decimals. */
const formatFixed = (value: number, digits: number): string =>
	formatNumber(value, { minimumFractionDigits: digits, maximumFractionDigits: digits });

/** Describes a plant, with the link that opens it alone. */
function describePlant(stand: StandPlant, titles: readonly string[], plant: number): unknown {
	const { places } = stand;
	const [x, , z] = places.at.subarray(3 * plant, 3 * plant + 3);
	const values = Object.entries(valuesOf(stand, plant)).map(
		([key, value]) => `${key} ${typeof value === "number" ? shortFloat(Number(value.toPrecision(3))) : value}`,
	);
	const summary = text("plant_summary", {
		seed: String(places.seed[plant]),
		x: formatFixed(x, 1),
		z: formatFixed(z, 1),
		scale: formatFixed(places.scale[plant], 2),
	});
	const link = linkOf(stand, plant);
	return html`<p>${text("plant_title", { number: plant + 1, title: titles[places.kind[plant]] })}</p>
		${link === undefined ? nothing : html`<p><a class="button" href=${link}>${text("open_plant")}</a></p>`}
		<p><small>${[summary, ...values].join(", ")}.</small></p>`;
}

/** Returns the link that opens a plant alone; undefined before the plant has grown. */
const linkOf = ({ members, memberOf }: StandPlant, plant: number): string | undefined => members[memberOf[plant]]?.link;

/**
 * Renders a short description of the chosen plant over the picture, with its link and a button that clears the choice.
 */
function drawChip(context: StandContext, stand: StandPlant, plant: number): unknown {
	const link = linkOf(stand, plant);
	return html`<span>${titlesOf(stand)[stand.places.kind[plant]]}</span>
		${link === undefined ? nothing : html`<a class="button" href=${link}>${text("open_plant")}</a>`}
		<button class="button icon quiet" type="button" aria-label=${text("clear_selection")} title=${text("clear_selection")} @click=${() => context.setToolState(map, undefined)}
		><span aria-hidden="true">×</span></button>`;
}
