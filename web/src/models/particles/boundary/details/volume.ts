/** Fields with closed meshes for the outer and the inner boundary. Files carry the meshes; links are too short. */
import { readClosedMesh, sameMesh } from "../../../../specimen/closed_mesh";
import type { Field } from "../../../../specimen/model_schema";
import type { Table } from "../../../../specimen/table";
import type { BoundedSpecimen } from "../bounded";

const keep = (instead: string) =>
	`It is too short for the mesh, in whose place it brings ${instead}: download JSON or GLB to keep the mesh, and drop the file to bring it back.`;
const MISSING = "links are too short for one, so an ellipsoid stands in its place until a file with it is dropped";

/**
 * The mesh of the outer boundary.
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
					? keep(preset.volume ? "the preset's" : "an ellipsoid")
					: undefined,
			missing: (specimen, notes) => {
				if (shows(specimen) && !specimen.volume) notes.add("mesh", "none came along", MISSING);
			},
		},
	};
}

const keepHollow = (instead: string) =>
	`It is too short for the inner boundary's mesh, in whose place it brings ${instead}: download JSON or GLB to keep the mesh.`;

/** The mesh of the inner boundary. */
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
					? keepHollow(preset.hollow ? "the preset's" : "the outer one made smaller")
					: undefined,
			missing: () => {},
		},
	};
}
