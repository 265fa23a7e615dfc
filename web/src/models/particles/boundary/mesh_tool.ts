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
import type { BoundedSpecimen } from "./bounded";
import { meshParameters } from "./mesh_boundary";
import type { WoodenPlant } from "./wooden_plant";

/** Names of mesh files, unsupported formats included: those get a message that lists the supported formats. */
const MESHES = /\.(obj|glb|gltf|stl|ply|off|fbx|dae|3mf|3ds|usdz?|blend)$/i;

/** @param height the key of the parameter for the boundary's height */
export function meshTool<S extends BoundedSpecimen>(group: string, height: string): Tool<S, WoodenPlant> {
	return {
		name: "mesh",
		initial: undefined,
		applies: () => true,
		panel: { group, place: "below", draw: (context) => html`${drawOuter(context, height)}${drawInner(context)}` },
		drop: {
			words: "a closed mesh (OBJ, GLB, STL) becomes the boundary",
			takes: ({ name }) => MESHES.test(name),
			take: (context, file) => void takeMesh(context, file, height),
		},
	};
}

/** A use of a mesh from a file. */
interface Taken {
	/** The message after the change: "The mesh is the boundary now". */
	readonly words: string;
	change(mesh: ClosedMesh): Change;
}

function outer<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, height: string): Taken {
	return {
		words: "The mesh is the boundary now",
		change: (volume) => {
			const { model, specimen } = context.state;
			return { parameters: meshParameters(model.table, volume, specimen.parameters[height]), details: { volume } };
		},
	};
}

/** Uses a mesh as the inner boundary, with the table's default size where the inner boundary was empty. */
function inner<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>): Taken {
	return {
		words: "The mesh is the inner boundary now",
		change: (hollow) => {
			const { model, specimen } = context.state;
			const entry = model.table.entry("inner");
			const bare = specimen.parameters.inner > 0 || entry?.kind !== "number" ? {} : { inner: entry.default || 0.75 };
			return { parameters: bare, details: { hollow } };
		},
	};
}

function drawOuter<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>, height: string): unknown {
	const { specimen, model } = context.state;
	if (model.table.option(specimen, "shape") !== "mesh") return nothing;
	const { volume } = specimen;
	const { volume: own } = fromPreset(model, specimen.preset);
	const carried = own ? "which shows the preset's in its place" : "which shows an ellipsoid in its place";
	const count = volume ? (volume.triangles.length / 3).toLocaleString("en") : "";
	const words = volume
		? sameMesh(volume, own)
			? `The preset's mesh of ${count} triangles.`
			: `A mesh of ${count} triangles. Files (JSON, GLB) carry it; it is too long for a link, ${carried}.`
		: "No mesh yet: choose a closed one, or drop it on the page. Until then an ellipsoid is grown.";
	return html`<div class="override">
		<p>${words}</p>
		${chooser(context, volume ? "Another mesh (OBJ, GLB, STL)…" : "Choose a mesh (OBJ, GLB, STL)…", outer(context, height))}
	</div>`;
}

function drawInner<S extends BoundedSpecimen>(context: EditorContext<S, WoodenPlant>): unknown {
	const { specimen, model } = context.state;
	const { hollow } = specimen;
	const { hollow: own } = fromPreset(model, specimen.preset);
	const count = hollow ? (hollow.triangles.length / 3).toLocaleString("en") : "";
	const words = hollow
		? `The inner boundary is a mesh of ${count} triangles, as large as “Bare inside” says. Files (JSON, GLB) carry it; it is too long for a link.`
		: "The inner boundary is the outer one made smaller.";
	const back = html`<button class="button" type="button" @click=${() => context.set({ details: { hollow: own } })}>
		Remove the inner mesh</button>`;
	return html`<div class="override">
		<p>${words}</p>
		${chooser(context, hollow ? "Another inner mesh (OBJ, GLB, STL)…" : "Inner mesh (OBJ, GLB, STL)…", inner(context))}
		${hollow && !sameMesh(hollow, own) ? back : nothing}
	</div>`;
}

function chooser<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	label: string,
	taken: Taken,
): unknown {
	return html`<label class="button">${label}
		<input class="unseen" type="file" accept=${ACCEPT} @change=${(event: Event) => choose(event, context, taken)}>
	</label>`;
}

function choose<S extends BoundedSpecimen>(event: Event, context: EditorContext<S, WoodenPlant>, taken: Taken): void {
	const input = event.target as HTMLInputElement;
	const file = input.files?.[0];
	if (file) void take(context, file, taken);
	// Lets the user choose the same file again.
	input.value = "";
}

/** Makes a file's mesh the outer boundary, as one undo step; reports problems with the file in a note. */
export const takeMesh = <S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	file: File,
	height: string,
) => take(context, file, outer(context, height));

async function take<S extends BoundedSpecimen>(
	context: EditorContext<S, WoodenPlant>,
	file: File,
	{ words, change }: Taken,
): Promise<void> {
	const isStill = sameDocument(context);
	const reader = await import("../../../import/mesh_file/read_in_worker").catch(() => undefined);
	if (!reader) {
		context.notify(
			"The mesh was not read",
			["Part of the page could not be fetched; check the connection and try again."],
			{ topic: FILE_TOPIC },
		);
		return;
	}
	try {
		const mesh = await reader.readMeshInWorker(file);
		if (!isStill()) {
			context.notify("The mesh was not taken", ["Another plant has come meanwhile."], { topic: FILE_TOPIC });
			return;
		}
		context.set(change(mesh));
		context.notify(
			words,
			["Links are too short for it: download JSON or GLB to keep this plant, and drop the file to bring it back."],
			{ topic: FILE_TOPIC },
		);
	} catch (error) {
		context.notify("The mesh was not read", [error instanceof Error ? error.message : String(error)], {
			topic: FILE_TOPIC,
		});
	}
}
