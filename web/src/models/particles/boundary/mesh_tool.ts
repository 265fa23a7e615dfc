/** A closed mesh of one's own as the boundary: chosen in the panel or dropped on the page. */
import { html, nothing } from "lit";
import type { Desk } from "../../../controls/desk";
import { ACCEPT } from "../../../controls/mesh_file/accept";
import { sameDocument } from "../../../controls/same_document";
import { FILE_TOPIC, type Tool } from "../../../controls/tool";
import { sameMesh } from "../../../specimen/closed_mesh";
import { fromPreset } from "../../../specimen/from_preset";
import type { BoundedSpecimen } from "./bounded";
import { meshParameters } from "./mesh_boundary";
import type { WoodenPlant } from "./wooden_plant";

/** Files of meshes by their names: those that are not read are told which are. */
const MESHES = /\.(obj|glb|gltf|stl|ply|off|fbx|dae|3mf|3ds|usdz?|blend)$/i;

/** @param height the parameter that is the boundary's height */
export function meshTool<S extends BoundedSpecimen>(group: string, height: string): Tool<S, WoodenPlant> {
	return {
		name: "mesh",
		initial: undefined,
		applies: () => true,
		panel: { group, place: "below", draw: (desk) => draw(desk, height) },
		drop: {
			words: "a closed mesh (OBJ, GLB, STL) becomes the boundary",
			takes: ({ name }) => MESHES.test(name),
			take: (desk, file) => void takeMesh(desk, file, height),
		},
	};
}

function draw<S extends BoundedSpecimen>(desk: Desk<S, WoodenPlant>, height: string): unknown {
	const { specimen, model } = desk.state;
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
		<label class="button">${volume ? "Another mesh (OBJ, GLB, STL)…" : "Choose a mesh (OBJ, GLB, STL)…"}
			<input class="unseen" type="file" accept=${ACCEPT} @change=${(event: Event) => choose(event, desk, height)}>
		</label>
	</div>`;
}

function choose<S extends BoundedSpecimen>(event: Event, desk: Desk<S, WoodenPlant>, height: string): void {
	const input = event.target as HTMLInputElement;
	const file = input.files?.[0];
	if (file) void takeMesh(desk, file, height);
	// The same file may be chosen again.
	input.value = "";
}

/** Makes a file's mesh the boundary, as one step; whatever is wrong with it is said. */
export async function takeMesh<S extends BoundedSpecimen>(
	desk: Desk<S, WoodenPlant>,
	file: File,
	height: string,
): Promise<void> {
	const isStill = sameDocument(desk);
	const reader = await import("../../../controls/mesh_file/read").catch(() => undefined);
	if (!reader) {
		desk.notify(
			"The mesh was not read",
			["Part of the page could not be fetched; check the connection and try again."],
			{ topic: FILE_TOPIC },
		);
		return;
	}
	try {
		const volume = await reader.readMeshFile(file);
		if (!isStill()) {
			desk.notify("The mesh was not taken", ["Another plant has come meanwhile."], { topic: FILE_TOPIC });
			return;
		}
		const { model, specimen } = desk.state;
		desk.set({ parameters: meshParameters(model.table, volume, specimen.parameters[height]), details: { volume } });
		desk.notify(
			"The mesh is the boundary now",
			["Links are too short for it: download JSON or GLB to keep this plant, and drop the file to bring it back."],
			{ topic: FILE_TOPIC },
		);
	} catch (error) {
		desk.notify("The mesh was not read", [error instanceof Error ? error.message : String(error)], {
			topic: FILE_TOPIC,
		});
	}
}
