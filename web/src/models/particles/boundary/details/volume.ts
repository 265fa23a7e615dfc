/** A closed mesh of one's own as the boundary. Files carry it; it is too long for a link. */
import { type Notes, quote } from "../../../../specimen/notes";
import { isRecord, readNumbers } from "../../../../specimen/read_values";
import type { Detail } from "../../../../specimen/species";
import type { Table } from "../../../../specimen/table";
import type { BoundedSpecimen, ClosedMesh } from "../bounded";

/** What mesh_file/closed.ts leaves at the most. */
export const MOST_TRIANGLES = 4000;

const keep = (instead: string) =>
	`It is too short for the mesh, in whose place it brings ${instead}: download JSON or GLB to keep the mesh, and drop the file to bring it back.`;
const MISSING = "links are too short for one, so an ellipsoid stands in its place until a file with it is dropped";

/** @param table where the shape is chosen */
export function volumeOf<S extends BoundedSpecimen>(table: Table): Detail<S> {
	const shows = (specimen: S) => table.option(specimen, "shape") === "mesh";
	return {
		keys: ["volume"],
		where: { shape: "mesh" },
		read: (specimen, key, value, notes) => {
			const read = readVolume(key, value, notes);
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

/** Whether two meshes are the same, number by number. */
export function sameMesh(one: ClosedMesh, other: ClosedMesh | undefined): boolean {
	const same = (a: number[], b: number[]) => a.length === b.length && a.every((value, i) => value === b[i]);
	return other !== undefined && same(one.points, other.points) && same(one.triangles, other.triangles);
}

function readVolume(key: string, value: unknown, notes: Notes): ClosedMesh | undefined {
	const [points, triangles] = isRecord(value) ? [readNumbers(value.points), readNumbers(value.triangles)] : [];
	const corners = (points?.length ?? 0) / 3;
	const sound =
		points?.every(Number.isFinite) &&
		points.length % 3 === 0 &&
		triangles?.every((index) => Number.isInteger(index) && index >= 0 && index < corners) &&
		triangles.length > 0 &&
		triangles.length % 3 === 0 &&
		triangles.length <= 3 * MOST_TRIANGLES;
	if (sound && points && triangles) return { points, triangles };
	notes.add(key, `${quote(value)} is not a mesh of at most ${MOST_TRIANGLES} triangles`, "it is left out");
	return undefined;
}
