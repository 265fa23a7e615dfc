/** Reads a closed mesh from a user's file. */
import type { ClosedMesh } from "../../specimen/closed_mesh";
import { text } from "../messages.generated";
import { closedMesh } from "./closed";
import { readGlb } from "./glb";
import { readObj } from "./obj";
import { MeshFileError, type Soup } from "./soup";
import { readStl } from "./stl";

/** Largest file size, bytes. */
const LARGEST = 64 * 1024 * 1024;

const READERS: Readonly<Record<string, (file: File) => Promise<Soup>>> = {
	glb: async (file) => readGlb(await file.arrayBuffer()),
	obj: async (file) => readObj(await file.text()),
	stl: async (file) => readStl(await file.arrayBuffer()),
};

/**
 * Reads a closed mesh from a GLB, OBJ or STL file, by the ending of its name.
 * @throws MeshFileError with the reason in plain words
 */
export async function readMeshFile(file: File): Promise<ClosedMesh> {
	if (file.size > LARGEST)
		throw new MeshFileError(text.message("mesh_file_too_large", { name: file.name, most: LARGEST / 1024 ** 2 }));
	const [, ending] = /\.([a-z]+)$/.exec(file.name.toLowerCase()) ?? [];
	const reader = Object.hasOwn(READERS, ending ?? "") ? READERS[ending] : undefined;
	if (!reader) throw new MeshFileError(text.message("mesh_file_of_another_kind", { name: file.name }));
	return closedMesh(await reader(file));
}
