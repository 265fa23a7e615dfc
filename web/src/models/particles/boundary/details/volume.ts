/** Fields with closed meshes for the outer and the inner boundary. Files carry the meshes; links are too short. */

import { readClosedMesh, sameMesh } from "../../../../specimen/closed_mesh";
import type { Field } from "../../../../specimen/model_schema";
import type { Table } from "../../../../specimen/table";
import { text } from "../../messages.generated";
import type { BoundedSpecimen } from "../bounded";

/**
 * Creates the field with the mesh of the outer boundary.
 * @param table has the parameter `shape`
 */
export function volumeOf<S extends BoundedSpecimen>(table: Table): Field<S> {
	const shows = (specimen: S) => table.option(specimen, "shape") === "mesh";
	return {
		keys: ["volume"],
		where: { shape: "mesh" },
		read: (specimen, key, value, notes) => {
			const read = readClosedMesh(key, value, notes);
			if (read) specimen.volume = read;
		},
		unlinked: {
			keep: (specimen, preset) =>
				shows(specimen) && specimen.volume && !sameMesh(specimen.volume, preset.volume)
					? text("link_without_mesh", { instead: preset.volume ? "preset" : "ellipsoid" })
					: undefined,
			missing: (specimen, notes) => {
				if (shows(specimen) && !specimen.volume)
					notes.add("mesh", text.message("mesh_missing"), text("ellipsoid_used"));
			},
		},
	};
}

/** Creates the field with the mesh of the inner boundary. */
export function hollowOf<S extends BoundedSpecimen>(): Field<S> {
	return {
		keys: ["hollow"],
		read: (specimen, key, value, notes) => {
			const read = readClosedMesh(key, value, notes);
			if (read) specimen.hollow = read;
		},
		unlinked: {
			keep: (specimen, preset) =>
				specimen.hollow && !sameMesh(specimen.hollow, preset.hollow)
					? text("link_without_inner_mesh", { instead: preset.hollow ? "preset" : "outer" })
					: undefined,
			missing: () => {},
		},
	};
}
