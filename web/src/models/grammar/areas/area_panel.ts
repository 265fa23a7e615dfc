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
import { text } from "../messages.generated";
import type { GrammarSpecimen } from "../specimen";
import { GRAMMAR_TABLE } from "../table";
import { fetchedText, usesAreas } from "../texts";
import { AREA_KINDS, type Area, type AreaKind, degreesOf, rotationOf, type Triple } from "./area";
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

/** Kinds that have a button of their own; meshes come from files. */
const SHAPES = AREA_KINDS.filter((kind) => kind !== "mesh");

/** Renders the list of areas, the chosen area's numbers, buttons that add areas, and the path. */
export function drawAreas(context: AreaContext): unknown {
	const { specimen } = context.state;
	const { areas = [] } = specimen;
	const { chosen } = context.toolState(areaTool);
	const area = chosen === undefined ? undefined : areas[chosen];
	return html`<ol class="areas" aria-label=${text("areas_list")}>
			${areas.map(
				(each, i) => html`<li><button
					class="button" type="button" aria-pressed=${i === chosen} @click=${() => choose(context, i === chosen ? undefined : i)}
				>${nameOf(each, i)}</button></li>`,
			)}
		</ol>
		${area && chosen !== undefined ? drawArea(context, area, chosen) : nothing}
		<h3>${text("area_add")}</h3>
		<div class="actions">
			${SHAPES.map((kind) =>
				button(text(`kind_${kind}`), added(specimen, kind), (change) => {
					context.set(change);
					choose(context, areas.length);
				}),
			)}
			${chooseFile({
				accept: ACCEPT,
				label: text("mesh_file"),
				caption: text("mesh_add"),
				take: (file) => void takeAreaMesh(context, file),
			})}
		</div>
		${areas.length > 0 ? drawPath(context) : nothing}`;
}

/** Draws the fields of one area: its kind, centre, size and rotation. */
function drawArea(context: AreaContext, area: Area, index: number): unknown {
	const { specimen } = context.state;
	const put = (change: Partial<Area>) => context.set(changed(specimen, index, change));
	const degrees = degreesOf(area.rotation);
	return html`<div class="area" role="group" aria-label=${nameOf(area, index)}>
		${
			area.kind === "mesh"
				? nothing
				: html`<label>${text("kind")} <select @change=${(event: Event) => put({ kind: (event.target as HTMLSelectElement).value as AreaKind })}>
			${SHAPES.map(
				(kind) => html`<option value=${kind} ?selected=${kind === area.kind}>${text(`kind_${kind}`)}</option>`,
			)}</select></label>`
		}
		${drawTriple(text("centre"), PLACE, 0.05, area.centre, (centre) => put({ centre }))}
		${drawTriple(text("size"), SIZES, 0.05, area.size, (size) => put({ size: sizeOfKind(area, size) }))}
		${drawTriple(text("rotation"), ANGLES, 5, degrees, (angles) => put({ rotation: rotationOf(angles) }))}
		<div class="actions">
			${button(text("move_earlier"), reordered(specimen, index, -1), (change) => {
				context.set(change);
				choose(context, index - 1);
			})}
			${button(text("move_later"), reordered(specimen, index, 1), (change) => {
				context.set(change);
				choose(context, index + 1);
			})}
			${button(text("area_remove"), removed(specimen, index), (change, pressed) => {
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

/**
 * Makes a sphere's three sizes equal to the one that was changed; returns the wanted sizes of other kinds.
 * @param wanted sizes after the change
 */
function sizeOfKind({ kind, size }: Area, wanted: Triple): Triple {
	if (kind !== "sphere") return wanted;
	const width = wanted.find((value, k) => value !== size[k]) ?? size[0];
	return [width, width, width];
}

const PLACE = ["x", "y", "z"] as const;
const SIZES = ["width", "height", "depth"] as const;
const ANGLES = ["about_x", "about_y", "about_z"] as const;

/**
 * Renders three number fields; a field whose text is no number returns to its value.
 * @param step amount of one press of an arrow key
 * @param put receives all three values after a change
 */
function drawTriple(
	title: string,
	names: typeof PLACE | typeof SIZES | typeof ANGLES,
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
	return html`<fieldset class="triple"><legend>${title}</legend>${names.map(
		(name, k) =>
			html`<label>${text(name)} <input type="number" step=${step} .value=${live(String(values[k]))} @change=${typed(k)}></label>`,
	)}</fieldset>`;
}

/** Draws the state of the main branch, and the buttons that draw its path and forks. */
function drawPath(context: AreaContext): unknown {
	const { specimen } = context.state;
	const state = context.toolState(areaTool);
	const places = placesOf(specimen);
	const forks = branchesOf(specimen).length - 1;
	const toggle = (label: string, on: boolean, change: Partial<AreaState>) => html`<button
		class="button" type="button" aria-pressed=${on}
		@click=${() => context.setToolState(areaTool, { ...state, handles: true, ...change })}
	>${label}</button>`;
	const draw = (label: string, drawing: "path" | "fork") =>
		toggle(label, state.drawing === drawing, { drawing: state.drawing === drawing ? undefined : drawing });
	return html`<h3>${text("main_branch")}</h3>
		<p class="note">${
			specimen.path ? text("main_branch_drawn", { points: places.length, forks }) : text("main_branch_straight")
		}</p>
		<div class="actions">
			${draw(text("draw_path"), "path")} ${draw(text("draw_fork"), "fork")}
			${toggle(text("show_points"), state.path === true, { path: !state.path })}
			${button(text("straight_path"), specimen.path ? withPath(undefined) : undefined, (change) => context.set(change))}
		</div>
		<p class="note" role="status">${state.drawing ? text(`drawing_${state.drawing}`) : nothing}</p>
		${
			state.path
				? places.map(
						(
							at,
							i,
						) => html`${drawTriple(text("point", { number: i + 1 }), PLACE, 0.05, at, (to) => context.set(movedPlace(specimen, i, to)))}
						<div class="actions">
							${button(text("point_add", { number: i + 1 }), addedPlace(specimen, i), (change) => context.set(change))}
							${button(text("point_remove", { number: i + 1 }), places.length > 1 ? removedPlace(specimen, i) : undefined, (change) => context.set(change))}
						</div>`,
					)
				: nothing
		}`;
}

/** Renders a button that applies a change; disabled where there is none. */
function button(label: string, change: Change | undefined, press: (change: Change, pressed: Element) => void): unknown {
	const click = (event: Event) => change && press(change, event.currentTarget as Element);
	return html`<button class="button" type="button" ?disabled=${!change} @click=${click}>${label}</button>`;
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
		get description() {
			return text("mesh_drop");
		},
		takes: ({ name }) => /\.(obj|glb|gltf|stl|ply|off|fbx|dae|3mf|3ds|usdz?|blend)$/i.test(name),
		take: (context, file) => void takeAreaMesh(context, file),
	},
};
