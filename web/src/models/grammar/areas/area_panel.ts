/**
 * Panel of growth areas: a list and numbers for everything that the pointer does in the view, for keyboards and screen
 * readers.
 */
import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { ACCEPT } from "../../../import/mesh_file/accept";
import type { Group } from "../../../specimen/table";
import { chooseFile } from "../../../ui/choose_file";
import type { Change } from "../../../ui/editor_context";
import type { Tool } from "../../../ui/tool";
import type { GrammarPlant } from "../grammar_plant";
import type { GrammarSpecimen } from "../specimen";
import { GRAMMAR_TABLE } from "../table";
import { fetchedText, usesAreas } from "../texts";
import { AREA_KINDS, type Area, type AreaKind, degreesOf, type Triple, turnOf } from "./area";
import {
	added,
	addedPlace,
	branchesOf,
	changed,
	movedPlace,
	placesOf,
	removed,
	removedPlace,
	reordered,
	withPath,
} from "./area_edits";
import { nameOf } from "./area_handles";
import { type AreaContext, type AreaState, areaTool, choose, hasAreas, takeAreaMesh } from "./area_tool";

/** Labels of the buttons; meshes have a button of their own. */
const WORDS: Readonly<Record<Exclude<AreaKind, "mesh">, string>> = {
	box: "Box",
	sphere: "Ball",
	ellipsoid: "Ellipsoid",
	cylinder: "Cylinder",
	cone: "Cone",
};

export function drawAreas(context: AreaContext): unknown {
	const { specimen } = context.state;
	const { areas = [] } = specimen;
	const { chosen } = context.toolState(areaTool);
	const area = chosen === undefined ? undefined : areas[chosen];
	return html`<ol class="areas" aria-label="Growth areas, in the order of the main branch">
			${areas.map(
				(each, i) => html`<li><button
					class="button" type="button" aria-pressed=${i === chosen} @click=${() => choose(context, i === chosen ? undefined : i)}
				>${nameOf(each, i)}</button></li>`,
			)}
		</ol>
		${area && chosen !== undefined ? drawArea(context, area, chosen) : nothing}
		<h3>One more area</h3>
		<div class="actions">
			${(Object.keys(WORDS) as (keyof typeof WORDS)[]).map((kind) =>
				button(WORDS[kind], added(specimen, kind), (change) => {
					context.set(change);
					choose(context, areas.length);
				}),
			)}
			${chooseFile({
				accept: ACCEPT,
				label: "A closed mesh as a growth area",
				words: "A closed mesh (OBJ, GLB, STL)…",
				take: (file) => void takeAreaMesh(context, file),
			})}
		</div>
		${areas.length > 0 ? drawPath(context) : nothing}`;
}

function drawArea(context: AreaContext, area: Area, index: number): unknown {
	const { specimen } = context.state;
	const put = (change: Partial<Area>) => context.set(changed(specimen, index, change));
	const degrees = degreesOf(area.rotation);
	return html`<div class="area" role="group" aria-label=${nameOf(area, index)}>
		${
			area.kind === "mesh"
				? nothing
				: html`<label>Kind <select @change=${(event: Event) => put({ kind: (event.target as HTMLSelectElement).value as AreaKind })}>
			${AREA_KINDS.filter((kind) => kind !== "mesh").map(
				(kind) =>
					html`<option value=${kind} ?selected=${kind === area.kind}>${WORDS[kind as keyof typeof WORDS]}</option>`,
			)}</select></label>`
		}
		${triple("Middle", ["x", "y", "z"], "m", 0.05, area.centre, (centre) => put({ centre }))}
		${triple("Size", ["width", "height", "depth"], "m", 0.05, area.size, (size) => put({ size: oneSize(area, size) }))}
		${triple("Turn", ["about x", "about y", "about z"], "°", 5, degrees, (turn) => put({ rotation: turnOf(turn) }))}
		<div class="actions">
			${button("Earlier", reordered(specimen, index, -1), (change) => {
				context.set(change);
				choose(context, index - 1);
			})}
			${button("Later", reordered(specimen, index, 1), (change) => {
				context.set(change);
				choose(context, index + 1);
			})}
			${button("Remove the area", removed(specimen, index), (change, pressed) => {
				const list = pressed.closest(".group-body");
				context.set(change);
				choose(context, undefined);
				// The button disappears with its area: focus the next area, or the button that adds one.
				setTimeout(() => {
					const left = list?.querySelectorAll<HTMLElement>(".areas button");
					const next = left?.[Math.min(index, left.length - 1)] ?? list?.querySelector<HTMLElement>(".actions button");
					next?.focus();
				});
			})}
		</div>
	</div>`;
}

