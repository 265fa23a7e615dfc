/**
 * Closed meshes from files as boundaries: the outer one is chosen in the panel or dropped on the page, the inner one
 * is chosen.
 */

import { html, nothing } from "lit";
import { ACCEPT } from "../../../import/mesh_file/accept";
import { type ClosedMesh, sameMesh } from "../../../specimen/closed_mesh";
import { fromPreset } from "../../../specimen/from_preset";
import type { Change, EditorContext } from "../../../ui/editor_context";
import { sameDocument } from "../../../ui/same_document";
import { FILE_TOPIC, type Tool } from "../../../ui/tool";
import { text } from "../messages.generated";
import type { BoundedSpecimen } from "./bounded";
import { meshParameters } from "./mesh_boundary";
import type { WoodenPlant } from "./wooden_plant";

/** Names of mesh files, unsupported formats included: those get a message that lists the supported formats. */
const MESHES = /\.(obj|glb|gltf|stl|ply|off|fbx|dae|3mf|3ds|usdz?|blend)$/i;

/**
 * Creates the tool.
 * @param height the key of the parameter for the boundary's height
 */
export function meshTool<S extends BoundedSpecimen>(group: string, height: string): Tool<S, WoodenPlant> {
	return {
		name: "mesh",
		initial: undefined,
		applies: () => true,
		panel: { group, place: "below", draw: (context) => html`${drawOuter(context, height)}${drawInner(context)}` },
		drop: {
			get description() {
				return text("mesh_drop");
			},
			takes: ({ name }) => MESHES.test(name),
			take: (context, file) => void takeMesh(context, file, height),
		},
	};
}

/** A use of a mesh from a file. */
interface Taken {
	/** The message after the change. */
	readonly done: "mesh_is_boundary" | "mesh_is_inner_boundary";
	change(mesh: ClosedMesh): Change;
}

/** Returns the use of a mesh as the outer boundary. */
function asOuterBoundary<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, height: string): Taken {
	return {
		done: "mesh_is_boundary",
		change: (volume) => {
			const { model, specimen } = context.state;
			return { parameters: meshParameters(model.table, volume, specimen.parameters[height]), details: { volume } };
		},
	};
}

/**
 * Returns the use of a mesh as the inner boundary, with the table's default size where the inner boundary was empty.
 */
function asInnerBoundary<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>): Taken {
	return {
		done: "mesh_is_inner_boundary",
		change: (hollow) => {
			const { model, specimen } = context.state;
			const entry = model.table.entry("inner");
			const bare = specimen.parameters.inner > 0 || entry?.kind !== "number" ? {} : { inner: entry.default || 0.75 };
			return { parameters: bare, details: { hollow } };
		},
	};
}

/** Renders the state and the choice of the outer mesh, for specimens whose shape is a mesh. */
function drawOuter<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, height: string): unknown {
	const { specimen, model } = context.state;
	if (model.table.option(specimen, "shape") !== "mesh") return nothing;
	const { volume } = specimen;
	const { volume: own } = fromPreset(model, specimen.preset);
	const count = volume ? volume.triangles.length / 3 : 0;
	const state = volume
		? sameMesh(volume, own)
			? text("mesh_of_preset", { count })
			: text("mesh_own", { count, instead: own ? "preset" : "ellipsoid" })
		: text("mesh_none");
	return html`<div class="override">
		<p>${state}</p>
		${drawFileButton(context, text(volume ? "mesh_replace" : "mesh_choose"), asOuterBoundary(context, height))}
	</div>`;
}

/**
 * Renders the state and the choice of the inner mesh; without one, the inner boundary is a smaller copy of the outer
 * one.
 */
function drawInner<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>): unknown {
	const { specimen, model } = context.state;
	const { hollow } = specimen;
	const { hollow: own } = fromPreset(model, specimen.preset);
	const parameter = model.table.entry("inner")?.label ?? "";
	const state = hollow ? text("inner_mesh", { count: hollow.triangles.length / 3, parameter }) : text("inner_copy");
	const back = html`<button class="button" type="button" @click=${() => context.set({ details: { hollow: own } })}>
		${text("inner_remove")}</button>`;
	return html`<div class="override">
		<p>${state}</p>
		${drawFileButton(context, text(hollow ? "inner_replace" : "inner_choose"), asInnerBoundary(context))}
		${hollow && !sameMesh(hollow, own) ? back : nothing}
	</div>`;
}

/** Renders a button that opens the choice of a mesh file. */
function drawFileButton<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	label: string,
	taken: Taken,
): unknown {
	return html`<label class="button">${label}
		<input class="unseen" type="file" accept=${ACCEPT} @change=${(event: Event) => useChosenFile(event, context, taken)}>
	</label>`;
}

/** Uses the mesh of the chosen file. */
function useChosenFile<S extends BoundedSpecimen>(
	event: Event,
	context: EditorContext<S, WoodenPlant>,
	taken: Taken,
): void {
	const input = event.target as HTMLInputElement;
	const file = input.files?.[0];
	if (file) void takeMeshFile(context, file, taken);
	// Lets the user choose the same file again.
	input.value = "";
}

/** Makes a file's mesh the outer boundary, as one undo step; reports problems with the file in a note. */
export const takeMesh = <S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	file: File,
	height: string,
) => takeMeshFile(context, file, asOuterBoundary(context, height));

/** Reads a mesh file and uses its mesh, unless the plant has changed meanwhile; reports errors. */
async function takeMeshFile<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	file: File,
	{ done, change }: Taken,
): Promise<void> {
	const isStill = sameDocument(context);
	const reader = await import("../../../import/mesh_file/read_in_worker").catch(() => undefined);
	if (!reader) {
		context.notify(text("mesh_unreadable"), [text("load_failed")], { topic: FILE_TOPIC });
		return;
	}
	try {
		const mesh = await reader.readMeshInWorker(file);
		if (!isStill()) {
			context.notify(text("mesh_unused"), [text("plant_changed")], { topic: FILE_TOPIC });
			return;
		}
		context.set(change(mesh));
		context.notify(text(done), [text("mesh_too_big")], { topic: FILE_TOPIC });
	} catch (error) {
		context.notify(text("mesh_unreadable"), [error instanceof Error ? error.message : String(error)], {
			topic: FILE_TOPIC,
		});
	}
}