/** Keeps a sphere's sizes equal: all follow the changed one. */
function oneSize({ kind, size }: Area, wanted: Triple): Triple {
	if (kind !== "sphere") return wanted;
	const width = wanted.find((value, k) => value !== size[k]) ?? size[0];
	return [width, width, width];
}

function triple(
	title: string,
	names: readonly string[],
	unit: string,
	step: number,
	values: Triple,
	put: (values: Triple) => void,
): unknown {
	const typed = (k: number) => (event: Event) => {
		const field = event.target as HTMLInputElement;
		const value = field.valueAsNumber;
		if (Number.isFinite(value)) put(values.map((each, i) => (i === k ? value : each)) as unknown as Triple);
		else field.value = String(values[k]);
	};
	return html`<fieldset class="triple"><legend>${title}, ${unit}</legend>${names.map(
		(name, k) =>
			html`<label>${name} <input type="number" step=${step} .value=${live(String(values[k]))} @change=${typed(k)}></label>`,
	)}</fieldset>`;
}

const DRAWING = {
	path: "Draw in the picture, from the foot upwards through the areas.",
	fork: "Draw in the picture, from a place of the main branch to the areas that the new branch passes.",
} as const;

function drawPath(context: AreaContext): unknown {
	const { specimen } = context.state;
	const state = context.toolState(areaTool);
	const places = placesOf(specimen);
	const forks = branchesOf(specimen).length - 1;
	const toggle = (words: string, on: boolean, change: Partial<AreaState>) => html`<button
		class="button" type="button" aria-pressed=${on}
		@click=${() => context.setToolState(areaTool, { ...state, handles: true, ...change })}
	>${words}</button>`;
	const draw = (words: string, drawing: "path" | "fork") =>
		toggle(words, state.drawing === drawing, { drawing: state.drawing === drawing ? undefined : drawing });
	return html`<h3>Main branch</h3>
		<p class="note">${
			specimen.path
				? `The main branch is drawn by hand. Places: ${places.length}. Forks: ${forks}.`
				: "The main branch leads from the middle of each area to the middle of the next."
		}</p>
		<div class="actions">
			${draw("Draw it in the picture", "path")} ${draw("Draw a fork in the picture", "fork")}
			${toggle("Show its places", state.path === true, { path: !state.path })}
			${button("From middle to middle", specimen.path ? withPath(undefined) : undefined, (change) => context.set(change))}
		</div>
		<p class="note" role="status">${state.drawing ? DRAWING[state.drawing] : nothing}</p>
		${
			state.path
				? places.map(
						(
							at,
							i,
						) => html`${triple(`Place ${i + 1}`, ["x", "y", "z"], "m", 0.05, at, (to) => context.set(movedPlace(specimen, i, to)))}
						<div class="actions">
							${button(`Add a place after place ${i + 1}`, addedPlace(specimen, i), (change) => context.set(change))}
							${button(`Remove place ${i + 1}`, places.length > 1 ? removedPlace(specimen, i) : undefined, (change) => context.set(change))}
						</div>`,
					)
				: nothing
		}`;
}

function button(words: string, change: Change | undefined, press: (change: Change, pressed: Element) => void): unknown {
	const click = (event: Event) => change && press(change, event.currentTarget as Element);
	return html`<button class="button" type="button" ?disabled=${!change} @click=${click}>${words}</button>`;
}

/** Group of the table, but open, since areas are edited most. */
const GROUP: Group = { ...(GRAMMAR_TABLE.groups.find(({ key }) => key === "areas") as Group), closed: false };

/** Panel section, also shown if a text uses areas and there are none; accepts dropped meshes. */
export const areaPanel: Tool<GrammarSpecimen, GrammarPlant> = {
	name: "area-panel",
	initial: undefined,
	applies: (specimen) => hasAreas(specimen) || usesAreas(fetchedText(specimen) ?? ""),
	panel: { group: GROUP, place: "below", draw: (context) => drawAreas(context) },
	drop: {
		words: "a closed mesh (OBJ, GLB, STL) becomes a growth area",
		takes: ({ name }) => /\.(obj|glb|gltf|stl|ply|off|fbx|dae|3mf|3ds|usdz?|blend)$/i.test(name),
		take: (context, file) => void takeAreaMesh(context, file),
	},
};
